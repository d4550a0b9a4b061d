#include "integrators/light_tracing.h"

#include "integrators/pixel_sample.h"
#include "integrators/tiles.h"
#include "paths/direct_light.h"
#include "paths/pass_time.h"

namespace vitrine {

namespace {

/// Pixels are added to by strips of so many rows, each by one thread.
constexpr int stripRows = 16;
/// Paths whose splats are kept until they are added: a pass may have many millions. Enough for 64 threads.
constexpr std::uint64_t pathsAtOnce = 64 * pathsOfBlock;

} // namespace

/// What one connection adds to a pixel.
struct LightTracingIntegrator::Splat {
    V2i pixel;
    SampledSpectrum value; ///< in the pass's order of wavelengths
};

/// Of a block of light paths, strip by strip of the picture.
struct LightTracingIntegrator::Splats {
    std::vector<std::vector<Splat>> strips;
    int lostExits = 0;
};

void LightTracingIntegrator::check(const World& world) const {
    if (world.lights.empty()) throw std::invalid_argument("light tracing needs a light: this scene has none");
    if (!hasUnpolishedSurface(world))
        throw std::invalid_argument("light tracing needs a surface that is not polished, to connect it to the camera: "
                                    "this scene has none. The path integrator renders it");
}

/// Lights that the camera sees without anything that scatters between them: one camera ray a pixel.
void LightTracingIntegrator::addSeenLights(const World& world, std::uint64_t pass, const SampledWavelengths& lambda,
                                           double time, Film& film, RenderCounters& counters) const {
    const FilmSettings& settings = film.settings();
    const auto renderPixel = [&](const V2i& pixel) {
        SampleStream stream(sampler_, pixel, pass);
        PixelSample at = samplePixel(film.filter(), pixel, stream);
        at.camera.time = time;
        SampledSpectrum light(0.f);
        if (const auto camera = world.camera->generate(at.camera)) {
            Walk walk = eyeWalk(world, camera->ray, lambda);
            const LastBounce fromCamera;
            Vertex vertex;
            for (;;) {
                if (!walk.advance(vertex)) {
                    light += walk.beta * escapedLight(world, walk, fromCamera);
                    break;
                }
                light += walk.beta * emittedLight(world, walk, vertex, fromCamera);
                if (vertex.scatters) break;
                walk.passThrough(vertex);
            }
            light *= camera->weight;
        }
        // Splats count by the number of passes: a filter with negative lobes must not change what they are divided by.
        film.add(pixel, light * at.weight, lambda, 1, unsigned(pass & 1));
    };
    forEachPixel(settings.cropMin, settings.cropMax, renderPixel,
                 [&](int pixels) { counters.samples.fetch_add(std::uint64_t(pixels), std::memory_order_relaxed); });
}

void LightTracingIntegrator::connect(const World& world, const Vertex& vertex, const Bsdf& bsdf, const Walk& walk,
                                     int hero, SampleStream& stream, const Film& film, Splats& splats) const {
    if (!bsdf.isNonSpecular()) return;
    const SurfacePoint& point = vertex.point();
    const FilmSettings& settings = film.settings();
    const V2f& radius = settings.filter.radius;
    const auto camera = world.camera->connect(point.p, stream.get2D(), radius, vertex.time);
    if (!camera) return;
    const V3f wo = vertex.frame.toLocal(vertex.wo), wi = vertex.frame.toLocal(camera->wi);
    const SampledSpectrum f = bsdf.f(wo, wi, TransportMode::Importance) *
                              (std::abs(wi.z) * shadingNormalCorrection(point, vertex.wo, camera->wi));
    if (f.isBlack()) return;
    // Without a lens rays may come from infinitely far: then there is no lens point to stop at.
    const SampledSpectrum arriving = shadowTransmittance(world, vertex, shadowTo(camera->pLens, point.p), camera->wi,
                                                         walk.interior(), walk.lambda());
    const double pixels = double(settings.resolution.x) * double(settings.resolution.y);
    const double share = double(camera->we) / double(camera->pdf) * pixels / double(pathsPerPass_);
    const SampledSpectrum value = rotatedBack(walk.beta * f * arriving * float(share), hero);
    if (value.isBlack()) return;
    splat(camera->raster, value, film, splats);
    for (const V2d& raster : world.camera->repeated(camera->raster, radius))
        splat(raster, value, film, splats);
}

void LightTracingIntegrator::splat(const V2d& raster, const SampledSpectrum& value, const Film& film, Splats& splats) {
    const FilmSettings& settings = film.settings();
    const V2d reach(settings.filter.radius.x, settings.filter.radius.y);
    const V2d from = raster - reach - V2d(0.5), to = raster + reach - V2d(0.5);
    for (int y = std::max(settings.cropMin.y, int(std::ceil(from.y)));
         y <= std::min(settings.cropMax.y - 1, int(std::floor(to.y))); ++y)
        for (int x = std::max(settings.cropMin.x, int(std::ceil(from.x)));
             x <= std::min(settings.cropMax.x - 1, int(std::floor(to.x))); ++x) {
            const V2d offset = raster - V2d(x + 0.5, y + 0.5);
            const float weight = film.filter()(V2f(float(offset.x), float(offset.y)));
            if (weight != 0)
                splats.strips[std::size_t((y - settings.cropMin.y) / stripRows)].push_back({V2i(x, y), value * weight});
        }
}

void LightTracingIntegrator::addLightPaths(const World& world, std::uint64_t pass, std::uint64_t first,
                                           std::uint64_t last, const SampledWavelengths& lambda, double time,
                                           Film& film, RenderCounters& counters) const {
    const auto strips = std::size_t((film.settings().cropSize().y + stripRows - 1) / stripRows);
    const auto blocks = traceInBlocks(
        last - first, Splats{std::vector<std::vector<Splat>>(strips)}, [&](std::uint64_t path, Splats& splats) {
            splats.lostExits += paths_->follow(
                pass, first + path, lambda, time,
                [&](const Vertex& vertex, const Bsdf& bsdf, const Walk& walk, const LightPaths::Arrival& arrival,
                    SampleStream& stream) { connect(world, vertex, bsdf, walk, arrival.hero, stream, film, splats); });
        });
    // No pixel belongs to two strips, so nothing is locked; the film's sums do not depend on order.
    tbb::parallel_for(std::size_t(0), strips, [&](std::size_t strip) {
        const PlainArithmetic plain;
        for (const Splats& splats : blocks)
            for (const Splat& splat : splats.strips[strip])
                film.addSplat(splat.pixel, splat.value, lambda, unsigned(pass & 1));
    });
    for (const Splats& splats : blocks)
        counters.lostExits.fetch_add(std::uint64_t(splats.lostExits), std::memory_order_relaxed);
    counters.photonPaths.fetch_add(last - first, std::memory_order_relaxed);
}

void LightTracingIntegrator::addPasses(const World& world, PassRange passes, Film& film, RenderCounters& counters) {
    if (!paths_) {
        pathsPerPass_ = pathsOfPass(settings_.pathsPerPass, film.settings());
        paths_.emplace(world, settings_.maxDepth, sampler_);
    }
    for (std::uint64_t pass = passes.begin; pass < passes.end; ++pass) {
        const SampledWavelengths lambda = passWavelengths(pass, sampler_.seed);
        film.addPassWavelengths(lambda);
        const double time = passTime(world.shutter, pass, sampler_.seed);
        addSeenLights(world, pass, lambda, time, film, counters);
        for (std::uint64_t first = 0; first < pathsPerPass_; first += pathsAtOnce)
            addLightPaths(world, pass, first, std::min(first + pathsAtOnce, pathsPerPass_), lambda, time, film,
                          counters);
    }
}

} // namespace vitrine
