// The relative mean squared error that every part of the program speaks of.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace vitrine {

/// Squared error relative to the reference b, per channel: e^2 / (b^2 + 0.01). The constant keeps black pixels finite.
inline double relativeSquare(double squaredError, double reference) {
    return squaredError / (reference * reference + 0.01);
}

/// The numbers of the values that stay when the 0.1 % largest are dropped (a thousandth of the count, rounded down; of
/// equal values the later ones), in ascending order.
std::vector<std::size_t> withoutLargest(std::span<const double> values);

} // namespace vitrine
