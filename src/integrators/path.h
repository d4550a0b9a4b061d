// Path tracing with next-event estimation: the judge of the other integrators.
#pragma once

#include "integrators/integrator.h"
#include "paths/walk.h"

namespace vitrine {

/// Integrator "path", "volpath": path tracing with next-event estimation. The two are the same in scenes without media.
///
/// | name         | type    | unit    | default | meaning |
/// |--------------|---------|---------|---------|---------|
/// | maxdepth     | integer | bounces | 5       | scattering events a path may have |
/// | rrdepth      | integer | bounces | 1       | Russian roulette begins after this many. Not in pbrt-v4, where it is 1 |
/// | regularize   | bool    |         | false   | roughen near-specular surfaces after the first scattering that is not (biased) |
/// | nee          | bool    |         | true    | direct light by sampling lights, combined with BSDF sampling; false: plain path tracing, an oracle. Not in pbrt-v4 |
/// | lightsampler | string  |         | "bvh" of more than 16 lights, else "power" | which light is asked: "uniform": all alike; "power": mostly by power; "bvh": by what each brings to the point, each face of a mesh by itself. "exhaustive" is read as "bvh" |
struct PathSettings {
    int maxDepth = 5;
    int rrDepth = 1;
    bool regularize = false;
    bool nee = true;
};

class PathIntegrator final : public Integrator {
  public:
    PathIntegrator(const PathSettings& settings, const SamplerSettings& sampler)
        : settings_(settings), sampler_(sampler) {}

    void addPasses(const World& world, PassRange passes, Film& film, RenderCounters& counters) override;

    /// Radiance that arrives along `ray` (unit direction), as one sample. Values in secondary wavelengths stay valid
    /// with `lambda` as given, also when the path ended them on its way.
    /// \param lostExits raised by Walk::lostExits()
    SampledSpectrum radiance(const World& world, const Ray& ray, const PixelFootprint& footprint,
                             const SampledWavelengths& lambda, SampleStream& stream, std::uint64_t& lostExits) const;

  private:
    SampledSpectrum follow(const World& world, Walk& walk, SampleStream& stream) const;

    PathSettings settings_;
    SamplerSettings sampler_;
};

} // namespace vitrine
