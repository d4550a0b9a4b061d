// Light tracing: paths from the lights, connected to the camera at each surface.
#pragma once

#include "integrators/integrator.h"
#include "photons/light_paths.h"

namespace vitrine {

/// Integrator "lightpath": light tracing (Dutre & Willems 1994; Veach 1997, sec. 10.3.4 with paths of one camera vertex).
/// Unbiased for all light that reaches the camera from a surface that is not polished: caustics above all. What is seen
/// in a mirror or through glass stays black. Lights and the sky are seen directly by camera rays.
///
/// | name     | type    | unit    | default       | meaning |
/// |----------|---------|---------|---------------|---------|
/// | maxdepth | integer | bounces | 5             | scattering events a path may have |
/// | photonsperiteration | integer |  | -1         | light paths a pass; -1: as many as the picture has pixels. Not in pbrt-v4 |
/// | iterations | integer |       | the sampler's pixelsamples | passes. Not in pbrt-v4 |
/// | lightsampler | string  |     | "power"       | which light a path starts from: "uniform": all alike; "power", "bvh" or "exhaustive": mostly by power |
/// | seed     | integer |         | the sampler's | other seeds give other noise. Not in pbrt-v4 |
struct LightTracingSettings {
    int maxDepth = 5;
    std::int64_t pathsPerPass = -1;
};

class LightTracingIntegrator final : public Integrator {
  public:
    LightTracingIntegrator(const LightTracingSettings& settings, const SamplerSettings& sampler)
        : settings_(settings), sampler_(sampler) {}

    /// No lights, or nothing that the camera could be connected to.
    void check(const World& world) const override;
    void addPasses(const World& world, PassRange passes, Film& film, RenderCounters& counters) override;

  private:
    struct Splat;
    struct Splats;
    void addSeenLights(const World& world, std::uint64_t pass, const SampledWavelengths& lambda, double time,
                       Film& film, RenderCounters& counters) const;
    void connect(const World& world, const Vertex& vertex, const Bsdf& bsdf, const Walk& walk, int hero,
                 SampleStream& stream, const Film& film, Splats& splats) const;
    /// To every pixel whose filter reaches the point.
    static void splat(const V2d& raster, const SampledSpectrum& value, const Film& film, Splats& splats);
    /// Of the pass's paths those from `first` to before `last`.
    void addLightPaths(const World& world, std::uint64_t pass, std::uint64_t first, std::uint64_t last,
                       const SampledWavelengths& lambda, double time, Film& film, RenderCounters& counters) const;

    LightTracingSettings settings_;
    SamplerSettings sampler_;
    std::optional<LightPaths> paths_;
    std::uint64_t pathsPerPass_ = 0;
};

} // namespace vitrine
