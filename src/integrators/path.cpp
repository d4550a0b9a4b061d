#include "integrators/path.h"

#include "core/sampling.h"
#include "integrators/tiles.h"

namespace vitrine {

namespace {

/// Fixed dimensions of the sample streams: filter and lens, then this many a bounce.
constexpr std::uint32_t cameraDimensions = 2, bounceDimensions = 5;

/// The last scattering, for weighing light that the path then runs into.
struct LastBounce {
    V3d p;
    float pdf = 0;
    bool specular = true; ///< also for the camera: no light sample competes
};

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

float misWeight(const LastBounce& last, bool nee, float pdfLight) {
    return last.specular || !nee ? 1.f : powerHeuristic(last.pdf, pdfLight);
}

} // namespace

SampledSpectrum PathIntegrator::directLight(const World& world, const Walk& walk, const Vertex& vertex,
                                            const Bsdf& bsdf, float uLight, const V2f& u) const {
    const auto chosen = world.lights.sample(uLight);
    const auto light = chosen.light->sample(vertex.point().p, u, walk.lambda());
    if (!light) return SampledSpectrum(0.f);
    const V3f wo = vertex.frame.toLocal(vertex.wo), wi = vertex.frame.toLocal(light->wi);
    const SampledSpectrum f = bsdf.f(wo, wi, TransportMode::Radiance) * std::abs(wi.z);
    if (f.isBlack()) return SampledSpectrum(0.f);
    const SampledSpectrum arriving =
        light->l * shadowTransmittance(world, vertex, light->shadow, light->wi, walk.interior(), walk.lambda());
    if (arriving.isBlack()) return SampledSpectrum(0.f);
    const float pdfLight = chosen.probability * light->pdf;
    const float weight = light->isDelta ? 1.f : powerHeuristic(pdfLight, bsdf.pdf(wo, wi, TransportMode::Radiance));
    return f * arriving * (weight / pdfLight);
}

SampledSpectrum PathIntegrator::radiance(const World& world, const Ray& ray, const SampledWavelengths& lambda,
                                         SampleStream& stream, std::uint64_t& lostExits) const {
    Walk walk(world, TransportMode::Radiance, lambda,
              world.raysStartApart ? interiorAt(world, ray.o) : world.cameraInterior);
    walk.ray = ray;
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
            const V3f w = toFloat(walk.ray.d);
            for (const Light* light : world.infiniteLights)
                result += walk.beta * light->escaped(w, walk.lambda()) *
                          misWeight(last, settings_.nee, world.lights.probability(light) * light->pdf(w));
            return result;
        }
        if (const AreaLight* light = vertex.surface->light) {
            const SampledSpectrum emitted = light->emitted(vertex.point(), vertex.wo, walk.lambda());
            if (!emitted.isBlack()) {
                float weight = 1;
                if (!last.specular && settings_.nee)
                    weight = misWeight(last, true,
                                       world.lights.probability(light) *
                                           light->pdf(last.p, vertex.hit.primitive, vertex.point()));
                result += walk.beta * emitted * weight;
            }
        }
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
        const bool nonSpecular = bsdf.isNonSpecular();
        if (settings_.nee && nonSpecular && !world.lights.empty())
            result += walk.beta * directLight(world, walk, vertex, bsdf, uLight, uDirect);

        const float uLobe = stream.get1D();
        const auto scattered = walk.scatter(vertex, bsdf, uLobe, stream.get2D());
        if (!scattered) return result;
        last = {vertex.point().p, scattered->pdf, scattered->specular};
        regularize |= settings_.regularize && !scattered->specular;

        // As pbrt-v4: survival by the throughput as it was before refraction squeezed or spread the beam.
        const float survival = walk.beta.max() * walk.etaScale;
        if (survival < 1 && depth > settings_.rrDepth) {
            if (stream.get1D() >= survival) return result;
            walk.beta /= survival;
        }
    }
}

void PathIntegrator::addPasses(const World& world, PassRange passes, Film& film, RenderCounters& counters) const {
    const FilmSettings& settings = film.settings();
    const auto renderPixel = [&](const V2i& pixel) {
        const WavelengthRotation wavelengths(sampler_.seed, pixel);
        std::uint64_t lostExits = 0;
        for (std::uint64_t pass = passes.begin; pass < passes.end; ++pass) {
            SampleStream stream(sampler_, pixel, pass);
            const Filter::Sample filtered = film.filter().sample(stream.get2D());
            const V2f lens = stream.get2D();
            const SampledWavelengths lambda = SampledWavelengths::picture(wavelengths.at(pass));
            const V2d raster(pixel.x + 0.5 + filtered.p.x, pixel.y + 0.5 + filtered.p.y);
            SampledSpectrum radianceIn(0.f);
            if (const auto camera = world.camera->generate({raster, lens}))
                radianceIn = radiance(world, camera->ray, lambda, stream, lostExits) * camera->weight;
            film.add(pixel, radianceIn, lambda, filtered.weight, unsigned(pass & 1));
        }
        if (lostExits > 0) counters.lostExits.fetch_add(lostExits, std::memory_order_relaxed);
    };
    forEachPixel(settings.cropMin, settings.cropMax, renderPixel, [&](int pixels) {
        counters.samples.fetch_add(std::uint64_t(pixels) * passes.size(), std::memory_order_relaxed);
    });
}

} // namespace vitrine
