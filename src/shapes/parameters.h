// Checks and small parts that the parametric shapes share.
#pragma once

#include "core/vec.h"

#include <fmt/format.h>

#include <stdexcept>

namespace vitrine {

/// `value`. \throws std::invalid_argument
inline double requireFinite(const char* name, double value) {
    if (!std::isfinite(value)) throw std::invalid_argument(fmt::format("\"{}\" is {}, must be finite", name, value));
    return value;
}

/// `value`. \throws std::invalid_argument
inline double requirePositive(const char* name, double value) {
    if (!(requireFinite(name, value) > 0))
        throw std::invalid_argument(fmt::format("\"{}\" is {}, must be positive", name, value));
    return value;
}

/// \throws std::invalid_argument unless low < high, both finite
inline void requireRange(const char* lowName, double low, const char* highName, double high) {
    if (!(requireFinite(lowName, low) < requireFinite(highName, high)))
        throw std::invalid_argument(
            fmt::format("\"{}\" is {}, must be less than \"{}\", which is {}", lowName, low, highName, high));
}

/// The part [0, phimax] of the circle about the z axis that a shape covers.
class PhiRange {
  public:
    /// \param phiMaxDegrees above 360 counts as 360, as in pbrt
    /// \throws std::invalid_argument unless positive and finite
    explicit PhiRange(double phiMaxDegrees) {
        requirePositive("phimax", phiMaxDegrees);
        isFull_ = phiMaxDegrees >= 360;
        max_ = isFull_ ? 2 * piD : radians(phiMaxDegrees);
        end_ = V2d(std::cos(max_), std::sin(max_));
    }

    bool isFull() const { return isFull_; }
    /// In radians.
    double max() const { return max_; }
    bool contains(double x, double y) const {
        if (isFull_) return true;
        const bool beforeEnd = end_.x * y - end_.y * x <= 0; // clockwise of the end, by less than half a turn
        return max_ <= piD ? y >= 0 && beforeEnd : y >= 0 || beforeEnd;
    }
    /// phi / phimax of the point (x, y), in [0, 1].
    double u(double x, double y) const {
        double phi = std::atan2(y, x);
        if (phi < 0) phi += 2 * piD;
        return std::min(phi / max_, 1.);
    }

  private:
    double max_;
    V2d end_; ///< the unit vector at phimax
    bool isFull_;
};

} // namespace vitrine
