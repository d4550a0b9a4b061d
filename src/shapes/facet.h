// Flat pieces of surface, in double over single-precision vertices.
#pragma once

#include "shapes/shape.h"

namespace vitrine {

/// What a flat primitive's points have in common.
struct Facet {
    V3f ng; ///< unit, as the vertices' order says; not yet turned by orientation or shading normals
    V3f dpdu, dpdv;
    float error = 0; ///< the part of SurfacePoint::error that belongs to the primitive
};

/// A parallelogram, solved from its plane.
struct Parallelogram {
    /// What lies this much inside or outside, in units of u and v, surely does: rounding is less, even for a ray from a
    /// hundred million widths away. Whether a ray nearer to an edge passes is for intersectTriangle to say.
    static constexpr double edge = 1e-6;

    V3d p0{0, 0, 0}, normal{0, 0, 0}; ///< a corner; the normal, of any length
    V3d toU{0, 0, 0}, toV{0, 0, 0};   ///< what u and v of a point q are the products of q - p0 with

    Parallelogram() = default;
    /// \param eu,ev the edges at p0, not parallel
    Parallelogram(const V3d& p0, const V3d& eu, const V3d& ev);

    /// Where the ray's line crosses the plane.
    PrimitiveHit cross(const Ray& ray, unsigned prim) const {
        const V3d toCorner = p0 - ray.o;
        const double s = normal.dot(toCorner) / normal.dot(ray.d);
        const V3d q = ray.d * s - toCorner;
        return {s, q.dot(toU), q.dot(toV), prim};
    }
};

/// A number of facets up to which a mesh keeps them ready.
inline constexpr unsigned maxReadyFacets = 4096;

/// The crossing of a ray with the triangle, edges included. Edges are decided by the signs of the edges' Pluecker
/// products (Davidovic, Engelhardt, Georgiev, Slusallek & Dachsbacher 2012), which are exact negatives for the two triangles at an edge: none slips between.
/// u and v are the weights of p1 and p2.
bool intersectTriangle(const V3d& p0, const V3d& p1, const V3d& p2, const Ray& ray, double sMin, double sMax,
                       PrimitiveHit& hit);

/// Bound of what Embree may mistake in the distance of an origin from the plane of a triangle, as far as the triangle
/// is concerned.
double triangleError(const V3d& p0, const V3d& p1, const V3d& p2);

/// The part that comes from rounding the origin `p` of a ray to single precision: half a unit in the last place a
/// coordinate, 2^-24 |p_i|, so at most sqrt(3) 2^-24 max |p_i| in any direction.
inline double originError(const V3d& p) {
    return 0x1p-23 * maxAbs(p);
}

/// Two unit vectors that make a right-handed frame with the direction n: where (u,v) say nothing.
void anyTangents(const V3d& n, V3f& dpdu, V3f& dpdv);

} // namespace vitrine
