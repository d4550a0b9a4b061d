// Paths of photons from the lights, and where they land.
#pragma once

#include "core/sampler.h"
#include "paths/walk.h"
#include "photons/photon.h"
#include "photons/photon_space.h"

namespace vitrine {

struct PhotonSettings {
    std::uint64_t paths = 0; ///< a pass
    int maxDepth = 5;        ///< scattering events of a whole path, the one at the point that gathers included
    /// Whether light that comes straight from a light is kept too; else next-event estimation has it.
    bool keepDirect = false;
};

/// What the paths of one pass left.
struct PhotonPass {
    std::vector<Photon> photons;   ///< in the order of the paths
    std::uint64_t paths = 0;       ///< traced; a photon's share of the power is 1 / paths of its own
    std::uint64_t landedPaths = 0; ///< of them, those that left a photon
    std::uint64_t lostExits = 0;   ///< Walk::lostExits()
};

class PhotonTracer {
  public:
    /// \param world outlives the tracer; must have lights
    PhotonTracer(const World& world, const PhotonSettings& settings, const SamplerSettings& sampler);

    /// \param lambda of the pass (paths/pass_wavelengths.h)
    /// The photons of a pass, traced by all threads of the current task arena; they depend on the pass alone.
    PhotonPass trace(std::uint64_t pass, const SampledWavelengths& lambda) const;

  private:
    struct Block;
    void tracePath(std::uint64_t pass, std::uint64_t path, const SampledWavelengths& lambda, Block& block) const;
    const InteriorStack* interiorOf(const Light* light) const;

    const World& world_;
    PhotonSpace space_;
    PhotonSettings settings_;
    SamplerSettings sampler_;
    /// Solids round each light, where they are the same for all its rays.
    std::unordered_map<const Light*, InteriorStack> interiors_;
};

} // namespace vitrine
