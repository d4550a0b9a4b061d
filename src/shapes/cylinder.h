// Open cylinder about the object's z axis, or a sector of it.
#pragma once

#include "shapes/parameters.h"
#include "shapes/placement.h"

namespace vitrine {

/// Shape "cylinder": an open cylinder about the z axis, or a sector of it.
///
/// | name   | type  | unit        | default | meaning |
/// |--------|-------|-------------|---------|---------|
/// | radius | float | scene units | 1       | radius |
/// | zmin   | float | scene units | -1      | lower end |
/// | zmax   | float | scene units | 1       | upper end |
/// | phimax | float | degrees     | 360     | extent of the angle about the z axis, from the x axis towards y |
///
/// u = phi / phimax; v goes from 0 at zmin to 1 at zmax. The normal points away from the axis.
class Cylinder final : public Shape {
  public:
    /// \throws std::invalid_argument
    Cylinder(const Transform& worldFromObject, bool reverseOrientation, double radius, double zMin, double zMax,
             double phiMaxDegrees);

    Box3d bounds(unsigned prim) const override;
    using Shape::bounds;
    bool intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const override;
    bool occludes(unsigned prim, const Ray& ray, double sMin, double sMax) const override;
    SurfacePoint pointAt(const Ray& ray, const PrimitiveHit& hit) const override;

    double area() const override { return area_; }
    std::optional<ShapeSample> sample(const V2f& u) const override;
    /// Uniform over the area in object space: under a transform that makes the cylinder elliptic, not in the world.
    float pdf(const PrimitiveHit& hit) const override;
    using Shape::pdf;
    using Shape::sample;
    std::size_t memoryBytes() const override { return sizeof(*this); }

  private:
    bool cross(const Ray& ray, double sMin, double sMax, double& s, V3d& pObject) const;
    SurfacePoint pointOf(const V3d& pObject) const;
    float pdfAt(const V3d& n) const;

    double radius_, zMin_, zMax_;
    PhiRange phi_;
    Placement placement_;
    double area_;
};

} // namespace vitrine
