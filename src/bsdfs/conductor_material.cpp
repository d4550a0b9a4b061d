#include "bsdfs/conductor_material.h"

#include <stdexcept>

namespace vitrine {

ConductorMaterial::ConductorMaterial(SpectrumInput eta, SpectrumInput k, FloatInput uroughness, FloatInput vroughness,
                                     bool remaproughness)
    : eta_(checkedMetalIndex("eta", eta ? std::move(eta) : SpectrumInput(namedSpectrum("metal-Cu-eta")))),
      k_(checkedMetalIndex("k", k ? std::move(k) : SpectrumInput(namedSpectrum("metal-Cu-k")))),
      facets_(std::move(uroughness), std::move(vroughness), remaproughness) {}

ConductorMaterial::ConductorMaterial(ByReflectance, SpectrumInput reflectance, Facets facets)
    : reflectance_(std::move(reflectance)), facets_(std::move(facets)) {}

ConductorMaterial ConductorMaterial::fromReflectance(SpectrumInput reflectance, FloatInput uroughness,
                                                     FloatInput vroughness, bool remaproughness) {
    if (!reflectance) throw std::invalid_argument("\"reflectance\" is missing");
    return ConductorMaterial(ByReflectance(), checkedInput("reflectance", std::move(reflectance)),
                             Facets(std::move(uroughness), std::move(vroughness), remaproughness));
}

Bsdf ConductorMaterial::bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const {
    if (reflectance_) {
        const auto absorption = [](float r) {
            const float bounded = std::clamp(r, 0.f, 0.9999f); // at 1 k is infinite
            return 2 * std::sqrt(bounded / (1 - bounded));
        };
        return ConductorBsdf(facets_(point), SampledSpectrum(1), mapSpectrum(reflectance_(point, lambda), absorption));
    }
    return ConductorBsdf(facets_(point), eta_(point, lambda) / point.etaOutside, k_(point, lambda) / point.etaOutside);
}

} // namespace vitrine
