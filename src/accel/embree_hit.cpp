#include "accel/embree_hit.h"

namespace vitrine::embree {

bool solveFound(const PrimitiveRef& ref, const Ray& ray, float foundU, float foundV, PrimitiveHit& hit) {
    if (ref.shape->solve(ref.prim, ray, hit)) return true;
    // The double ray passes just beside the primitive, on whose edge Embree let no ray slip through; or the
    // crossing lies behind.
    double u = std::clamp(double(foundU), 0., 1.), v = std::clamp(double(foundV), 0., 1.);
    if (ref.shape->kind() == GeometryKind::Triangles || ref.farHalf) v = std::min(v, 1 - u);
    hit.prim = ref.prim;
    hit.u = ref.farHalf ? 1 - u : u;
    hit.v = ref.farHalf ? 1 - v : v;
    const SurfacePoint point = ref.shape->pointAt(ray, hit);
    const V3d way = point.p - ray.o, n = toDouble(point.ng);
    const double slope = n.dot(ray.d);
    // In front only if the plane is, by more than the rounding of n: the point is as far from the ray as Embree's (u,v)
    // are wrong, which at a crossing in the origin is all the way there is.
    if (!(n.dot(way) * slope > 0x1p-22 * way.length() * std::abs(slope))) return false;
    hit.s = way.dot(ray.d) / ray.d.length2();
    return hit.s > 0;
}

} // namespace vitrine::embree
