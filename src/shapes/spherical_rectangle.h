// Uniform directions to a rectangle (Urena, Fajardo & King 2013, "An area-preserving parametrization for spherical
// rectangles").
#pragma once

#include "core/vec.h"

namespace vitrine {

/// A rectangle seen from a point.
class SphericalRectangle {
  public:
    /// \param corner,ex,ey the rectangle corner + a ex + b ey, 0 <= a, b <= 1, ex and ey at right angles
    SphericalRectangle(const V3d& from, const V3d& corner, const V3d& ex, const V3d& ey);

    /// At most 2 pi; 0 in the rectangle's plane.
    double solidAngle() const { return solidAngle_; }
    /// (a, b) of a point of the rectangle, uniform in solid angle.
    V2d sample(const V2f& u) const;

  private:
    double x0_, x1_, y0_, y1_, z0_; ///< the rectangle in the frame of its edges about `from`, z0 <= 0
    double b0_, b1_;                ///< z of the normals of the planes through `from` and the edges along x
    double angleSum_;               ///< g2 + g3 of the paper
    double solidAngle_ = 0;
};

} // namespace vitrine
