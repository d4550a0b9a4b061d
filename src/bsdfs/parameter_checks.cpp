#include "bsdfs/parameter_checks.h"

#include <fmt/format.h>

#include <stdexcept>

namespace vitrine {

namespace {

/// No solid has such an index in visible light, nor its inverse; squares of what lies between are in a float's range.
constexpr float largestIndex = 1e4f;

float alphaOf(float roughness, bool remap) {
    return remap ? TrowbridgeReitz::alphaFromRoughness(roughness) : roughness;
}

} // namespace

Facets::Facets(FloatInput uroughness, FloatInput vroughness, bool remaproughness, const std::string& prefix)
    : u_(checkedNumber(prefix + "uroughness", std::move(uroughness), 0)),
      v_(checkedNumber(prefix + "vroughness", std::move(vroughness), 0)), remap_(remaproughness),
      isConstant_(u_.isConstant() && v_.isConstant()) {
    if (isConstant_) constant_ = {alphaOf(u_.constant(), remap_), alphaOf(v_.constant(), remap_)};
}

TrowbridgeReitz Facets::evaluate(const TexturePoint& at) const {
    const auto alphaAt = [&](const FloatInput& input) {
        const float roughness = input(at);
        if (!(roughness > 0) || !std::isfinite(roughness)) return 0.f;
        return alphaOf(roughness, remap_);
    };
    return {alphaAt(u_), alphaAt(v_)};
}

FloatInput checkedNumber(std::string_view name, FloatInput input, float least, float most) {
    const float value = input.constant();
    if (!input.isConstant() || (value >= least && value <= most && std::isfinite(value))) return input;
    const std::string range = std::isfinite(most) ? fmt::format("lie in [{}, {}]", least, most)
                                                  : fmt::format("be {} or more and finite", least);
    throw std::invalid_argument(fmt::format("\"{}\" is {}, but must {}", name, value, range));
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

SpectrumInput checkedInput(std::string_view name, SpectrumInput input, const SpectrumPtr& otherwise, float most) {
    return input.isConstant() ? checkedSpectrum(name, input.constant(), otherwise, most) : std::move(input);
}

SpectrumInput checkedMetalIndex(std::string_view name, SpectrumInput input) {
    return checkedInput(name, std::move(input), nullptr, largestIndex);
}

SpectrumPtr checkedIndex(SpectrumPtr spectrum, const SpectrumPtr& otherwise, std::string_view name) {
    SpectrumPtr eta = checkedSpectrum(name, std::move(spectrum), otherwise, largestIndex);
    if (!(eta->maxValue() > 0))
        throw std::invalid_argument(fmt::format("\"{}\" is 0, but an index of refraction must be positive", name));
    for (float lambda = lambdaMin; lambda <= lambdaMax; lambda += 1)
        if (const float value = (*eta)(lambda); value > 0 && value < 1 / largestIndex)
            throw std::invalid_argument(
                fmt::format("\"{}\" is {} at {} nm, but must be at least {}", name, value, lambda, 1 / largestIndex));
    return eta;
}

} // namespace vitrine
