#include "bsdfs/parameter_checks.h"

#include <fmt/format.h>

#include <stdexcept>

namespace vitrine {

namespace {

float alpha(std::string_view name, float roughness, bool remap) {
    if (!(roughness >= 0) || !std::isfinite(roughness))
        throw std::invalid_argument(fmt::format("\"{}\" is {}, but must be 0 or more and finite", name, roughness));
    return remap ? TrowbridgeReitz::alphaFromRoughness(roughness) : roughness;
}

} // namespace

TrowbridgeReitz facetsOf(float uroughness, float vroughness, bool remaproughness) {
    return {alpha("uroughness", uroughness, remaproughness), alpha("vroughness", vroughness, remaproughness)};
}

SpectrumPtr checkedSpectrum(std::string_view name, SpectrumPtr spectrum, const SpectrumPtr& otherwise) {
    if (!spectrum) return otherwise;
    for (float lambda = lambdaMin; lambda <= lambdaMax; lambda += 1) {
        const float value = (*spectrum)(lambda);
        if (!(value >= 0) || !std::isfinite(value))
            throw std::invalid_argument(
                fmt::format("\"{}\" is {} at {} nm, but must be 0 or more and finite", name, value, lambda));
    }
    return spectrum;
}

SpectrumPtr checkedIndex(SpectrumPtr spectrum, const SpectrumPtr& otherwise) {
    SpectrumPtr eta = checkedSpectrum("eta", std::move(spectrum), otherwise);
    if (!(eta->maxValue() > 0))
        throw std::invalid_argument("\"eta\" is 0, but an index of refraction must be positive");
    return eta;
}

} // namespace vitrine
