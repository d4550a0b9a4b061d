#include "bsdfs/coatedconductor_material.h"

namespace vitrine {

CoatedConductorMaterial::CoatedConductorMaterial(MetalIndex metal, FloatInput uroughness, FloatInput vroughness,
                                                 CoatParameters coat)
    : metal_(std::move(metal)),
      facets_(std::move(uroughness), std::move(vroughness), coat.remaproughness, "conductor."),
      coat_(std::move(coat), "interface.") {}

Bsdf CoatedConductorMaterial::bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const {
    const float index = coat_.index(lambda);
    // Also of a metal that is given by its reflectance in air (as pbrt-v4).
    const auto [eta, k] = metal_(point, lambda);
    return coat_.over(ConductorBsdf(facets_(point), eta / index, k / index), index, point, lambda);
}

} // namespace vitrine
