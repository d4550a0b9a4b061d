#include "bsdfs/metal_index.h"

#include <stdexcept>

namespace vitrine {

MetalIndex::MetalIndex(SpectrumInput eta, SpectrumInput k, const std::string& prefix)
    : eta_(checkedMetalIndex(prefix + "eta", eta ? std::move(eta) : SpectrumInput(namedSpectrum("metal-Cu-eta")))),
      k_(checkedMetalIndex(prefix + "k", k ? std::move(k) : SpectrumInput(namedSpectrum("metal-Cu-k")))) {}

MetalIndex MetalIndex::ofReflectance(SpectrumInput reflectance) {
    if (!reflectance) throw std::invalid_argument("\"reflectance\" is missing");
    return MetalIndex(ByReflectance(), checkedInput("reflectance", std::move(reflectance)));
}

MetalIndex::Value MetalIndex::operator()(const TexturePoint& at, const SampledWavelengths& lambda) const {
    if (!reflectance_) return {eta_(at, lambda), k_(at, lambda)};
    const auto absorption = [](float r) {
        const float bounded = std::clamp(r, 0.f, 0.9999f); // at 1 k is infinite
        return 2 * std::sqrt(bounded / (1 - bounded));
    };
    return {SampledSpectrum(1), mapSpectrum(reflectance_(at, lambda), absorption)};
}

} // namespace vitrine
