// The photons of a pass.
#pragma once

#include "photons/light_paths.h"
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
    PhotonBlocks blocks;
    std::uint64_t photons = 0;     ///< in all blocks
    std::uint64_t landedPaths = 0; ///< paths that left a photon
    std::uint64_t lostExits = 0;   ///< Walk::lostExits()
};

class PhotonTracer {
  public:
    /// \param world outlives the tracer; must have lights
    PhotonTracer(const World& world, const PhotonSettings& settings, const SamplerSettings& sampler);

    /// Traced by all threads of the current task arena; the photons depend on the pass alone.
    /// \param lambda, time of the pass (paths/pass_wavelengths.h, paths/pass_time.h)
    PhotonPass trace(std::uint64_t pass, const SampledWavelengths& lambda, double time = 0) const;

  private:
    PhotonSpace space_;
    PhotonSettings settings_;
    LightPaths paths_;
};

} // namespace vitrine
