#include "bsdfs/diffuse_material.h"

#include "bsdfs/parameter_checks.h"

namespace vitrine {

DiffuseMaterial::DiffuseMaterial(SpectrumPtr reflectance)
    : reflectance_(checkedSpectrum("reflectance", std::move(reflectance), std::make_shared<ConstantSpectrum>(0.5f))) {}

Bsdf DiffuseMaterial::bsdf(const MaterialPoint&, SampledWavelengths& lambda) const {
    return DiffuseBsdf(mapSpectrum(reflectance_->sample(lambda), [](float r) { return std::clamp(r, 0.f, 1.f); }));
}

} // namespace vitrine
