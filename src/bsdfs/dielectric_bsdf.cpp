#include "bsdfs/dielectric_bsdf.h"

namespace vitrine {

/// A facet that sends wo to wi.
struct DielectricBsdf::Facet {
    V3f m;            ///< its normal, in the upper hemisphere
    bool reflects;    ///< or else it refracts
    float cosO, cosI; ///< |wo.m|, |wi.m|
    float eta;        ///< index of wi's side over wo's, where it refracts
    float reflectance;

    /// |dm / dwi| where it refracts (Walter et al. 2007, eq. 17, numerator and denominator over eta^2).
    float refractionJacobian() const { return cosI / sqr(cosI - cosO / eta); }
};

/// False when no facet does.
bool DielectricBsdf::findFacet(const V3f& wo, const V3f& wi, Facet& facet) const {
    if (inSurface(wo) || inSurface(wi)) return false;
    facet.reflects = wo.z * wi.z > 0;
    facet.eta = etaAcross(wo);
    const V3f half = facet.reflects ? wo + wi : wo + wi * facet.eta;
    const float length = std::sqrt(half.length2());
    if (!(length > 0)) return false;
    facet.m = half / std::copysign(length, half.z);
    // Both must see the facet from the side of the surface that they are on.
    const float dotO = wo.dot(facet.m) * std::copysign(1.f, wo.z), dotI = wi.dot(facet.m) * std::copysign(1.f, wi.z);
    if (dotO <= 0 || dotI <= 0) return false;
    facet.cosO = std::min(dotO, 1.f);
    facet.cosI = std::min(dotI, 1.f);
    // Snell's law loses the refracted cosine's digits near the critical angle; the halfway vector has them.
    facet.reflectance = facet.reflects ? fresnelDielectric(facet.cosO, facet.eta).reflectance
                                       : fresnelDielectric(facet.cosO, facet.cosI, facet.eta);
    return facet.reflects || facet.cosI != facet.cosO / facet.eta;
}

// Walter et al. 2007, eq. 20 and 21. Eq. 21 is of radiance: times eta^2 for importance (Veach 1997, eq. 5.12).
float DielectricBsdf::roughValue(const V3f& wo, const V3f& wi, TransportMode mode) const {
    Facet facet;
    if (!findFacet(wo, wi, facet)) return 0;
    const float facets = distribution_.d(facet.m) * distribution_.gOverCosines(wo, wi);
    if (facet.reflects) return facet.reflectance * facets / 4;
    const float scale = mode == TransportMode::Radiance ? 1 / sqr(facet.eta) : 1;
    return (1 - facet.reflectance) * facets * facet.cosO * facet.refractionJacobian() * scale;
}

float DielectricBsdf::roughPdf(const V3f& wo, const V3f& wi) const {
    Facet facet;
    if (!findFacet(wo, wi, facet)) return 0;
    const float facets = distribution_.visibleOverD(wo) * distribution_.d(facet.m);
    if (facet.reflects) return facet.reflectance * facets / 4;
    return (1 - facet.reflectance) * facets * facet.cosO * facet.refractionJacobian();
}

std::optional<BsdfSample> DielectricBsdf::sampleRough(const V3f& wo, float uc, const V2f& u, TransportMode mode,
                                                      float* chance) const {
    Facet facet;
    facet.m = distribution_.sampleVisible(wo, u);
    facet.eta = etaAcross(wo);
    const float side = std::copysign(1.f, wo.z), dotO = wo.dot(facet.m) * side;
    if (!(dotO > 0)) return {};
    facet.cosO = std::min(dotO, 1.f);
    const auto [reflectance, cosT] = fresnelDielectric(facet.cosO, facet.eta);
    const float d = distribution_.d(facet.m);
    if (chance) *chance = uc < reflectance ? reflectance : 1 - reflectance;
    if (uc < reflectance) {
        const V3f wi = reflect(wo, facet.m);
        if (wo.z * wi.z <= 0 || inSurface(wi)) return {};
        const float common = reflectance * d / 4, pdf = common * distribution_.visibleOverD(wo);
        if (!(pdf > 0)) return {};
        return BsdfSample{wi, SampledSpectrum(common * distribution_.gOverCosines(wo, wi)), pdf,
                          lobe::reflection | lobe::glossy};
    }
    facet.cosI = cosT;
    const V3f wi = refract(wo, facet.m * side, facet.eta, facet.cosO, cosT);
    if (wo.z * wi.z >= 0 || inSurface(wi) || facet.cosI == facet.cosO / facet.eta) return {};
    const float common = (1 - reflectance) * d * facet.cosO * facet.refractionJacobian();
    const float pdf = common * distribution_.visibleOverD(wo);
    if (!(pdf > 0)) return {};
    const float scale = mode == TransportMode::Radiance ? 1 / sqr(facet.eta) : 1;
    return BsdfSample{wi, SampledSpectrum(common * distribution_.gOverCosines(wo, wi) * scale), pdf,
                      lobe::transmission | lobe::glossy, facet.eta};
}

std::optional<DielectricBsdf::SideSample> DielectricBsdf::sampleSide(const V3f& wo, bool reflect, const V2f& u,
                                                                     TransportMode mode) const {
    if (inSurface(wo)) return {};
    const float uc = reflect ? -1 : 2; // below and above every reflectance
    float chance = 0;
    const auto s = smooth_ ? sampleSmooth(wo, uc, mode) : sampleRough(wo, uc, u, mode, &chance);
    if (!s) return {};
    if (smooth_) chance = s->pdf;
    if (!(chance > 0)) return {};
    return SideSample{s->wi, s->f[0], s->pdf / chance, chance};
}

float DielectricBsdf::sidePdf(const V3f& wo, const V3f& wi) const {
    Facet facet;
    if (smooth_ || !findFacet(wo, wi, facet)) return 0;
    const float facets = distribution_.visibleOverD(wo) * distribution_.d(facet.m);
    if (facet.reflects) return facet.reflectance > 0 ? facets / 4 : 0;
    return facet.reflectance < 1 ? facets * facet.cosO * facet.refractionJacobian() : 0;
}

} // namespace vitrine
