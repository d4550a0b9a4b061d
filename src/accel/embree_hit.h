// What Embree says that a ray meets, solved in double.
#pragma once

#include "accel/candidate.h"
#include "accel/embree_query.h"

namespace vitrine::embree {

/// The hit of a face that Embree reports at (u,v), from the double ray. False when in double it lies behind the origin.
bool solveFound(const PrimitiveRef& ref, const Ray& ray, float u, float v, PrimitiveHit& hit);

inline Candidate candidate(const PrimitiveRef& ref) {
    return {*ref.shape, ref.id, ref.prim, ref.cutout};
}

inline CastRay castRay(Query& query, std::uint32_t instance) {
    if (instance == CasterHit::noInstance) return CastRay(*query.ray);
    return CastRay(*query.ray, query.rayIn(instance), instance, query.placed[instance]);
}

} // namespace vitrine::embree
