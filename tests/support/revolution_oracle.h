// Slow, independent ways to intersect a ray with a turned Bezier profile; nothing here is shared with src/shapes.
#pragma once

#include "core/ray.h"

#include <vector>

namespace vitrine::test {

using ProfilePoints = std::vector<std::vector<V2d>>; ///< control points of each segment

struct OracleHit {
    double s; ///< in units of the ray's direction, any sign
    int segment;
    double t;
};

/// In 50 decimal digits: the polynomial of degree 2n in the power basis; its roots between the roots of its derivative,
/// those between the roots of the second derivative, and so on. Every change of sign in (0,1], ascending in s.
/// \param shift added to every radius and height: the surface a little larger or higher
std::vector<OracleHit> exactHits(const ProfilePoints& profile, const Ray& ray, const V2d& shift = {0, 0});

/// In long double, without squaring: both halves of the ray's hyperbola are scanned over a dense table of the profile,
/// with a search for the least distance wherever the table suggests one.
class ScanOracle {
  public:
    explicit ScanOracle(const ProfilePoints& profile, int samplesPerSegment = 300);
    std::vector<OracleHit> hits(const Ray& ray) const;

  private:
    struct Sample {
        long double x, y;
    };
    struct Scan;
    Sample at(int segment, long double t) const;

    std::vector<std::vector<Sample>> points_; ///< control points
    std::vector<std::vector<Sample>> table_;
    int samples_;
};

/// Distance in the half-plane between the ray's point at s and the profile's point at t, in long double.
double residual(const ProfilePoints& profile, const Ray& ray, double s, int segment, double t);

/// Whether the number of crossings is in doubt: it changes when the surface moves by `band` in radius or
/// height, or the ray sideways.
bool isNearlyTangent(const ProfilePoints& profile, const Ray& ray, double band);

} // namespace vitrine::test
