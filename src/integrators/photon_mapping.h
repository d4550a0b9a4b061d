// Progressive photon mapping: eye paths gather the photons of each pass in disks that shrink from pass to pass.
#pragma once

#include "integrators/integrator.h"
#include "photons/eye_paths.h"
#include "photons/photon_tracer.h"
#include "photons/point_tree.h"
#include "photons/radius_schedule.h"

namespace vitrine {

/// How disks shrink (photons/radius_schedule.h).
enum class RadiusRule { Shared, PerPoint };

/// What photons are looked for with.
enum class PhotonSearch { Grid, Tree, Naive };

/// Integrator "sppm", "ppm": stochastic progressive photon mapping (Hachisuka & Jensen 2009) with new eye paths in each
/// pass, and progressive photon mapping (Hachisuka, Ogaki & Jensen 2008) with the same eye paths in all passes. Light that
/// comes straight from lights is found by next-event estimation.
///
/// | name                | type    | unit        | default          | meaning |
/// |---------------------|---------|-------------|------------------|---------|
/// | maxdepth            | integer | bounces     | 5                | scattering events a whole path may have, eye and light part together |
/// | photonsperiteration | integer |             | -1               | paths of photons a pass; -1: as many as the picture has pixels |
/// | radiusrule          | string  |             | "shared"         | "shared": one factor for all disks, passes are independent; "perpoint": each pixel's by the photons it found |
/// | alpha               | float   |             | 0.6667           | how slowly disks shrink; 1: never |
/// | radius              | float   | scene units | -1               | radius of all disks in the first pass; -1: by the size that a pixel has at each point |
/// | radiuspixels        | float   | pixels      | 3                | radius in the first pass, in pixels, where "radius" is not given |
/// | directbyphotons     | bool    |             | false            | direct light by photons too |
/// | kernel              | string  |             | "epanechnikov"   | "constant" or "epanechnikov": weight of photons in a disk |
/// | lookup              | string  |             | "grid"           | "grid", "kdtree" (ppm only) or "naive": how photons are found; the picture is the same but for rounding |
/// | hitpointsperpixel   | integer |             | 4                | ppm only: eye paths a pixel |
/// | iterations          | integer |             | the sampler's pixelsamples | passes |
/// | lightsampler        | string  |             | "bvh" of more than 16 lights, else "power" | which light is asked for direct light and sends photons: "uniform": all alike; "power": mostly by power; "bvh": by what each brings to the point, each face of a mesh by itself, and photons by power. "exhaustive" is read as "bvh" |
/// | seed                | integer |             | the sampler's    | other seeds give other noise |
struct PhotonMappingSettings {
    bool fixedEyePaths = false; ///< ppm
    int eyePathsPerPixel = 1;
    RadiusRule rule = RadiusRule::Shared;
    double alpha = 2. / 3;
    Kernel kernel = Kernel::Epanechnikov;
    PhotonSearch search = PhotonSearch::Grid;
    EyePathSettings eye;
    std::int64_t photonsPerPass = -1;
};

class PhotonMappingIntegrator final : public Integrator {
  public:
    PhotonMappingIntegrator(const PhotonMappingSettings& settings, const SamplerSettings& sampler)
        : settings_(settings), sampler_(sampler) {}

    /// No lights, or nothing that photons could land on.
    void check(const World& world) const override;
    void addPasses(const World& world, PassRange passes, Film& film, RenderCounters& counters) override;

    bool passesAreIndependent() const override { return settings_.rule == RadiusRule::Shared; }
    std::vector<std::byte> saveState() const override;
    void restoreState(std::span<const std::byte> state) override;

  private:
    struct Pass;
    struct EyeSample;
    struct Gathering;
    void addPass(const World& world, const Pass& pass, Film& film, RenderCounters& counters);
    void prepare(const World& world, const Film& film);
    std::unique_ptr<PhotonLookup> makeLookup(PhotonBlocks photons, float sharedFactor);
    void traceEyePaths(const World& world, const Pass& pass, const Film& film, const V2i& first, const V2i& last,
                       Gathering& gathering) const;
    void makeDisks(Gathering& gathering, float sharedFactor) const;
    /// Adds what photons bring to the gathering's samples. \param firstDisk of the gathering's among those of `found`
    void gather(const World& world, Gathering& gathering, const PhotonLookup& lookup, const NearPhotons& found,
                std::size_t firstDisk, const Pass& pass, RenderCounters& counters);
    void gatherInTiles(const World& world, const PhotonLookup& lookup, const Pass& pass, Film& film,
                       RenderCounters& counters);
    void gatherAtOnce(const World& world, const PhotonLookup& lookup, const Pass& pass, Film& film,
                      RenderCounters& counters);
    void addToFilm(const Gathering& gathering, const Pass& pass, Film& film) const;
    Pass makePass(const World& world, std::uint64_t index) const;

    PhotonMappingSettings settings_;
    SamplerSettings sampler_;
    std::optional<PhotonTracer> photonTracer_;
    std::optional<EyePaths> eyePaths_;
    std::uint64_t photonsPerPass_ = 0;
    float typicalRadius_ = 0; ///< of the disks, before they shrink
    /// Of the eye paths of each pixel of the crop window, one after the other. Empty with the shared rule.
    std::vector<PointRadius> radii_;
    V2i radiiMin_{0, 0}, radiiSize_{0, 0};
    PointTree tree_;
};

} // namespace vitrine
