// Reflection off metal, polished or rough.
#pragma once

#include "bsdfs/fresnel.h"
#include "bsdfs/lobes.h"
#include "bsdfs/microfacet.h"

namespace vitrine {

/// A metal surface of complex index eta + i k relative to what surrounds it: a mirror when effectively smooth, else the
/// single scattering of Trowbridge-Reitz facets (what would scatter between facets is lost, as in pbrt-v4).
class ConductorBsdf {
  public:
    ConductorBsdf(const TrowbridgeReitz& distribution, const SampledSpectrum& eta, const SampledSpectrum& k)
        : eta_(eta), k_(k), distribution_(distribution) {}

    float roughness() const { return distribution_.roughness(); }
    unsigned lobes() const {
        return lobe::reflection | (distribution_.effectivelySmooth() ? lobe::specular : lobe::glossy);
    }
    SampledSpectrum f(const V3f& wo, const V3f& wi, TransportMode mode) const;
    float pdf(const V3f& wo, const V3f& wi, TransportMode mode) const;
    std::optional<BsdfSample> sample(const V3f& wo, float, const V2f& u, TransportMode) const {
        if (inSurface(wo)) return {};
        return distribution_.effectivelySmooth() ? sampleSmooth(wo) : sampleRough(wo, u);
    }
    void regularize() { distribution_.regularize(); }

  private:
    std::optional<BsdfSample> sampleSmooth(const V3f& wo) const {
        const float cosine = std::abs(wo.z);
        const SampledSpectrum f = fresnelConductor(std::min(cosine, 1.f), eta_, k_) / cosine;
        if (f.isBlack()) return {};
        return BsdfSample{V3f(-wo.x, -wo.y, wo.z), f, 1, lobe::reflection | lobe::specular};
    }
    std::optional<BsdfSample> sampleRough(const V3f& wo, const V2f& u) const;

    SampledSpectrum eta_, k_;
    TrowbridgeReitz distribution_;
};

} // namespace vitrine
