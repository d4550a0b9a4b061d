#include "bsdfs/conductor_bsdf.h"

namespace vitrine {

namespace {

/// The normal, in the upper hemisphere, of the facets that reflect wo to wi; empty when there is none.
std::optional<V3f> facet(const V3f& wo, const V3f& wi) {
    if (wo.z * wi.z <= 0 || inSurface(wo) || inSurface(wi)) return {};
    const V3f half = wo + wi;
    const float length = std::sqrt(half.length2());
    if (!(length > 0)) return {};
    return half / std::copysign(length, half.z);
}

} // namespace

// Torrance-Sparrow: F D G / (4 |cos wo| |cos wi|) (Walter et al. 2007, eq. 20).
SampledSpectrum ConductorBsdf::f(const V3f& wo, const V3f& wi, TransportMode) const {
    if (distribution_.effectivelySmooth()) return {};
    const std::optional<V3f> m = facet(wo, wi);
    if (!m) return {};
    return fresnelConductor(std::min(absDot(wo, *m), 1.f), eta_, k_) *
           (distribution_.d(*m) * distribution_.gOverCosines(wo, wi) / 4);
}

// Visible normals, times |dm / dwi| = 1 / (4 |wo.m|), which cancels their |wo.m|.
float ConductorBsdf::pdf(const V3f& wo, const V3f& wi, TransportMode) const {
    if (distribution_.effectivelySmooth()) return 0;
    const std::optional<V3f> m = facet(wo, wi);
    if (!m) return 0;
    return distribution_.visibleOverD(wo) * distribution_.d(*m) / 4;
}

std::optional<BsdfSample> ConductorBsdf::sampleRough(const V3f& wo, const V2f& u) const {
    const V3f m = distribution_.sampleVisible(wo, u);
    const V3f wi = reflect(wo, m);
    // Below the horizon: the light would meet another facet, which this model leaves out.
    if (wo.z * wi.z <= 0 || inSurface(wi)) return {};
    const float density = distribution_.d(m) / 4;
    const SampledSpectrum f =
        fresnelConductor(std::min(absDot(wo, m), 1.f), eta_, k_) * (density * distribution_.gOverCosines(wo, wi));
    const float pdf = density * distribution_.visibleOverD(wo);
    if (f.isBlack() || !(pdf > 0)) return {};
    return BsdfSample{wi, f, pdf, lobe::reflection | lobe::glossy};
}

} // namespace vitrine
