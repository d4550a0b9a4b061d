// Where a shape that is solved in object space lies in the world, and what rounding does to points on the way.
#pragma once

#include "shapes/shape.h"

namespace vitrine {

/// A unit direction w that leaves a surface may, by the rounding of single-precision normals and dot products, have
/// this much slope to the surface's other side.
inline constexpr double grazingSlope = 5e-7;

/// A point with its differential geometry in object space; n is the unit normal along dpdu x dpdv.
struct ObjectPoint {
    V3d p, n;
    V2d uv;
    V3d dpdu{0, 0, 0}, dpdv{0, 0, 0};
    V3d dndu{0, 0, 0}, dndv{0, 0, 0};
};

/// worldFromObject with everything derived from it once.
class Placement {
  public:
    /// \param reach bound of the absolute coordinates of the surface in object space
    /// \throws std::invalid_argument when the map is not finite or not invertible
    Placement(const Transform& worldFromObject, bool reverseOrientation, double reach);

    /// For the shapes that pbrt has not: their normals point out of the solid however it is placed, mirrored or not, and
    /// only `reverseOrientation` turns them round. \throws as the constructor
    static Placement solid(const Transform& worldFromObject, bool reverseOrientation, double reach) {
        return Placement(worldFromObject, reverseOrientation != worldFromObject.swapsHandedness(), reach);
    }

    const Transform& worldFromObject() const { return worldFromObject_; }
    const Transform& objectFromWorld() const { return objectFromWorld_; }
    Ray toObject(const Ray& ray) const { return objectFromWorld_.ray(ray); }

    /// Whether ng is the transformed normal's opposite: reversed or mirrored, but not both (as in pbrt).
    bool flips() const { return flips_; }
    /// Whether lengths all scale by scale(), as far as a matrix written in single precision can say.
    bool isSimilarity() const { return isSimilarity_; }
    /// Cube root of the volume's scale.
    double scale() const { return scale_; }
    /// Bounds of the factors by which lengths grow; at most sqrt(3) wide of the mark.
    double maxStretch() const { return maxStretch_; }
    double minStretch() const { return minStretch_; }
    /// World area per object area where the unit object normal is n.
    double areaStretch(const V3d& n) const { return volumeScale_ * normalLength(n); }
    /// Object length along the normal per world length along the normal, where the unit object normal is n.
    double normalLength(const V3d& n) const { return worldFromObject_.normal(n).length(); }

    /// Bound of the distance between a computed world point near `p` and the surface, and of what the way of a ray's
    /// origin back into object space adds to that.
    double error(const V3d& p) const { return errorBase_ + errorSlope_ * maxAbs(p); }
    /// Whether a ray starts within rounding of a surface and runs along it as nearly as grazingSlope: on which side it
    /// goes on is then for its starting point to say, not for its direction.
    /// \param above distance of the start from the surface along the unit normal n, in object space
    /// \param slope d.n in object space
    bool grazes(const Ray& worldRay, double above, double slope, const V3d& n) const {
        const double normal2 = worldFromObject_.normal(n).length2();
        return sqr(slope) <= sqr(grazingSlope) * normal2 * worldRay.d.length2() &&
               sqr(above) <= sqr(4 * error(worldRay.o)) * normal2;
    }
    SurfacePoint toWorld(const ObjectPoint& point) const;

  private:
    void boundErrors(double reach);

    Transform worldFromObject_, objectFromWorld_;
    bool flips_, isSimilarity_ = false;
    double volumeScale_, scale_;
    double maxStretch_, minStretch_;
    double errorBase_ = 0, errorSlope_ = 0;
};

} // namespace vitrine
