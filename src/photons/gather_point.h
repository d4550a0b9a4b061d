// A point of the picture's surfaces where photons are gathered.
#pragma once

#include "paths/walk.h"
#include "photons/photon_lookup.h"
#include "photons/photon_space.h"

namespace vitrine {

/// At a point that scatters with this BSDF an eye path gathers photons of this history with this probability; else it
/// finds their light by going on in a direction of the BSDF's. Both estimate the same light, so any probability is right
/// for what both can find; what only photons find they always bring. The probabilities rise smoothly with roughness
/// (docs/decisions.md, "Photon mapping", says where from and where to).
float gatherProbability(const Bsdf& bsdf, LightHistory history);

struct GatherPoint {
    GatherDisk disk; ///< radius: the base radius
    Frame frame;     ///< shading
    V3f wo;          ///< unit, world, towards the eye
    Bsdf bsdf;
    int hero = 0;                                ///< of its path among the pass's wavelengths
    SampledSpectrum beta;                        ///< what the eye sees of radiance that leaves towards wo, hero first
    int depth = 0;                               ///< scattering events between it and the eye
    LightHistory from = LightHistory::Scattered; ///< photons of this history and the later ones count
};

/// What photons of one disk are gathered with.
struct Gatherer {
    Kernel kernel = Kernel::Epanechnikov;
    std::uint64_t paths = 0; ///< of photons that were traced
    int maxDepth = 5;        ///< scattering events of a whole path: eye part, light part and the point that gathers
    double time = 0;         ///< of the pass

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
