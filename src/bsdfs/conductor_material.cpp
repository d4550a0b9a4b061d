#include "bsdfs/conductor_material.h"

namespace vitrine {

ConductorMaterial::ConductorMaterial(MetalIndex index, FloatInput uroughness, FloatInput vroughness,
                                     bool remaproughness)
    : index_(std::move(index)), facets_(std::move(uroughness), std::move(vroughness), remaproughness) {}

Bsdf ConductorMaterial::bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const {
    const auto [eta, k] = index_(point, lambda);
    if (index_.isByReflectance()) return ConductorBsdf(facets_(point), eta, k);
    return ConductorBsdf(facets_(point), eta / point.etaOutside, k / point.etaOutside);
}

} // namespace vitrine
