// What material parameters must be, and what they come to.
#pragma once

#include "bsdfs/microfacet.h"
#include "spectrum/spectrum.h"

#include <string_view>

namespace vitrine {

/// The facets of a material's uroughness, vroughness and remaproughness.
/// \throws std::invalid_argument unless both are finite and not negative.
TrowbridgeReitz facetsOf(float uroughness, float vroughness, bool remaproughness);

/// `spectrum`, or `otherwise` when it is null. `name` is the parameter's.
/// \throws std::invalid_argument when it is negative, not finite or above `most` somewhere in the visible range.
SpectrumPtr checkedSpectrum(std::string_view name, SpectrumPtr spectrum, const SpectrumPtr& otherwise = nullptr,
                            float most = infinity);

/// As checkedSpectrum, for "eta" and "k" of a metal: what is absurdly large is refused.
SpectrumPtr checkedMetalIndex(std::string_view name, SpectrumPtr spectrum);

/// As checkedSpectrum; an index of refraction must also be positive somewhere, and there neither absurdly large nor small.
SpectrumPtr checkedIndex(SpectrumPtr spectrum, const SpectrumPtr& otherwise);

/// The index at the hero wavelength, relative to `etaOutside`. Ends the secondary wavelengths, which would be bent
/// elsewhere, when the index disperses. Where the spectrum has no data it counts as 1 (as pbrt-v4).
inline float relativeIndex(const Spectrum& eta, float etaOutside, SampledWavelengths& lambda) {
    if (!eta.isConstant()) lambda.terminateSecondary();
    const float index = eta(lambda.hero());
    return (index > 0 ? index : 1) / etaOutside;
}

} // namespace vitrine
