// What material parameters must be, and what they come to.
#pragma once

#include "bsdfs/microfacet.h"
#include "textures/texture.h"

#include <string>
#include <string_view>

namespace vitrine {

/// The facets of a material's uroughness, vroughness and remaproughness.
class Facets {
  public:
    /// Of textures what is negative or not finite counts as 0.
    /// \throws std::invalid_argument unless constants are finite and not negative.
    /// \param prefix of the parameters' names in messages
    Facets(FloatInput uroughness, FloatInput vroughness, bool remaproughness, const std::string& prefix = "");

    TrowbridgeReitz operator()(const TexturePoint& at) const { return isConstant_ ? constant_ : evaluate(at); }
    /// Everywhere.
    bool isPolished() const { return isConstant_ && constant_.effectivelySmooth(); }
    bool isFiltered() const { return u_.isFiltered() || v_.isFiltered(); }

  private:
    TrowbridgeReitz evaluate(const TexturePoint& at) const;

    FloatInput u_, v_;
    bool remap_, isConstant_;
    TrowbridgeReitz constant_;
};

/// `spectrum`, or `otherwise` when it is null. `name` is the parameter's.
/// \throws std::invalid_argument when it is negative, not finite or above `most` somewhere in the visible range.
SpectrumPtr checkedSpectrum(std::string_view name, SpectrumPtr spectrum, const SpectrumPtr& otherwise = nullptr,
                            float most = infinity);

/// As checkedSpectrum, where a texture may stand: what that gives is bounded where it is used.
SpectrumInput checkedInput(std::string_view name, SpectrumInput input, const SpectrumPtr& otherwise = nullptr,
                           float most = infinity);

/// As checkedInput, for "eta" and "k" of a metal: what is absurdly large is refused.
SpectrumInput checkedMetalIndex(std::string_view name, SpectrumInput input);

/// A number that may be a texture, what that gives is bounded where it is used.
/// \throws std::invalid_argument unless a constant lies in [least, most] and is finite.
FloatInput checkedNumber(std::string_view name, FloatInput input, float least, float most = infinity);

/// As checkedSpectrum; an index of refraction must also be positive somewhere, and there neither absurdly large nor small.
SpectrumPtr checkedIndex(SpectrumPtr spectrum, const SpectrumPtr& otherwise, std::string_view name = "eta");

/// The index at the hero wavelength, relative to `etaOutside`. Ends the secondary wavelengths, which would be bent
/// elsewhere, when the index disperses. Where the spectrum has no data it counts as 1 (as pbrt-v4).
inline float relativeIndex(const Spectrum& eta, float etaOutside, SampledWavelengths& lambda) {
    if (!eta.isConstant()) lambda.terminateSecondary();
    const float index = eta(lambda.hero());
    return (index > 0 ? index : 1) / etaOutside;
}

} // namespace vitrine
