// Sphere about the object's origin, or the part of it between two heights and angles.
#pragma once

#include "shapes/parameters.h"
#include "shapes/placement.h"
#include "shapes/quadratic.h"

#include <array>

namespace vitrine {

/// Shape "sphere": a sphere about the origin, or the part of it between two heights and within an angle.
///
/// | name   | type  | unit        | default | meaning |
/// |--------|-------|-------------|---------|---------|
/// | radius | float | scene units | 1       | radius |
/// | zmin   | float | scene units | -radius | nothing below this height; at most -radius: no limit |
/// | zmax   | float | scene units | radius  | nothing above this height; at least radius: no limit |
/// | phimax | float | degrees     | 360     | extent of the angle about the z axis, from the x axis towards y |
///
/// u = phi / phimax; v goes from 0 at zmin to 1 at zmax in proportion to the angle from the z axis.
class Sphere final : public Shape {
  public:
    /// \throws std::invalid_argument
    Sphere(const Transform& worldFromObject, bool reverseOrientation, double radius, double zMin, double zMax,
           double phiMaxDegrees);

    Box3d bounds(unsigned prim) const override;
    using Shape::bounds;
    bool intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const override;
    bool occludes(unsigned prim, const Ray& ray, double sMin, double sMax) const override;
    SurfacePoint pointAt(const Ray& ray, const PrimitiveHit& hit) const override;

    double area() const override { return area_; }
    std::optional<ShapeSample> sample(const V2f& u) const override;
    float pdf(const PrimitiveHit& hit) const override;
    /// A full round sphere is sampled by the cone it fills (Shirley, Wang & Zimmerman 1996), anything else by area.
    std::optional<ShapeSample> sample(const V3d& from, const V2f& u) const override;
    float pdf(const V3d& from, const PrimitiveHit& hit, const SurfacePoint& point) const override;

    bool isClosed() const override { return isFull_ && !placement_.flips(); }
    std::size_t memoryBytes() const override { return sizeof(*this); }

  private:
    bool cross(const Ray& ray, double sMin, double sMax, double& s, V3d& pObject) const;
    bool covers(const V3d& pObject) const;
    ObjectPoint describe(const V3d& pObject) const;
    /// Of a round sphere, by the square of the distance from its centre: whether it is sampled by its cone.
    bool isOutside(double distance2) const;
    SurfacePoint roundPoint(const V3d& normal) const;
    double integrateArea() const;

    // World space; for a full sphere that stays round, which is solved there.
    bool isRound_ = false;
    V3d center_{0, 0, 0};
    double worldRadius_ = 0, worldRadius2_ = 0;
    std::array<V3f, 3> axes_; ///< the object's, of unit length

    bool isFull_;
    double radius_, zMin_, zMax_;
    PhiRange phi_;
    double thetaZMin_, thetaZMax_;
    Placement placement_;
    double grazingError_; ///< how deep a ray may dip that leaves along grazingSlope
    double area_;
};

} // namespace vitrine
