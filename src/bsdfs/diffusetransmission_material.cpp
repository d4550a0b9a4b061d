#include "bsdfs/diffusetransmission_material.h"

#include "bsdfs/parameter_checks.h"

namespace vitrine {

DiffuseTransmissionMaterial::DiffuseTransmissionMaterial(SpectrumInput reflectance, SpectrumInput transmittance,
                                                         float scale)
    : reflectance_(checkedInput("reflectance", std::move(reflectance), std::make_shared<ConstantSpectrum>(0.25f))),
      transmittance_(
          checkedInput("transmittance", std::move(transmittance), std::make_shared<ConstantSpectrum>(0.25f))),
      scale_(checkedNumber("scale", scale, 0).constant()) {}

Bsdf DiffuseTransmissionMaterial::bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const {
    const auto share = [&](const SpectrumInput& input) {
        return mapSpectrum(input(point, lambda), [&](float s) { return std::clamp(scale_ * s, 0.f, 1.f); });
    };
    return DiffuseTransmissionBsdf(share(reflectance_), share(transmittance_));
}

} // namespace vitrine
