#include "bsdfs/thindielectric_material.h"

#include "bsdfs/parameter_checks.h"

namespace vitrine {

ThinDielectricMaterial::ThinDielectricMaterial(SpectrumPtr eta)
    : eta_(checkedIndex(std::move(eta), std::make_shared<ConstantSpectrum>(1.5f))) {}

Bsdf ThinDielectricMaterial::bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const {
    return ThinDielectricBsdf(relativeIndex(*eta_, point.etaOutside, lambda));
}

} // namespace vitrine
