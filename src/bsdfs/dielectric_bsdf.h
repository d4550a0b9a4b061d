// Reflection and refraction at the boundary of two transparent media, polished or rough.
#pragma once

#include "bsdfs/fresnel.h"
#include "bsdfs/lobes.h"
#include "bsdfs/microfacet.h"

namespace vitrine {

/// Glass, water: eta is the index of the inside (below, z < 0) over that of the outside. Smooth when the facets are
/// effectively so or the indices match; else the single scattering of Trowbridge-Reitz facets (Walter et al. 2007).
class DielectricBsdf {
  public:
    explicit DielectricBsdf(float eta, const TrowbridgeReitz& distribution = {})
        : eta_(eta), distribution_(distribution), smooth_(hasNoFacets()) {}

    float roughness() const { return smooth_ ? 0 : distribution_.roughness(); }
    unsigned lobes() const {
        const unsigned sides = eta_ == 1 ? lobe::transmission : lobe::reflection | lobe::transmission;
        return sides | (smooth_ ? lobe::specular : lobe::glossy);
    }
    SampledSpectrum f(const V3f& wo, const V3f& wi, TransportMode mode) const {
        return smooth_ ? SampledSpectrum() : SampledSpectrum(roughValue(wo, wi, mode));
    }
    float pdf(const V3f& wo, const V3f& wi, TransportMode) const { return smooth_ ? 0 : roughPdf(wo, wi); }
    std::optional<BsdfSample> sample(const V3f& wo, float uc, const V2f& u, TransportMode mode) const {
        if (inSurface(wo)) return {};
        return smooth_ ? sampleSmooth(wo, uc, mode) : sampleRough(wo, uc, u, mode);
    }
    void regularize() {
        distribution_.regularize();
        smooth_ = hasNoFacets();
    }

    // For walks between layers, which take the side of the surface as given.

    /// A direction on a given side. f / pdf and, of what is not smooth, f are those of sample(); pdf is per steradian
    /// among directions of that side, 1 where it is smooth.
    struct SideSample {
        V3f wi;
        float f, pdf;
        float chance; ///< of that side, from the facet that was met
    };
    bool isSmooth() const { return smooth_; }
    float eta() const { return eta_; }
    /// \param reflect or else refract
    std::optional<SideSample> sampleSide(const V3f& wo, bool reflect, const V2f& u, TransportMode mode) const;
    /// The density of wi when drawn by sampleSide(wo, ...) for the side that it lies on.
    float sidePdf(const V3f& wo, const V3f& wi) const;

  private:
    struct Facet;

    /// Facets do not matter where they hardly bend: the refracted lobe is narrower than |eta - 1|, and the halfway
    /// vector, whose length it is, has no digits left.
    bool hasNoFacets() const { return distribution_.effectivelySmooth() || std::abs(eta_ - 1) < 1e-4f; }
    /// Index of the far side over that of the side that w is on.
    float etaAcross(const V3f& w) const { return w.z > 0 ? eta_ : 1 / eta_; }

    std::optional<BsdfSample> sampleSmooth(const V3f& wo, float uc, TransportMode mode) const {
        const float cosI = std::abs(wo.z), eta = etaAcross(wo);
        const auto [reflectance, cosT] = fresnelDielectric(std::min(cosI, 1.f), eta);
        if (uc < reflectance)
            return BsdfSample{V3f(-wo.x, -wo.y, wo.z), SampledSpectrum(reflectance / cosI), reflectance,
                              lobe::reflection | lobe::specular};
        const float transmittance = 1 - reflectance;
        if (!(transmittance > 0) || cosT < minCosine) return {};
        const V3f wi(-wo.x / eta, -wo.y / eta, -std::copysign(cosT, wo.z));
        const float scale = mode == TransportMode::Radiance ? 1 / sqr(eta) : 1;
        return BsdfSample{wi, SampledSpectrum(transmittance * scale / cosT), transmittance,
                          lobe::transmission | lobe::specular, eta};
    }
    float roughValue(const V3f& wo, const V3f& wi, TransportMode mode) const;
    float roughPdf(const V3f& wo, const V3f& wi) const;
    /// \param chance if asked for: of the side taken, at the facet met
    std::optional<BsdfSample> sampleRough(const V3f& wo, float uc, const V2f& u, TransportMode mode,
                                          float* chance = nullptr) const;
    bool findFacet(const V3f& wo, const V3f& wi, Facet& facet) const;

    float eta_;
    TrowbridgeReitz distribution_;
    bool smooth_;
};

} // namespace vitrine
