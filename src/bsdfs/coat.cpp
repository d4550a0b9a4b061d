#include "bsdfs/coat.h"

#include <fmt/format.h>

#include <stdexcept>

namespace vitrine {

namespace {

std::uint16_t checkedCount(const char* name, int value, int least) {
    constexpr int most = std::numeric_limits<std::uint16_t>::max();
    if (value < least || value > most)
        throw std::invalid_argument(fmt::format("\"{}\" is {}, but must lie in [{}, {}]", name, value, least, most));
    return std::uint16_t(value);
}

} // namespace

Coat::Coat(CoatParameters p, const std::string& prefix)
    : eta_(checkedIndex(std::move(p.eta), std::make_shared<ConstantSpectrum>(1.5f), prefix + "eta")),
      facets_(std::move(p.uroughness), std::move(p.vroughness), p.remaproughness, prefix),
      thickness_(checkedNumber("thickness", std::move(p.thickness), 0)),
      albedo_(checkedInput("albedo", std::move(p.albedo), std::make_shared<ConstantSpectrum>(0.f))),
      g_(checkedNumber("g", std::move(p.g), -1, 1)), maxDepth_(checkedCount("maxdepth", p.maxdepth, 0)),
      samples_(checkedCount("nsamples", p.nsamples, 1)),
      isEmpty_(albedo_.isConstant() && !(albedo_.constant()->maxValue() > 0)) {}

CoatMedium Coat::medium(const TexturePoint& at, const SampledWavelengths& lambda) const {
    CoatMedium medium;
    const float thickness = thickness_(at), g = g_(at);
    medium.thickness = thickness > 0 ? thickness : 0;
    if (!isEmpty_)
        medium.albedo = mapSpectrum(albedo_(at, lambda), [](float a) { return a > 0 ? std::min(a, 1.f) : 0; });
    medium.g = std::isfinite(g) ? std::clamp(g, -1.f, 1.f) : 0;
    medium.maxDepth = maxDepth_;
    medium.samples = samples_;
    return medium;
}

} // namespace vitrine
