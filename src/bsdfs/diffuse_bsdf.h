// Lambertian reflection.
#pragma once

#include "bsdfs/lobes.h"
#include "core/sampling.h"

namespace vitrine {

/// Reflects the same radiance in every direction, on whichever side the light arrives.
class DiffuseBsdf {
  public:
    explicit DiffuseBsdf(const SampledSpectrum& reflectance) : value_(reflectance * invPi) {}

    float roughness() const { return 1; }
    unsigned lobes() const { return value_.isBlack() ? 0 : lobe::reflection | lobe::diffuse; }
    SampledSpectrum f(const V3f& wo, const V3f& wi, TransportMode) const {
        return wo.z * wi.z > 0 ? value_ : SampledSpectrum();
    }
    float pdf(const V3f& wo, const V3f& wi, TransportMode) const {
        return wo.z * wi.z > 0 ? std::abs(wi.z) * invPi : 0;
    }
    std::optional<BsdfSample> sample(const V3f& wo, float, const V2f& u, TransportMode) const {
        V3f wi = sampleCosineHemisphere(u);
        if (inSurface(wo) || inSurface(wi) || value_.isBlack()) return {};
        const float density = wi.z * invPi;
        wi.z = std::copysign(wi.z, wo.z);
        return BsdfSample{wi, value_, density, lobe::reflection | lobe::diffuse};
    }
    void regularize() {}

  private:
    SampledSpectrum value_; ///< reflectance / pi
};

} // namespace vitrine
