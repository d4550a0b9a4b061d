// Sums that do not depend on the order of adding.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace vitrine {

/// Sums in 64-bit fixed point of resolution 2^-30: adding is associative, so pictures are the same for any grouping of
/// samples into threads, passes or machines. Sums saturate at +-2^33 and say so (Film::badSamples).
class FixedSum {
  public:
    static constexpr double scale = double(1 << 30);

    /// Adds x, rounded to the nearest multiple of the resolution; returns false if the sum saturated (or x is not
    /// finite, then nothing is added).
    bool add(double x) {
        if (!std::isfinite(x)) return false;
        const double scaled = x * scale;
        if (std::abs(scaled) < 0x1p63) return add(fromRaw(std::llrint(scaled)));
        sum_ = scaled < 0 ? lowest : highest;
        return false;
    }
    bool add(const FixedSum& other) {
        if (!__builtin_add_overflow(sum_, other.sum_, &sum_)) return true;
        sum_ = other.sum_ < 0 ? lowest : highest;
        return false;
    }
    double value() const { return double(sum_) / scale; }
    std::int64_t raw() const { return sum_; }
    static FixedSum fromRaw(std::int64_t raw) {
        FixedSum s;
        s.sum_ = raw;
        return s;
    }

  private:
    static constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min();
    static constexpr std::int64_t highest = std::numeric_limits<std::int64_t>::max();

    std::int64_t sum_ = 0;
};

} // namespace vitrine
