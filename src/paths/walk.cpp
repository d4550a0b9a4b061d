#include "paths/walk.h"

#include "textures/footprint.h"

namespace vitrine {

namespace {

/// A path that passes this many surfaces without scattering is caught in coincident ones.
constexpr int maxPasses = 10000;
/// Textures are filtered over this part of a pixel's side: the picture's own filter does the rest with many samples. A
/// constant, as what a pass shows must not depend on how many there are.
constexpr double filteredShare = 0.25;

} // namespace

Walk eyeWalk(const World& world, const Ray& ray, const SampledWavelengths& lambda, const PixelFootprint& footprint) {
    Walk walk(world, TransportMode::Radiance, lambda,
              world.raysStartApart ? interiorAt(world, ray.o, ray.time) : world.cameraInterior);
    walk.ray = ray;
    walk.footprint = footprint;
    return walk;
}

float shadingNormalCorrection(const SurfacePoint& point, const V3f& wo, const V3f& wi) {
    const float numerator = absDot(wo, point.ns) * absDot(wi, point.ng);
    const float denominator = absDot(wo, point.ng) * absDot(wi, point.ns);
    return denominator > 0 ? numerator / denominator : 0;
}

SampledSpectrum transmittance(const Interior* interior, double distance, const SampledWavelengths& lambda) {
    if (!interior || !interior->absorption) return SampledSpectrum(1.f);
    const SampledSpectrum sigma = interior->absorption->sample(lambda);
    // 0 x infinity: a clear wavelength stays clear over any distance.
    return mapSpectrum(sigma, [&](float s) { return s > 0 ? std::exp(-s * float(distance)) : 1.f; });
}

void Walk::passThrough(const Vertex& vertex) {
    const V3f d = -vertex.wo;
    if (const Interior* interior = vertex.surface->interior()) interior_.cross(*interior, d.dot(vertex.point().ng) < 0);
    ray = Ray{offsetOrigin(vertex.point(), d), ray.d, ray.tMax - vertex.hit.s, ray.time};
}

bool Walk::advance(Vertex& vertex) {
    for (int i = 0; i < maxPasses; ++i) {
        const bool met = world_.caster->intersect(ray, vertex.hit);
        if (world_.hasAbsorption && !interior_.empty())
            beta *= transmittance(interior_.current(), met ? vertex.hit.s : infinityD, lambda_);
        if (!met) {
            // A closed solid does not let a path escape inside it.
            if (const Interior* solid = interior_.current()) lostExits_ += solid->priority.has_value();
            return false;
        }
        distance_ += vertex.hit.s;
        const SurfacePoint& point = vertex.hit.point;
        vertex.surface = &world_.surfaces[vertex.hit.id];
        vertex.wo = -toFloat(ray.d);
        vertex.time = ray.time;

        const Interior* interior = vertex.surface->interior();
        vertex.crossing = {};
        if (interior && interior->priority) {
            vertex.crossing = interior_.crossing(*interior, vertex.wo.dot(point.ng) > 0);
            lostExits_ += vertex.crossing.isLost;
        } else if (!interior)
            vertex.crossing.outside = interior_.current();

        vertex.scatters = !vertex.surface->isInterface() && vertex.crossing.isReal;
        if (vertex.scatters) {
            vertex.frame = Frame(point.ns, point.dpdu);
            if (vertex.surface->hasDetail()) addDetail(vertex);
        }
        if (vertex.scatters || vertex.surface->light) return true;
        passThrough(vertex);
    }
    return false;
}

MaterialPoint Walk::materialPoint(const Vertex& vertex) const {
    const SurfacePoint& point = vertex.point();
    MaterialPoint at;
    at.p = point.p;
    at.ng = point.ng;
    at.uv = point.uv;
    at.wo = vertex.wo;
    if (vertex.surface->filtersTextures())
        if (const double side = pixelSide(); side > 0) spreadOver(point, vertex.wo, float(side * filteredShare), at);
    return at;
}

void Walk::addDetail(Vertex& vertex) const {
    const MaterialPoint at = materialPoint(vertex);
    const SurfaceDetail* detail = vertex.surface->material->resolve(at, lambda_).detail();
    if (!detail) return;
    const ShadingDirections directions = detail->shade(vertex.point(), at);
    vertex.hit.point.ns = directions.n;
    vertex.frame = Frame(directions.n, directions.tangent);
}

Bsdf Walk::bsdfAt(const Vertex& vertex) {
    const bool wasWhole = !lambda_.secondaryTerminated();
    MaterialPoint at = materialPoint(vertex);
    if (const Interior* outside = vertex.crossing.outside; outside && outside->priority) {
        at.etaOutside = (*outside->eta)(lambda_.hero());
        // A conductor or a diffuse surface does not bend light: only a dielectric's angle depends on wavelength.
        if (!outside->eta->isConstant() && vertex.surface->interior()) lambda_.terminateSecondary();
    }
    Bsdf bsdf = vertex.surface->material->bsdf(at, lambda_);
    if (wasWhole && lambda_.secondaryTerminated()) beta = SampledSpectrum(beta[0] * spectrumSamples, 0, 0, 0);
    return bsdf;
}

std::optional<Scattered> Walk::scatter(const Vertex& vertex, const Bsdf& bsdf, float uc, const V2f& u) {
    const V3f wo = vertex.frame.toLocal(vertex.wo);
    const auto sample = bsdf.sample(wo, uc, u, mode_);
    if (!sample) return {};
    const V3f wi = vertex.frame.toWorld(sample->wi);
    const SurfacePoint& point = vertex.point();

    const float outgoing = vertex.wo.dot(point.ng), incoming = wi.dot(point.ng);
    if (const Interior* interior = vertex.surface->interior()) {
        // Where the shading normal tilts a refraction back to its own side, or a reflection through the surface, the
        // path would be in a solid that it never entered.
        if (sample->isTransmission() != (outgoing * incoming < 0)) return {};
        if (sample->isTransmission()) interior_.cross(*interior, incoming < 0);
    }
    beta *= sample->f * (std::abs(sample->wi.z) / sample->pdf);
    if (mode_ == TransportMode::Importance) beta *= shadingNormalCorrection(point, vertex.wo, wi);
    if (sample->isTransmission()) etaScale *= sqr(sample->eta);
    if (beta.isBlack()) return {};
    ray = Ray{offsetOrigin(point, wi), toDouble(wi), infinityD, ray.time};
    return Scattered{wi, sample->pdf, sample->isSpecular(), sample->isTransmission()};
}

SampledSpectrum shadowTransmittance(const World& world, const Vertex& vertex, const Ray& toLight, const V3f& wi,
                                    const InteriorStack& interior, const SampledWavelengths& lambda) {
    const V3d start = offsetOrigin(vertex.point(), wi);
    // A finite shadow ray ends where the light sampler said, wherever it starts.
    Ray shadow{start, toLight.d, toLight.tMax, vertex.time};
    const bool ends = std::isfinite(shadow.tMax);
    const V3d target = vertex.point().p + toLight.d;
    if (ends) shadow.d = target - start;
    if (!world.hasNestedDielectrics && !world.hasAbsorption)
        return SampledSpectrum(world.caster->occluded(shadow) ? 0.f : 1.f);

    InteriorStack solids = interior;
    const float incoming = wi.dot(vertex.point().ng);
    const Interior* own = vertex.surface->interior();
    if (own && incoming * vertex.wo.dot(vertex.point().ng) < 0) solids.cross(*own, incoming < 0);
    if (!world.hasNestedDielectrics) {
        if (world.caster->occluded(shadow)) return SampledSpectrum(0.f);
        return transmittance(solids.current(), shadow.tMax * shadow.d.length(), lambda);
    }

    SampledSpectrum result(1.f);
    for (int i = 0; i < maxPasses; ++i) {
        CasterHit hit;
        const bool met = world.caster->intersect(shadow, hit);
        result *= transmittance(solids.current(), (met ? hit.s : shadow.tMax) * shadow.d.length(), lambda);
        if (!met) return result;
        const Surface& surface = world.surfaces[hit.id];
        const Interior* solid = surface.interior();
        const bool entering = wi.dot(hit.point.ng) < 0;
        const bool overruled = solid && !solids.crossing(*solid, entering).isReal;
        if (!surface.isInterface() && !overruled) break;
        if (solid) solids.cross(*solid, entering);
        shadow.o = offsetOrigin(hit.point, wi);
        if (!ends) continue;
        const V3d o = shadow.o;
        shadow = shadowTo(target, o);
        shadow.o = o;
        shadow.time = vertex.time;
        // What was met may lie next to the target, and the offset have led past it.
        if (shadow.d.dot(toLight.d) <= 0) return result;
    }
    return SampledSpectrum(0.f);
}

} // namespace vitrine
