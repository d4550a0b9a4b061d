// Lambertian reflection and transmission: paper, leaves, lamp shades.
#pragma once

#include "bsdfs/lobes.h"
#include "core/sampling.h"

namespace vitrine {

/// A thin sheet that sends the same radiance in every direction of a side, of each side its own share.
class DiffuseTransmissionBsdf {
  public:
    DiffuseTransmissionBsdf(const SampledSpectrum& reflectance, const SampledSpectrum& transmittance)
        : reflected_(reflectance * invPi), transmitted_(transmittance * invPi) {}

    float roughness() const { return 1; }
    unsigned lobes() const {
        const unsigned sides =
            (reflected_.isBlack() ? 0 : lobe::reflection) | (transmitted_.isBlack() ? 0 : lobe::transmission);
        return sides ? sides | lobe::diffuse : 0;
    }
    SampledSpectrum f(const V3f& wo, const V3f& wi, TransportMode) const {
        return wo.z * wi.z > 0 ? reflected_ : transmitted_;
    }
    float pdf(const V3f& wo, const V3f& wi, TransportMode) const {
        const float chance = reflectionChance();
        return (wo.z * wi.z > 0 ? chance : 1 - chance) * std::abs(wi.z) * invPi;
    }
    std::optional<BsdfSample> sample(const V3f& wo, float uc, const V2f& u, TransportMode) const {
        V3f wi = sampleCosineHemisphere(u);
        if (inSurface(wo) || inSurface(wi) || lobes() == 0) return {};
        const float chance = reflectionChance(), density = wi.z * invPi;
        const bool reflects = uc < chance;
        wi.z = std::copysign(wi.z, reflects ? wo.z : -wo.z);
        if (reflects) return BsdfSample{wi, reflected_, density * chance, lobe::reflection | lobe::diffuse};
        return BsdfSample{wi, transmitted_, density * (1 - chance), lobe::transmission | lobe::diffuse};
    }
    void regularize() {}

  private:
    float reflectionChance() const {
        const float r = reflected_.max(), t = transmitted_.max();
        return r + t > 0 ? r / (r + t) : 0.5f;
    }

    SampledSpectrum reflected_, transmitted_; ///< shares / pi
};

} // namespace vitrine
