#include "bsdfs/parameter_checks.h"

#include <fmt/format.h>

#include <stdexcept>

namespace vitrine {

namespace {

/// No solid has such an index in visible light, nor its inverse; squares of what lies between are in a float's range.
constexpr float largestIndex = 1e4f;

float alpha(std::string_view name, float roughness, bool remap) {
    if (!(roughness >= 0) || !std::isfinite(roughness))
        throw std::invalid_argument(fmt::format("\"{}\" is {}, but must be 0 or more and finite", name, roughness));
    return remap ? TrowbridgeReitz::alphaFromRoughness(roughness) : roughness;
}

} // namespace

TrowbridgeReitz facetsOf(float uroughness, float vroughness, bool remaproughness) {
    return {alpha("uroughness", uroughness, remaproughness), alpha("vroughness", vroughness, remaproughness)};
}

SpectrumPtr checkedSpectrum(std::string_view name, SpectrumPtr spectrum, const SpectrumPtr& otherwise, float most) {
    if (!spectrum) return otherwise;
    for (float lambda = lambdaMin; lambda <= lambdaMax; lambda += 1) {
        const float value = (*spectrum)(lambda);
        if (!(value >= 0) || !std::isfinite(value))
            throw std::invalid_argument(
                fmt::format("\"{}\" is {} at {} nm, but must be 0 or more and finite", name, value, lambda));
        if (value > most)
            throw std::invalid_argument(
                fmt::format("\"{}\" is {} at {} nm, but may be at most {}", name, value, lambda, most));
    }
    return spectrum;
}

SpectrumPtr checkedMetalIndex(std::string_view name, SpectrumPtr spectrum) {
    return checkedSpectrum(name, std::move(spectrum), nullptr, largestIndex);
}

SpectrumPtr checkedIndex(SpectrumPtr spectrum, const SpectrumPtr& otherwise) {
    SpectrumPtr eta = checkedSpectrum("eta", std::move(spectrum), otherwise, largestIndex);
    if (!(eta->maxValue() > 0))
        throw std::invalid_argument("\"eta\" is 0, but an index of refraction must be positive");
    for (float lambda = lambdaMin; lambda <= lambdaMax; lambda += 1)
        if (const float value = (*eta)(lambda); value > 0 && value < 1 / largestIndex)
            throw std::invalid_argument(
                fmt::format("\"eta\" is {} at {} nm, but must be at least {}", value, lambda, 1 / largestIndex));
    return eta;
}

} // namespace vitrine
