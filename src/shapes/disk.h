// Disk or ring perpendicular to the object's z axis, or a sector of it.
#pragma once

#include "shapes/parameters.h"
#include "shapes/placement.h"

namespace vitrine {

/// Shape "disk": a disk or ring perpendicular to the z axis, or a sector of it.
///
/// | name        | type  | unit        | default | meaning |
/// |-------------|-------|-------------|---------|---------|
/// | height      | float | scene units | 0       | z of the disk |
/// | radius      | float | scene units | 1       | outer radius |
/// | innerradius | float | scene units | 0       | radius of the hole |
/// | phimax      | float | degrees     | 360     | extent of the angle about the z axis, from the x axis towards y |
///
/// u = phi / phimax; v goes from 0 at the rim to 1 at the inner radius. The normal is +z.
class Disk final : public Shape {
  public:
    /// \throws std::invalid_argument
    Disk(const Transform& worldFromObject, bool reverseOrientation, double height, double radius, double innerRadius,
         double phiMaxDegrees);

    Box3d bounds(unsigned prim) const override;
    using Shape::bounds;
    bool intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const override;
    bool occludes(unsigned prim, const Ray& ray, double sMin, double sMax) const override;
    SurfacePoint pointAt(const Ray& ray, const PrimitiveHit& hit) const override;

    double area() const override { return area_; }
    std::optional<ShapeSample> sample(const V2f& u) const override;
    using Shape::pdf;
    using Shape::sample;
    std::size_t memoryBytes() const override { return sizeof(*this); }

  private:
    bool cross(const Ray& ray, double sMin, double sMax, double& s, V2d& p) const;
    SurfacePoint pointOf(const V2d& p) const;

    double height_, radius_, innerRadius_;
    PhiRange phi_;
    Placement placement_;
    double area_;
};

} // namespace vitrine
