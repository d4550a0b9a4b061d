// A primitive that a ray may meet: the first of its crossings that are there.
#pragma once

#include "accel/instance.h"

namespace vitrine {

/// A ray in the space of what it may meet.
struct CastRay {
    const Ray& world;
    const Ray& local; ///< in the instance's space; else the same as `world`
    std::uint32_t instance = CasterHit::noInstance;
    const Placed* placed = nullptr; ///< the instance; null: none

    explicit CastRay(const Ray& ray) : world(ray), local(ray) {}
    CastRay(const Ray& ray, const Ray& rayInInstance, std::uint32_t number, const Placed& where)
        : world(ray), local(rayInInstance), instance(number), placed(&where) {}
};

/// A primitive as casters list them.
struct Candidate {
    const Shape* shape = nullptr;
    std::uint32_t id = 0;
    unsigned prim = 0;
    const Cutout* cutout = nullptr; ///< null: no holes

    Candidate(const Shape& of, std::uint32_t number, unsigned primitive, const Cutout* holes)
        : shape(&of), id(number), prim(primitive), cutout(holes) {}
    Candidate(const CasterShape& entry, unsigned primitive)
        : Candidate(*entry.shape, entry.id, primitive, entry.cutout.get()) {}
};

/// Whether a crossing of a primitive that has holes is there: a pure function of its arguments, so that casters may meet
/// them in any order. Rays that differ in their last bit are independent, and so are one ray's crossings.
/// \param ordinal which of the ray's crossings of the primitive, from 0
bool isThere(const Candidate& candidate, const CastRay& ray, const PrimitiveHit& hit, unsigned ordinal);

/// The first crossing with s in (0, sMax) that is there, of a primitive with holes.
bool intersectWithHoles(const Candidate& candidate, const CastRay& ray, double sMax, PrimitiveHit& hit);

/// Keeps a hit if it comes before the one there is.
inline bool keepIfFirst(const Shape& shape, std::uint32_t id, std::uint32_t instance, const PrimitiveHit& hit,
                        CasterHit& best) {
    if (!comesBefore(hit.s, instance, id, hit.prim, best)) return false;
    best.s = hit.s;
    best.id = id;
    best.instance = instance;
    best.shape = &shape;
    best.primitive = hit;
    return true;
}

/// Tries one primitive and keeps its hit if it comes before the one there is.
inline bool tryPrimitive(const Candidate& candidate, const CastRay& ray, double sMax, CasterHit& best) {
    PrimitiveHit hit;
    const double end = std::min(sMax, best.shape ? justAbove(best.s) : infinityD);
    if (candidate.cutout ? !intersectWithHoles(candidate, ray, end, hit)
                         : !candidate.shape->intersect(candidate.prim, ray.local, 0, end, hit))
        return false;
    return keepIfFirst(*candidate.shape, candidate.id, ray.instance, hit, best);
}

/// Whether the primitive stops the ray before its end.
inline bool occludes(const Candidate& candidate, const CastRay& ray) {
    if (!candidate.cutout) return candidate.shape->occludes(candidate.prim, ray.local, 0, ray.world.tMax);
    PrimitiveHit hit;
    return intersectWithHoles(candidate, ray, ray.world.tMax, hit);
}

} // namespace vitrine
