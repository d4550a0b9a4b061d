// Light that a path runs into or asks for, each with its weight in multiple importance sampling.
#pragma once

#include "paths/walk.h"

namespace vitrine {

/// The last scattering of an eye path, for weighing light that the path then runs into.
struct LastBounce {
    LightReceiver at;
    float pdf = 0;        ///< per solid angle
    bool specular = true; ///< also for the camera, and where no light was asked for: nothing competes
};

/// A vertex as what asks for light: where nothing passes through the surface, only what lies before it can shine on it.
LightReceiver receiverAt(const Vertex& vertex, const Bsdf& bsdf);

/// Radiance from the surface met, towards the eye; not times the path's throughput.
SampledSpectrum emittedLight(const World& world, const Walk& walk, const Vertex& vertex, const LastBounce& last);

/// Radiance from lights at infinity along the ray on which the path escaped.
SampledSpectrum escapedLight(const World& world, const Walk& walk, const LastBounce& last);

/// Next-event estimation at a vertex: light of one sampled light, scattered towards vertex.wo. Weighed by the power
/// heuristic against running into the light by sampling the BSDF.
/// \param at receiverAt(vertex, bsdf)
SampledSpectrum directLight(const World& world, const Walk& walk, const Vertex& vertex, const Bsdf& bsdf,
                            const LightReceiver& at, float uLight, const V2f& u);

} // namespace vitrine
