// What every shape answers. A shape lies in world space (or, inside an object instance, in the instance's space): it
// holds its own worldFromObject where it needs one.
#pragma once

#include "core/direction_cone.h"
#include "core/ray.h"
#include "core/transform.h"
#include "core/vec.h"

#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// A ray's meeting with one primitive of a shape: what is needed to fill in the rest once it is known to be the closest.
struct PrimitiveHit {
    double s = infinityD; ///< distance along the ray, in units of |d|
    double u = 0, v = 0;  ///< the shape's own parameters of the point (barycentrics, phi and t ...)
    unsigned prim = 0;    ///< which primitive of the shape
};

/// A point of a surface with its differential geometry.
struct SurfacePoint {
    V3d p;            ///< world space
    double error = 0; ///< bound of the distance between p and the true surface, and of what a ray cast from p may
                      ///< mistake: a spawned ray starts this far off along ng
    V3f ng;           ///< unit geometric normal, the outside; flipped by ReverseOrientation and by mirroring as pbrt's
    V3f ns;           ///< unit shading normal, in ng's hemisphere
    V2f uv;
    V3f dpdu, dpdv; ///< per unit of uv; may be zero at poles
    V3f dndu, dndv; ///< derivatives of ns
};

/// A point drawn on a shape, for light sampling.
struct ShapeSample {
    SurfacePoint point; ///< p, error, ng, uv are set; derivatives need not be
    float pdf = 0;      ///< per area or per solid angle, as the call says
};

/// A part of a shape that light sampling may choose by itself.
struct ShapePart {
    Box3d bounds;
    double area = 0;
    DirectionCone normals; ///< geometric ones, as pointAt says which side is out
};

/// How the ray caster treats a shape.
enum class GeometryKind {
    Triangles, ///< Embree triangles over vertices() and indices() (3 a primitive)
    Quads,     ///< Embree quads over vertices() and indices() (4 a primitive, in order around the quad)
    User,      ///< intersect() is called, in double
    Unbounded  ///< intersect() is called beside the BVH (infinite plane)
};

class Shape {
  public:
    virtual ~Shape() = default;

    virtual GeometryKind kind() const { return GeometryKind::User; }
    virtual unsigned primitiveCount() const { return 1; }
    virtual Box3d bounds(unsigned prim) const = 0;
    Box3d bounds() const;

    /// The first crossing of primitive `prim` with s in (sMin, sMax), exclusive. Must work for every ray, in double;
    /// rays with zero, NaN or infinite components meet nothing. For Triangles and Quads this is the oracle of Embree.
    virtual bool intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const = 0;
    /// Triangles and Quads: the crossing of a ray of which Embree says that it meets the primitive, solved in double; it may
    /// lie just beside the edges. False when it lies behind the origin, or is not to be found like this.
    virtual bool solve(unsigned prim, const Ray& ray, PrimitiveHit& hit) const {
        return intersect(prim, ray, 0, infinityD, hit);
    }
    /// Whether there is any crossing in (sMin, sMax); for a shape with a quicker way than the first one.
    virtual bool occludes(unsigned prim, const Ray& ray, double sMin, double sMax) const {
        PrimitiveHit hit;
        return intersect(prim, ray, sMin, sMax, hit);
    }
    /// The geometry at a hit that intersect (or Embree) reported.
    virtual SurfacePoint pointAt(const Ray& ray, const PrimitiveHit& hit) const = 0;

    /// Shared buffers for Triangles and Quads, alive as long as the shape; tightly packed floats, 16 readable bytes at
    /// the end of the vertices as Embree asks.
    virtual const float* vertices() const { return nullptr; }
    virtual std::size_t vertexCount() const { return 0; }
    virtual const std::uint32_t* indices() const { return nullptr; }

    virtual double area() const = 0;
    /// A point by area (pdf = 1/area, density per unit area). Empty for shapes of no or infinite area.
    virtual std::optional<ShapeSample> sample(const V2f& u) const = 0;
    /// Density of sample() at a point, per unit area.
    virtual float pdf(const PrimitiveHit& hit) const { return (void)hit, float(1 / area()); }
    /// A point as seen from `from`, density per solid angle there; by default by area. Shapes override it where a
    /// better way is known (sphere: its cone; a rectangle: its solid angle). Only points with positive density.
    virtual std::optional<ShapeSample> sample(const V3d& from, const V2f& u) const;
    /// Density of sample(from, u), per solid angle, of the point `point` (a hit of a ray from `from`).
    virtual float pdf(const V3d& from, const PrimitiveHit& hit, const SurfacePoint& point) const;

    /// Into how many parts light sampling may divide the shape. With more than one, a point's part is the primitive it lies
    /// on.
    virtual unsigned partCount() const { return 1; }
    virtual ShapePart part(unsigned part) const { return (void)part, ShapePart{bounds(), area(), {}}; }
    /// A point of one part as seen from `from`, density per solid angle there.
    virtual std::optional<ShapeSample> samplePart(unsigned part, const V3d& from, const V2f& u) const {
        return (void)part, sample(from, u);
    }
    /// Density of samplePart(part of the hit, from, u), per solid angle, as pdf(from, hit, point) is sample's.
    virtual float partPdf(const V3d& from, const PrimitiveHit& hit, const SurfacePoint& point) const {
        return pdf(from, hit, point);
    }

    /// True when normals point out of a solid that the surface bounds (sphere, box, closed mesh or profile); a
    /// dielectric on a shape that is not closed deserves a warning.
    virtual bool isClosed() const { return false; }
    virtual std::size_t memoryBytes() const { return sizeof(*this); }

  protected:
    /// Density per area turned into density per solid angle at `from`; empty where that is none.
    static std::optional<ShapeSample> seen(std::optional<ShapeSample> byArea, const V3d& from);
    static float seenPdf(float pdfArea, const V3d& from, const SurfacePoint& point);
};

using ShapePtr = std::shared_ptr<const Shape>;

/// point = shape.pointAt(ray, hit), made in place: copying a point that was just written stalls the processor, which
/// cannot forward many small stores to few large loads.
inline void fillPoint(SurfacePoint& point, const Shape& shape, const Ray& ray, const PrimitiveHit& hit) {
    ::new (static_cast<void*>(&point)) SurfacePoint(shape.pointAt(ray, hit));
}

/// Start of a ray that leaves a surface at p towards w: off the surface on w's side by the point's error.
inline V3d offsetOrigin(const SurfacePoint& point, const V3f& w) {
    const double side = w.dot(point.ng) < 0 ? -point.error : point.error;
    return point.p + toDouble(point.ng) * side;
}

/// Density per area turned into density per solid angle at distance^2 and cosine at the light.
inline float areaToSolidAngle(double pdfArea, double distance2, double absCos) {
    return absCos > 0 ? float(pdfArea * distance2 / absCos) : 0;
}

} // namespace vitrine
