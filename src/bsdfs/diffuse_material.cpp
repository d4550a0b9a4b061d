#include "bsdfs/diffuse_material.h"

#include "bsdfs/parameter_checks.h"

namespace vitrine {

DiffuseMaterial::DiffuseMaterial(SpectrumInput reflectance)
    : reflectance_(checkedInput("reflectance", std::move(reflectance), std::make_shared<ConstantSpectrum>(0.5f))) {}

Bsdf DiffuseMaterial::bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const {
    return DiffuseBsdf(mapSpectrum(reflectance_(point, lambda), [](float r) { return std::clamp(r, 0.f, 1.f); }));
}

} // namespace vitrine
