// Eye paths of photon mapping: from the camera to points where photons are gathered, with the light met on the way.
#pragma once

#include "paths/direct_light.h"
#include "paths/light_reach.h"
#include "photons/gather_point.h"
#include "photons/photon_space.h"

namespace vitrine {

struct EyePathSettings {
    int maxDepth = 5;
    /// Direct light at points that gather: by photons; else by next-event estimation.
    bool directByPhotons = false;
    /// Follow reflection and refraction both where a polished dielectric offers both; else one, by chance.
    bool branch = false;
    /// Base radius of the disks in pixels, each of the size that a pixel has at the point; or in scene units, if positive.
    float radiusInPixels = 2, radius = 0;
};

class EyePaths {
  public:
    EyePaths(const World& world, const EyePathSettings& settings);

    /// Follows a camera ray. Points that gather are appended to `points`.
    /// \param lambda hero first  \param hero which of the pass's wavelengths that is
    /// \param stream continues at its present dimension
    /// \return the light found without photons: emitted towards the eye, and direct light; hero first
    SampledSpectrum trace(const Ray& ray, const PixelFootprint& footprint, const SampledWavelengths& lambda, int hero,
                          SampleStream& stream, std::vector<GatherPoint>& points, std::uint64_t& lostExits) const;

    const PhotonSpace& space() const { return space_; }

  private:
    struct Path;
    void follow(Path path, SampleStream& stream, std::vector<GatherPoint>& points, SampledSpectrum& light,
                std::uint64_t& lostExits) const;
    bool forks(const Path& path, const Bsdf& bsdf) const;
    void gather(const Path& path, const Vertex& vertex, const Bsdf& bsdf, LightHistory from,
                std::vector<GatherPoint>& points) const;
    float baseRadius(const V3f& center, double pixelSide) const;

    const World& world_;
    LightReach lightReach_;
    PhotonSpace space_;
    EyePathSettings settings_;
    bool hasHiddenLight_ = false; ///< LightHistory::Hidden may occur
};

} // namespace vitrine
