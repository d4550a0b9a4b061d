// Textures of numbers and of spectra from one text.
#pragma once

#include "textures/texture.h"

namespace vitrine {

/// A texture made of inputs of one kind, FloatInput or SpectrumInput. `Derived` has
///     template <class... Lambda> auto value(const TexturePoint& at, const Lambda&... lambda) const;
/// and looks its inputs up by input(at, lambda...): there are wavelengths for spectra and none for numbers.
template <class Derived, class Input>
class TextureOver;

template <class Derived>
class TextureOver<Derived, FloatInput> : public FloatTexture {
  public:
    float evaluate(const TexturePoint& at) const final { return static_cast<const Derived&>(*this).value(at); }
};

template <class Derived>
class TextureOver<Derived, SpectrumInput> : public SpectrumTexture {
  public:
    SampledSpectrum evaluate(const TexturePoint& at, const SampledWavelengths& lambda) const final {
        return static_cast<const Derived&>(*this).value(at, lambda);
    }
};

} // namespace vitrine
