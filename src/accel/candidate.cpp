#include "accel/candidate.h"

#include "core/random.h"

namespace vitrine {

namespace {

/// Uniform in [0, 1).
float numberOf(const Ray& ray, const Candidate& candidate, std::uint32_t instance, unsigned ordinal) {
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    const std::uint64_t key = streamKey(bits(ray.o.x), bits(ray.o.y), bits(ray.o.z), bits(ray.d.x), bits(ray.d.y),
                                        bits(ray.d.z), candidate.id, instance, candidate.prim, ordinal);
    return unitFloat(std::uint32_t(key >> 32));
}

} // namespace

bool isThere(const Candidate& candidate, const CastRay& ray, const PrimitiveHit& hit, unsigned ordinal) {
    SurfacePoint point = candidate.shape->pointAt(ray.local, hit);
    if (ray.placed) ray.placed->toWorld(point);
    const float opacity = candidate.cutout->opacity(point);
    return opacity >= 1 || (opacity > 0 && numberOf(ray.world, candidate, ray.instance, ordinal) < opacity);
}

bool intersectWithHoles(const Candidate& candidate, const CastRay& ray, double sMax, PrimitiveHit& hit) {
    const Shape& shape = *candidate.shape;
    double s = 0;
    // Crossings are counted from the ray's origin, wherever the search ends: their numbers are the same for each caster.
    for (unsigned ordinal = 0; shape.intersect(candidate.prim, ray.local, s, sMax, hit); ++ordinal) {
        if (isThere(candidate, ray, hit, ordinal)) return true;
        // A flat face is crossed once: what its second triangle adds along their diagonal is the same crossing.
        if (shape.kind() != GeometryKind::User) return false;
        s = hit.s;
    }
    return false;
}

} // namespace vitrine
