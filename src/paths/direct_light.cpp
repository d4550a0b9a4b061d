#include "paths/direct_light.h"

#include "core/sampling.h"

namespace vitrine {

LightReceiver receiverAt(const Vertex& vertex, const Bsdf& bsdf) {
    // The BSDFs take sides by the shading normal.
    const V3f& n = vertex.frame.n;
    if (bsdf.lobes() & lobe::transmission) return {vertex.point().p, V3f(0, 0, 0), vertex.time};
    return {vertex.point().p, n.dot(vertex.wo) < 0 ? -n : n, vertex.time};
}

SampledSpectrum emittedLight(const World& world, const Walk& walk, const Vertex& vertex, const LastBounce& last) {
    const AreaLight* light = vertex.surface->light;
    if (!light) return SampledSpectrum(0.f);
    const SampledSpectrum emitted = light->emitted(vertex.point(), vertex.wo, walk.lambda());
    if (last.specular || emitted.isBlack()) return emitted;
    const float pdf = world.lights.pdf(last.at, *light, vertex.hit.primitive, vertex.point());
    return emitted * powerHeuristic(last.pdf, pdf);
}

SampledSpectrum escapedLight(const World& world, const Walk& walk, const LastBounce& last) {
    const V3f w = toFloat(walk.ray.d);
    SampledSpectrum sum(0.f);
    for (const Light* light : world.infiniteLights) {
        const float weight = last.specular ? 1.f : powerHeuristic(last.pdf, world.lights.pdf(*light, w));
        sum += light->escaped(w, walk.lambda()) * weight;
    }
    return sum;
}

SampledSpectrum directLight(const World& world, const Walk& walk, const Vertex& vertex, const Bsdf& bsdf,
                            const LightReceiver& at, float uLight, const V2f& u) {
    const auto light = world.lights.sample(at, uLight, u, walk.lambda());
    if (!light) return SampledSpectrum(0.f);
    const V3f wo = vertex.frame.toLocal(vertex.wo), wi = vertex.frame.toLocal(light->wi);
    const SampledSpectrum f = bsdf.f(wo, wi, TransportMode::Radiance) * std::abs(wi.z);
    if (f.isBlack()) return SampledSpectrum(0.f);
    const SampledSpectrum arriving =
        light->l * shadowTransmittance(world, vertex, light->shadow, light->wi, walk.interior(), walk.lambda());
    if (arriving.isBlack()) return SampledSpectrum(0.f);
    const float weight = light->isDelta ? 1.f : powerHeuristic(light->pdf, bsdf.pdf(wo, wi, TransportMode::Radiance));
    return f * arriving * (weight / light->pdf);
}

} // namespace vitrine
