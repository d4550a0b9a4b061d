// What the oracles of turned Bezier profiles share: slow and plain, in long double; nothing here is shared with
// src/shapes.
#pragma once

#include "core/ray.h"

#include <vector>

namespace vitrine::test {

using ProfilePoints = std::vector<std::vector<V2d>>; ///< control points of each segment

/// Largest absolute coordinate of a control point.
double sizeOf(const ProfilePoints& profile);

struct OracleHit {
    double s; ///< in units of the ray's direction, any sign
    int segment;
    double t;
    bool forward; ///< beyond the ray's closest approach to the axis
};

/// One segment. Values by the scheme of Farin's `hornbez`, O(n).
class SlowCurve {
  public:
    struct Sample {
        long double x, y, dx, dy;
    };
    explicit SlowCurve(const std::vector<V2d>& points);

    int degree() const { return int(x_.size()) - 1; }
    /// Exact at t = 0 and t = 1.
    Sample at(long double t) const;

  private:
    std::vector<long double> x_, y_, dx_, dy_; ///< times the binomials
};

/// The ray in the half-plane of radius and height: r = sqrt(e^2 + g^2), g = q + h l, y = oy + v l.
struct HalfPlaneRay {
    long double length, ux, uz, h, v, q, e, oy;

    explicit HalfPlaneRay(const Ray& ray);
    /// h (y - oy) + v q: the height over the point of closest approach, times h.
    long double rise(long double y) const { return h * (y - oy) + v * q; }
    /// sqrt(x^2 - e^2), zero nearer to the axis.
    long double width(long double x) const { return std::sqrt(std::max(0.L, (x - e) * (x + e))); }
    /// The way along the ray to radius x and height y, by the better conditioned of the two.
    long double lengthAt(long double x, long double y, bool forward) const;
};

/// Distance of the point (r, y) from the curve near t: from its tangent, or from its point where it has none.
long double distanceFromCurve(const SlowCurve& curve, double t, long double r, long double y);

} // namespace vitrine::test
