#include "photons/light_paths.h"

namespace vitrine {

namespace {

/// Paths of a pass are drawn from one long sequence, which strata of a pixel's samples would not suit.
SamplerSettings forPaths(SamplerSettings sampler) {
    if (sampler.kind == SamplerKind::Stratified) sampler.kind = SamplerKind::Sobol;
    return sampler;
}

} // namespace

bool hasUnpolishedSurface(const World& world) {
    const auto isUnpolished = [](const Surface& surface) {
        return !surface.isInterface() && !surface.material->isPolished();
    };
    return std::any_of(world.surfaces.begin(), world.surfaces.end(), isUnpolished);
}

LightPaths::LightPaths(const World& world, int maxVertices, const SamplerSettings& sampler)
    : world_(world), maxVertices_(maxVertices), sampler_(forPaths(sampler)) {
    if (!world.hasNestedDielectrics && !world.hasAbsorption) return;
    // Looking for the solids round each path's start costs two rays or more. Lights that no surface of a solid divides spare
    // it. Where solids are open, so that rays beside each other find others, the trials tell.
    constexpr int trials = 64;
    const SampledWavelengths lambda = SampledWavelengths::visible(0.5f);
    for (std::size_t i = 0; i < world.undividedLights.size(); ++i) {
        if (!world.undividedLights[i]) continue;
        const Light* light = world.lights.lights()[i].get();
        RandomStream random(sampler.seed, i);
        std::optional<InteriorStack> common;
        bool same = true;
        for (int trial = 0; trial < trials && same; ++trial) {
            const V2f uPosition(random.uniform(), random.uniform()), uDirection(random.uniform(), random.uniform());
            const auto emission = light->emit(uPosition, uDirection, lambda);
            if (!emission) continue;
            const InteriorStack here = interiorAt(world, emission->ray.o);
            same = !common || here == *common;
            common = here;
        }
        if (common && same) interiors_.emplace(light, *common);
    }
}

SampleStream LightPaths::stream(std::uint64_t pass, std::uint64_t path) const {
    // In place of a pixel: the pass, with a mark on its high bits that no pixel's coordinate has.
    const V2i key(int(std::uint32_t(pass)), int(std::uint32_t(pass >> 32)) - (1 << 30));
    return SampleStream(sampler_, key, path);
}

InteriorStack LightPaths::interiorRound(const Light* light, const Ray& ray) const {
    if (!world_.hasNestedDielectrics && !world_.hasAbsorption) return {};
    const auto known = interiors_.find(light);
    return known == interiors_.end() ? interiorAt(world_, ray.o, ray.time) : known->second;
}

} // namespace vitrine
