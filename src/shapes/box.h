// Solid box along the object's axes.
#pragma once

#include "shapes/parameters.h"
#include "shapes/placement.h"

#include <array>

namespace vitrine {

/// Shape "box": a solid box along the axes. Not in pbrt-v4.
///
/// | name | type   | unit        | default    | meaning |
/// |------|--------|-------------|------------|---------|
/// | pmin | point3 | scene units | -1 -1 -1   | least corner |
/// | pmax | point3 | scene units | 1 1 1      | greatest corner |
///
/// (u, v) go from 0 to 1 over each face, along the two axes that follow the face's own in the order x y z x; on the
/// three lesser faces u runs backwards, so that dpdu x dpdv points out everywhere.
class Box final : public Shape {
  public:
    /// \throws std::invalid_argument
    Box(const Transform& worldFromObject, bool reverseOrientation, const V3d& pMin, const V3d& pMax);

    Box3d bounds(unsigned prim) const override;
    using Shape::bounds;
    bool intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const override;
    SurfacePoint pointAt(const Ray& ray, const PrimitiveHit& hit) const override;

    double area() const override { return area_; }
    std::optional<ShapeSample> sample(const V2f& u) const override;
    using Shape::pdf;
    using Shape::sample;

    bool isClosed() const override { return !placement_.flips(); }
    std::size_t memoryBytes() const override { return sizeof(*this); }

  private:
    SurfacePoint pointOf(int face, V3d pObject) const;

    V3d min_, max_;
    Placement placement_;
    V3d normalLength_;               ///< object length per world length along the normals of the three axes
    std::array<double, 3> faceArea_; ///< of one of the two faces across each axis, in the world
    double area_;
};

} // namespace vitrine
