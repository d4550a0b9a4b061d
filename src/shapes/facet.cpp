#include "shapes/facet.h"

#include "core/frame.h"

namespace vitrine {

Parallelogram::Parallelogram(const V3d& corner, const V3d& eu, const V3d& ev) : p0(corner) {
    const V3d n = eu.cross(ev);
    // Scaled as intersectTriangle does, so that ties between coplanar faces are ties.
    normal = n / maxAbs(n);
    toU = ev.cross(n) / n.length2();
    toV = n.cross(eu) / n.length2();
}

bool intersectTriangle(const V3d& p0, const V3d& p1, const V3d& p2, const Ray& ray, double sMin, double sMax,
                       PrimitiveHit& hit) {
    const V3d a = p0 - ray.o, b = p1 - ray.o, c = p2 - ray.o;
    const double w0 = ray.d.dot(b.cross(c)), w1 = ray.d.dot(c.cross(a)), w2 = ray.d.dot(a.cross(b));
    const bool allBelow = w0 <= 0 && w1 <= 0 && w2 <= 0, allAbove = w0 >= 0 && w1 >= 0 && w2 >= 0;
    if (!allBelow && !allAbove) return false;
    const double sum = w0 + w1 + w2;
    const V3d normal = (p1 - p0).cross(p2 - p0);
    // Scaled so that coplanar triangles along an axis get the very same distance, and ties are ties.
    const V3d n = normal / maxAbs(normal);
    const double s = n.dot(a) / n.dot(ray.d);
    if (!(s > sMin && s < sMax) || sum == 0) return false;
    hit.s = s;
    hit.u = w1 / sum;
    hit.v = w2 / sum;
    return true;
}

double triangleError(const V3d& p0, const V3d& p1, const V3d& p2) {
    // Let e be 2^-24 and D the longest edge; the origin lies on the triangle, so |p_i - o| <= D. Embree rounds p_i - o
    // (e D each), subtracts them for the edges (3 e D), takes the normal from two edges a and b (2 e |a||b| +
    // 6 e D max(|a|,|b|), but with the products of the shorter edges: its "stable normal") and divides (4 e D): about
    // e D (8 + 8 k), where k = |a||b| / |a x b| of the two shorter edges says how the normal turns for slivers. Twice
    // that also covers directions that single-precision normals take for leaving though they enter (5e-7 D).
    const V3d e0 = p1 - p0, e1 = p2 - p1, e2 = p0 - p2;
    double lengths[3] = {e0.length(), e1.length(), e2.length()};
    std::sort(lengths, lengths + 3);
    // A triangle thinner than this has no normal in single precision; the offset must not grow with it.
    constexpr double maxSliver = 64;
    const double sliver = std::min(maxSliver, lengths[0] * lengths[1] / e0.cross(e1).length());
    return 0x1p-24 * lengths[2] * (16 + 16 * sliver);
}

void anyTangents(const V3d& n, V3f& dpdu, V3f& dpdv) {
    const Frame frame(toFloat(n.normalized()));
    dpdu = frame.s;
    dpdv = frame.t;
}

} // namespace vitrine
