// A thin sheet of glass: a window pane.
#pragma once

#include "bsdfs/fresnel.h"
#include "bsdfs/lobes.h"

namespace vitrine {

/// Both faces of a parallel sheet of relative index eta at once: what is transmitted goes straight on, and all
/// reflections between the faces are summed.
class ThinDielectricBsdf {
  public:
    explicit ThinDielectricBsdf(float eta) : eta_(eta) {}

    float roughness() const { return 0; }
    unsigned lobes() const { return lobe::reflection | lobe::transmission | lobe::specular; }
    SampledSpectrum f(const V3f&, const V3f&, TransportMode) const { return {}; }
    float pdf(const V3f&, const V3f&, TransportMode) const { return 0; }
    std::optional<BsdfSample> sample(const V3f& wo, float uc, const V2f&, TransportMode) const {
        if (inSurface(wo)) return {};
        const float cosine = std::abs(wo.z);
        const float once = fresnelDielectric(std::min(cosine, 1.f), eta_).reflectance;
        // R + T R T + T R^3 T + ... with T = 1 - R; at R = 1 that is 1.
        const float reflectance = 2 * once / (1 + once), transmittance = 1 - reflectance;
        if (uc < reflectance)
            return BsdfSample{V3f(-wo.x, -wo.y, wo.z), SampledSpectrum(reflectance / cosine), reflectance,
                              lobe::reflection | lobe::specular};
        if (!(transmittance > 0)) return {};
        return BsdfSample{-wo, SampledSpectrum(transmittance / cosine), transmittance,
                          lobe::transmission | lobe::specular};
    }
    /// A sheet stays a sheet: as pbrt-v4.
    void regularize() {}

  private:
    float eta_;
};

} // namespace vitrine
