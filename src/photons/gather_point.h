// A point of the picture's surfaces where photons are gathered.
#pragma once

#include "paths/walk.h"
#include "photons/photon_lookup.h"

namespace vitrine {

/// At a point that scatters with this BSDF an eye path gathers photons with this probability, else it goes on by the
/// BSDF. Both estimate the same light, so any probability is right; this one rises smoothly with roughness, from
/// surfaces so shiny that few photons lie in the lobe to those that the BSDF's own directions would sample badly.
inline float gatherProbability(const Bsdf& bsdf) {
    constexpr float shiny = 0.05f, rough = 0.35f;
    const float t = std::clamp((bsdf.roughness() - shiny) / (rough - shiny), 0.f, 1.f);
    return t * t * (3 - 2 * t);
}

struct GatherPoint {
    GatherDisk disk; ///< radius: the base radius
    Frame frame;     ///< shading
    V3f wo;          ///< unit, world, towards the eye
    Bsdf bsdf;
    int hero = 0;         ///< of its path among the pass's wavelengths
    SampledSpectrum beta; ///< what the eye sees of radiance that leaves towards wo, hero first
    int depth = 0;        ///< scattering events between it and the eye
};

/// Radiance towards the eye, times beta, hero first, from the photons in the point's disk.
/// \param radius of the disk that was searched  \param paths of photons that were traced
/// \param maxDepth scattering events of a whole path, eye and light part and this point
SampledSpectrum gatheredLight(const GatherPoint& point, std::span<const Photon> photons,
                              std::span<const NearPhoton> near, float radius, Kernel kernel, std::uint64_t paths,
                              int maxDepth);

} // namespace vitrine
