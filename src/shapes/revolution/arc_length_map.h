// From a profile's parameter to the part of its length that lies before it.
#pragma once

#include "shapes/revolution/profile.h"

#include <vector>

namespace vitrine {

/// Cubic pieces that have the true length and speed at their ends, narrow enough for an error of 1e-8 of the whole
/// length; a look-up is a binary search.
class ArcLengthMap {
  public:
    explicit ArcLengthMap(const Profile& profile);

    double total() const { return total_; }
    /// Length up to v over the total, for v in [0,1].
    double fraction(double v) const;

    std::size_t memoryBytes() const { return cells_.size() * sizeof(Cell); }

  private:
    static constexpr int maxHalvings = 24; ///< of a stretch; next to a stop or a cusp each quarters the error
    /// Of one segment between extremes of its speed.
    struct Stretch {
        const BezierCurve& curve;
        double segment, segments; ///< its number, and how many there are
        double tolerance;
    };
    void append(const Stretch& stretch, double t0, double t1, int depth);

    struct Cell {
        double v0, v1;
        double length0, length1; ///< up to the ends
        double slope0, slope1;   ///< length per v there, from inside
    };
    std::vector<Cell> cells_;
    double total_ = 0;
};

} // namespace vitrine
