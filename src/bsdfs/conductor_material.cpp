#include "bsdfs/conductor_material.h"

#include "bsdfs/parameter_checks.h"

#include <stdexcept>

namespace vitrine {

ConductorMaterial::ConductorMaterial(SpectrumPtr eta, SpectrumPtr k, float uroughness, float vroughness,
                                     bool remaproughness)
    : eta_(checkedMetalIndex("eta", eta ? std::move(eta) : namedSpectrum("metal-Cu-eta"))),
      k_(checkedMetalIndex("k", k ? std::move(k) : namedSpectrum("metal-Cu-k"))),
      facets_(facetsOf(uroughness, vroughness, remaproughness)) {}

ConductorMaterial::ConductorMaterial(ByReflectance, SpectrumPtr reflectance, const TrowbridgeReitz& facets)
    : reflectance_(std::move(reflectance)), facets_(facets) {}

ConductorMaterial ConductorMaterial::fromReflectance(SpectrumPtr reflectance, float uroughness, float vroughness,
                                                     bool remaproughness) {
    if (!reflectance) throw std::invalid_argument("\"reflectance\" is missing");
    return ConductorMaterial(ByReflectance(), checkedSpectrum("reflectance", std::move(reflectance)),
                             facetsOf(uroughness, vroughness, remaproughness));
}

Bsdf ConductorMaterial::bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const {
    if (reflectance_) {
        const auto absorption = [](float r) {
            const float bounded = std::clamp(r, 0.f, 0.9999f); // at 1 k is infinite
            return 2 * std::sqrt(bounded / (1 - bounded));
        };
        return ConductorBsdf(facets_, SampledSpectrum(1), mapSpectrum(reflectance_->sample(lambda), absorption));
    }
    return ConductorBsdf(facets_, eta_->sample(lambda) / point.etaOutside, k_->sample(lambda) / point.etaOutside);
}

} // namespace vitrine
