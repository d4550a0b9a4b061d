#include "bsdfs/dielectric_material.h"

namespace vitrine {

DielectricMaterial::DielectricMaterial(Interior interior, FloatInput uroughness, FloatInput vroughness,
                                       bool remaproughness)
    : interior_(std::move(interior)), facets_(std::move(uroughness), std::move(vroughness), remaproughness) {
    interior_.eta = checkedIndex(std::move(interior_.eta), std::make_shared<ConstantSpectrum>(1.5f));
    interior_.absorption = checkedSpectrum("absorption", std::move(interior_.absorption));
}

Bsdf DielectricMaterial::bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const {
    const float outside = interior_.priority ? point.etaOutside : 1;
    return DielectricBsdf(relativeIndex(*interior_.eta, outside, lambda), facets_(point));
}

} // namespace vitrine
