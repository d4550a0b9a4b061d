// A point of the picture's surfaces where photons are gathered.
#pragma once

#include "paths/walk.h"
#include "photons/photon_lookup.h"
#include "photons/photon_space.h"

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

/// What photons of one disk are gathered with.
struct Gatherer {
    Kernel kernel = Kernel::Epanechnikov;
    std::uint64_t paths = 0; ///< of photons that were traced
    int maxDepth = 5;        ///< scattering events of a whole path: eye part, light part and the point that gathers

    /// Radiance towards the eye, times the point's beta, hero first, from the photons in its disk.
    /// A disk may reach through a wall that stands on the surface, where photons belong to another room. One photon,
    /// chosen by what it brings, is looked at along the surface: if anything stands between, none counts. In the mean
    /// each counts if it is seen.
    /// \param disk that was searched: the point's, as far as it has shrunk  \param u uniform, chooses the photon
    SampledSpectrum light(const World& world, const PhotonSpace& space, const GatherPoint& point,
                          const GatherDisk& disk, std::span<const Photon> photons, std::span<const NearPhoton> near,
                          float u) const;

  private:
    SampledSpectrum contribution(const GatherPoint& point, const V3f& wo, const Photon& photon, float distance2,
                                 float radius2) const;
};

} // namespace vitrine
