// RGB colour spaces, and RGB turned into spectra by sigmoids of quadratics (Jakob & Hanika 2019).
#pragma once

#include "spectrum/spectrum.h"

#include <ImathMatrix.h>

namespace vitrine {

using Xyz = V3f;
using Rgb = V3f;

/// sigmoid(c0 lambda^2 + c1 lambda + c2), eq. 3 and 4 of the paper, lambda in nm.
struct SigmoidPolynomial {
    float c0 = 0, c1 = 0, c2 = 0;

    static float sigmoid(float x) {
        if (std::isinf(x)) return x > 0 ? 1.f : 0.f;
        return 0.5f + x / (2 * std::sqrt(1 + x * x));
    }
    float operator()(float lambda) const { return sigmoid((c0 * lambda + c1) * lambda + c2); }
    SampledSpectrum sample(const SampledWavelengths& lambda) const;
    float maxValue() const;
};

/// Primaries, white point and the uplift of one RGB colour space.
class RgbColorSpace {
  public:
    /// "srgb", "rec2020", "aces2065-1", "dci-p3" (pbrt-v4's names); null for another.
    static const RgbColorSpace* named(std::string_view name);
    static const RgbColorSpace& srgb();

    Rgb fromXyz(const Xyz& xyz) const;
    Xyz toXyz(const Rgb& rgb) const;
    /// Coefficients of the reflectance spectrum of rgb, components in [0,1] (clamped).
    SigmoidPolynomial sigmoid(const Rgb& rgb) const;
    /// White point as a spectrum, as pbrt-v4 scales it.
    const DenseSpectrum& illuminant() const;
    const std::string& name() const;

    struct Data;

  private:
    explicit RgbColorSpace(const Data* data) : data_(data) {}
    const Data* data_;
};

/// Reflectance of an RGB colour, components in [0,1].
class RgbAlbedoSpectrum final : public Spectrum {
  public:
    RgbAlbedoSpectrum(const RgbColorSpace& space, const Rgb& rgb) : polynomial_(space.sigmoid(rgb)) {}
    float operator()(float lambda) const override { return polynomial_(lambda); }
    SampledSpectrum sample(const SampledWavelengths& lambda) const override { return polynomial_.sample(lambda); }
    float maxValue() const override { return polynomial_.maxValue(); }

  private:
    SigmoidPolynomial polynomial_;
};

/// Any non-negative RGB (absorption, a metal's k): 2 max(rgb) times the sigmoid of the rest, as pbrt-v4.
class RgbUnboundedSpectrum final : public Spectrum {
  public:
    RgbUnboundedSpectrum(const RgbColorSpace& space, const Rgb& rgb);
    float operator()(float lambda) const override { return scale_ * polynomial_(lambda); }
    SampledSpectrum sample(const SampledWavelengths& lambda) const override {
        return polynomial_.sample(lambda) * scale_;
    }
    float maxValue() const override { return scale_ * polynomial_.maxValue(); }

  private:
    float scale_;
    SigmoidPolynomial polynomial_;
};

/// Emission of an RGB colour: RgbUnboundedSpectrum times the colour space's white.
class RgbIlluminantSpectrum final : public Spectrum {
  public:
    RgbIlluminantSpectrum(const RgbColorSpace& space, const Rgb& rgb);
    float operator()(float lambda) const override { return scale_ * polynomial_(lambda) * (*illuminant_)(lambda); }
    SampledSpectrum sample(const SampledWavelengths& lambda) const override {
        return polynomial_.sample(lambda) * illuminant_->sample(lambda) * scale_;
    }
    float maxValue() const override { return scale_ * polynomial_.maxValue() * illuminant_->maxValue(); }
    const Spectrum& illuminant() const { return *illuminant_; }

  private:
    float scale_;
    SigmoidPolynomial polynomial_;
    const DenseSpectrum* illuminant_;
};

/// Luminance integral that pbrt-v4 divides lights by (SpectrumToPhotometric): of the illuminant alone for an RGB light.
float photometric(const Spectrum& spectrum);

/// XYZ of radiance at sampled wavelengths, divided by their densities (no 1/cieYIntegral: lights carry it).
Xyz sensorXyz(const SampledSpectrum& radiance, const SampledWavelengths& lambda);

} // namespace vitrine
