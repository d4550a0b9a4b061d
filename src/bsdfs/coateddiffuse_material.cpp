#include "bsdfs/coateddiffuse_material.h"

namespace vitrine {

CoatedDiffuseMaterial::CoatedDiffuseMaterial(SpectrumInput reflectance, CoatParameters coat)
    : reflectance_(checkedInput("reflectance", std::move(reflectance), std::make_shared<ConstantSpectrum>(0.5f))),
      coat_(std::move(coat)) {}

Bsdf CoatedDiffuseMaterial::bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const {
    const float index = coat_.index(lambda);
    const auto reflectance = mapSpectrum(reflectance_(point, lambda), [](float r) { return std::clamp(r, 0.f, 1.f); });
    return coat_.over(DiffuseBsdf(reflectance), index, point, lambda);
}

} // namespace vitrine
