#include "integrators/path.h"

#include "integrators/pixel_sample.h"
#include "integrators/tiles.h"
#include "paths/direct_light.h"

namespace vitrine {

namespace {

/// Fixed dimensions of the sample streams: filter and lens, then this many a bounce.
constexpr std::uint32_t cameraDimensions = 2, bounceDimensions = 5;

/// Wavelengths of a pixel's samples: a random start and steps of the golden ratio, whatever the sampler. Any run of samples
/// is spread evenly, so that bright lights do not show colour noise.
class WavelengthRotation {
  public:
    WavelengthRotation(std::uint64_t seed, const V2i& pixel)
        : start_(std::uint32_t(streamKey(0x6c616d626461ull, seed, pixel.x, pixel.y) >> 32)) {}

    float at(std::uint64_t sample) const { return unitFloat(start_ + std::uint32_t(sample) * 0x9e3779b9u); }

  private:
    std::uint32_t start_;
};

} // namespace

SampledSpectrum PathIntegrator::radiance(const World& world, const Ray& ray, const PixelFootprint& footprint,
                                         const SampledWavelengths& lambda, SampleStream& stream,
                                         std::uint64_t& lostExits) const {
    Walk walk = eyeWalk(world, ray, lambda, footprint);
    const SampledSpectrum result = follow(world, walk, stream);
    lostExits += std::uint64_t(walk.lostExits());
    return result;
}

SampledSpectrum PathIntegrator::follow(const World& world, Walk& walk, SampleStream& stream) const {
    SampledSpectrum result(0.f);
    LastBounce last;
    bool regularize = false;
    Vertex vertex;
    for (int depth = 0;;) {
        if (!walk.advance(vertex)) {
            result += walk.beta * escapedLight(world, walk, last);
            return result;
        }
        if (vertex.surface->light) result += walk.beta * emittedLight(world, walk, vertex, last);
        if (!vertex.scatters) {
            walk.passThrough(vertex);
            continue;
        }
        if (depth == settings_.maxDepth) return result;

        Bsdf bsdf = walk.bsdfAt(vertex);
        if (regularize) bsdf.regularize();
        stream.setDimension(cameraDimensions + std::uint32_t(depth) * bounceDimensions);
        ++depth;

        const float uLight = stream.get1D();
        const V2f uDirect = stream.get2D();
        const LightReceiver at = receiverAt(vertex, bsdf);
        if (settings_.nee && bsdf.isNonSpecular() && !world.lights.empty())
            result += walk.beta * directLight(world, walk, vertex, bsdf, at, uLight, uDirect);

        const float uLobe = stream.get1D();
        const auto scattered = walk.scatter(vertex, bsdf, uLobe, stream.get2D());
        if (!scattered) return result;
        // Without next-event estimation nothing competes with running into lights.
        last = {at, scattered->pdf, scattered->specular || !settings_.nee};
        regularize |= settings_.regularize && !scattered->specular;

        // As pbrt-v4: survival by the throughput as it was before refraction squeezed or spread the beam, and without
        // the weight of a hero that stands for all wavelengths.
        const float alone = walk.lambda().secondaryTerminated() ? spectrumSamples : 1;
        const float survival = walk.beta.max() * walk.etaScale / alone;
        if (survival < 1 && depth > settings_.rrDepth) {
            if (stream.get1D() >= survival) return result;
            walk.beta /= survival;
        }
    }
}

void PathIntegrator::addPasses(const World& world, PassRange passes, Film& film, RenderCounters& counters) {
    const FilmSettings& settings = film.settings();
    const auto renderPixel = [&](const V2i& pixel) {
        const WavelengthRotation wavelengths(sampler_.seed, pixel);
        std::uint64_t lostExits = 0;
        for (std::uint64_t pass = passes.begin; pass < passes.end; ++pass) {
            SampleStream stream(sampler_, pixel, pass);
            PixelSample at = samplePixel(film.filter(), pixel, stream);
            if (world.moves) at.camera.time = world.shutter.at(double(timeNumber(stream)));
            const SampledWavelengths lambda = SampledWavelengths::picture(wavelengths.at(pass));
            SampledSpectrum radianceIn(0.f);
            if (const auto camera = world.camera->generate(at.camera)) {
                const PixelFootprint footprint = world.filtersTextures
                                                     ? PixelFootprint::of(*world.camera, at.camera, camera->ray)
                                                     : PixelFootprint();
                radianceIn = radiance(world, camera->ray, footprint, lambda, stream, lostExits) * camera->weight;
            }
            film.add(pixel, radianceIn, lambda, at.weight, unsigned(pass & 1));
        }
        if (lostExits > 0) counters.lostExits.fetch_add(lostExits, std::memory_order_relaxed);
    };
    forEachPixel(settings.cropMin, settings.cropMax, renderPixel, [&](int pixels) {
        counters.samples.fetch_add(std::uint64_t(pixels) * passes.size(), std::memory_order_relaxed);
    });
}

} // namespace vitrine
