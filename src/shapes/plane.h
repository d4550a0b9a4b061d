// Infinite plane.
#pragma once

#include "shapes/parameters.h"
#include "shapes/shape.h"

namespace vitrine {

/// Shape "plane": an infinite plane. Not in pbrt-v4.
///
/// | name | type   | unit        | default | meaning |
/// |------|--------|-------------|---------|---------|
/// | n    | normal |             | 0 1 0   | side on which the outside lies; any length |
/// | d    | float  | scene units | 0       | the points x of the plane have n.x = d (d in units of n's length) |
/// | p    | point3 | scene units | none    | a point of the plane, in place of d |
///
/// (u, v) are lengths in object space along two axes that with the normal make a right-handed frame; for the normal 0 0 1
/// x and y.
class Plane final : public Shape {
  public:
    /// \throws std::invalid_argument
    Plane(const Transform& worldFromObject, bool reverseOrientation, const V3d& normal, double d);

    GeometryKind kind() const override { return GeometryKind::Unbounded; }
    /// All of space.
    Box3d bounds(unsigned prim) const override;
    using Shape::bounds;
    bool intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const override;
    SurfacePoint pointAt(const Ray& ray, const PrimitiveHit& hit) const override;

    double area() const override { return infinityD; }
    /// Nothing: there is no uniform density.
    std::optional<ShapeSample> sample(const V2f&) const override { return std::nullopt; }
    using Shape::pdf;
    using Shape::sample;
    std::size_t memoryBytes() const override { return sizeof(*this); }

  private:
    double height(const V3d& p) const { return n_.dot(p) - d_; }
    double error(const V3d& p) const;

    // In world space: unit normal as the transform gives it, and n.p = d.
    V3d n_;
    double d_;
    V3f ng_;
    V3d origin_; ///< where u = v = 0
    V3d dpdu_, dpdv_;
    V3d uOf_, vOf_; ///< u and v of p are uOf.(p - origin) and vOf.(p - origin)
};

} // namespace vitrine
