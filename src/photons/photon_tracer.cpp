#include "photons/photon_tracer.h"

#include "core/plain_arithmetic.h"
#include "paths/pass_wavelengths.h"
#include "photons/gather_point.h"

#include <tbb/parallel_for.h>

namespace vitrine {

namespace {

/// Dimensions of the sample streams: which light, where, which way; then this many a scattering.
constexpr std::uint32_t emissionDimensions = 3, bounceDimensions = 3;

/// In place of a pixel in the streams' keys: the high bits of the pass, and a mark that no pixel has.
V2i streamOf(std::uint64_t pass) {
    return V2i(int(std::uint32_t(pass)), int(std::uint32_t(pass >> 32)) - (1 << 30));
}

/// Photons are drawn from one long sequence a pass, which strata of a pixel's samples would not suit.
SamplerSettings forPhotons(SamplerSettings sampler) {
    if (sampler.kind == SamplerKind::Stratified) sampler.kind = SamplerKind::Sobol;
    return sampler;
}

} // namespace

struct PhotonTracer::Block {
    std::vector<Photon> photons;
    std::uint64_t landedPaths = 0, lostExits = 0;
};

PhotonTracer::PhotonTracer(const World& world, const PhotonSettings& settings, const SamplerSettings& sampler)
    : world_(world), space_(world), settings_(settings), sampler_(forPhotons(sampler)) {
    if (!world.hasNestedDielectrics && !world.hasAbsorption) return;
    // Looking for the solids round each photon's start costs two rays or more. Lights that lie in one and the same all
    // over, by a sample of their rays, spare it.
    constexpr int trials = 64;
    const SampledWavelengths lambda = SampledWavelengths::visible(0.5f);
    for (const LightPtr& light : world.lights.lights()) {
        RandomStream random(sampler.seed, interiors_.size());
        std::optional<InteriorStack> common;
        bool same = true;
        for (int i = 0; i < trials && same; ++i) {
            const V2f uPosition(random.uniform(), random.uniform()), uDirection(random.uniform(), random.uniform());
            const auto emission = light->emit(uPosition, uDirection, lambda);
            if (!emission) continue;
            const InteriorStack here = interiorAt(world, emission->ray.o);
            same = !common || here == *common;
            common = here;
        }
        if (common && same) interiors_.emplace(light.get(), *common);
    }
}

const InteriorStack* PhotonTracer::interiorOf(const Light* light) const {
    const auto found = interiors_.find(light);
    return found == interiors_.end() ? nullptr : &found->second;
}

void PhotonTracer::tracePath(std::uint64_t pass, std::uint64_t path, const SampledWavelengths& lambda,
                             Block& block) const {
    SampleStream stream(sampler_, streamOf(pass), path);
    const auto chosen = world_.lights.sample(stream.get1D());
    const V2f uPosition = stream.get2D(), uDirection = stream.get2D();
    const int hero = heroOf(path, pass);
    const SampledWavelengths own = lambda.rotated(hero);
    const auto emission = chosen.light->emit(uPosition, uDirection, own);
    if (!emission) return;
    InteriorStack interior;
    if (world_.hasNestedDielectrics || world_.hasAbsorption) {
        const InteriorStack* known = interiorOf(chosen.light);
        interior = known ? *known : interiorAt(world_, emission->ray.o);
    }
    Walk walk(world_, TransportMode::Importance, own, interior);
    walk.ray = emission->ray;
    walk.beta = emission->power / chosen.probability;

    const int deepest = std::min(settings_.maxDepth - 1, Photon::maxDepth);
    const std::size_t before = block.photons.size();
    Vertex vertex;
    for (int depth = 0; depth <= deepest && walk.advance(vertex);) {
        if (!vertex.scatters) {
            walk.passThrough(vertex);
            continue;
        }
        const Bsdf bsdf = walk.bsdfAt(vertex);
        if ((depth > 0 || settings_.keepDirect) && gatherProbability(bsdf) > 0)
            block.photons.emplace_back(space_.fromWorld(vertex.point().p), vertex.wo, depth,
                                       rotatedBack(walk.beta, hero));
        if (depth == deepest) break;
        stream.setDimension(emissionDimensions + std::uint32_t(depth) * bounceDimensions);
        ++depth;
        const float power = walk.beta.average();
        const float uLobe = stream.get1D();
        if (!walk.scatter(vertex, bsdf, uLobe, stream.get2D())) break;
        // Survival by what the scattering left keeps the power of photons even: many alike serve better than a few strong.
        const float survival = walk.beta.average() / power;
        if (survival < 1) {
            if (stream.get1D() >= survival) break;
            walk.beta /= survival;
        }
    }
    block.landedPaths += block.photons.size() > before;
    block.lostExits += std::uint64_t(walk.lostExits());
}

PhotonPass PhotonTracer::trace(std::uint64_t pass, const SampledWavelengths& lambda) const {
    // Blocks are the same for any number of threads, and put together in order.
    constexpr std::uint64_t blockSize = 4096;
    std::vector<Block> blocks((settings_.paths + blockSize - 1) / blockSize);
    tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t b) {
        const PlainArithmetic plain;
        blocks[b].photons.reserve(2 * blockSize);
        for (std::uint64_t i = b * blockSize; i < std::min(settings_.paths, (b + 1) * blockSize); ++i)
            tracePath(pass, i, lambda, blocks[b]);
    });

    PhotonPass result;
    result.paths = settings_.paths;
    std::vector<std::size_t> starts;
    std::size_t count = 0;
    for (const Block& block : blocks) {
        starts.push_back(count);
        count += block.photons.size();
        result.landedPaths += block.landedPaths;
        result.lostExits += block.lostExits;
    }
    result.photons.resize(count);
    tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t b) {
        std::copy(blocks[b].photons.begin(), blocks[b].photons.end(),
                  result.photons.begin() + std::ptrdiff_t(starts[b]));
        std::vector<Photon>().swap(blocks[b].photons);
    });
    return result;
}

} // namespace vitrine
