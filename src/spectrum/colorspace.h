// RGB colour spaces, and RGB turned into spectra by sigmoids of quadratics (Jakob & Hanika 2019).
#pragma once

#include "spectrum/spectrum.h"

#include <array>
#include <span>

namespace vitrine {

using Xyz = V3f;
using Rgb = V3f;

/// sigmoid(c0 lambda^2 + c1 lambda + c2), eq. 3 and 4 of the paper, lambda in nm. c2 may be infinite: exactly 0 or 1.
struct SigmoidPolynomial {
    float c0 = 0, c1 = 0, c2 = 0;

    /// 1/2 + x / (2 sqrt(1 + x^2)), by way of the smaller of it and its complement: 1 / (2 r (r + |x|)), r = sqrt(1 + x^2),
    /// has no cancellation for dark colours and goes to 0 by itself when x does to infinity.
    static float sigmoid(float x) {
        const float r = std::sqrt(1 + x * x);
        const float tail = 0.5f / (r * (r + std::abs(x)));
        return x < 0 ? tail : 1 - tail;
    }
    float operator()(float lambda) const { return sigmoid((c0 * lambda + c1) * lambda + c2); }
    SampledSpectrum sample(const SampledWavelengths& lambda) const {
        using Lanes = SampledSpectrum::Lanes;
        const Lanes l = lambda.lambda().lanes(), zero{};
        const Lanes x = (c0 * l + c1) * l + c2;
        Lanes r = 1 + x * x;
        for (int i = 0; i < spectrumSamples; ++i)
            r[i] = std::sqrt(r[i]);
        const Lanes tail = 0.5f / (r * (r + (x < zero ? -x : x)));
        return SampledSpectrum(x < zero ? tail : 1 - tail);
    }
    /// The largest value over [360, 830] nm.
    float maxValue() const;
};

/// Primaries, white point and the uplift of one RGB colour space.
class RgbColorSpace {
  public:
    /// "srgb", "rec2020", "aces2065-1", "dci-p3" (pbrt-v4's names, in any case); null for another.
    static const RgbColorSpace* named(std::string_view name);
    static const RgbColorSpace& srgb();
    /// The one with these x and y of red, green, blue and white to three digits; null for others.
    static const RgbColorSpace* withChromaticities(std::span<const float, 8> xy);

    Rgb fromXyz(const Xyz& xyz) const;
    Xyz toXyz(const Rgb& rgb) const;
    /// Coefficients of the reflectance spectrum of rgb, components in [0,1] (clamped): from a table for sRGB (some 0.1 us),
    /// by optimisation for the others (some 20 us; colours that no reflectance has get the nearest in CIELAB).
    SigmoidPolynomial sigmoid(const Rgb& rgb) const;
    /// White point as a spectrum of luminance 1 (integral with cieY = cieYIntegral), as pbrt-v4.
    const DenseSpectrum& illuminant() const;
    const std::string& name() const;
    /// CIE xy of red, green, blue and white.
    const std::array<V2f, 4>& chromaticities() const;

    struct Data;

  private:
    explicit RgbColorSpace(const Data& data) : data_(&data) {}
    friend struct RgbColorSpaces;
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

/// What pbrt-v4 divides lights by (its SpectrumToPhotometric): the integral with cieY; for an RGB light that of its
/// illuminant alone, cieYIntegral, so that the RGB scales the light. A ScaledSpectrum keeps its factor.
///
/// The convention of radiance throughout: lights emit L(lambda) = scale * spectrum / photometric(spectrum), and
/// sensorXyz() integrates with the matching functions without 1/cieYIntegral. A light of `rgb L [80 80 80]` or of a named
/// illuminant times 80 then has luminance 80, and the former shows as 80, 80, 80 in its own colour space.
float photometric(const Spectrum& spectrum);

/// XYZ estimated from radiance at sampled wavelengths: the mean of matching functions times radiance over density, where
/// the density is not 0 (pbrt-v4's cie1931 sensor at an imaging ratio of 1).
Xyz sensorXyz(const SampledSpectrum& radiance, const SampledWavelengths& lambda);

} // namespace vitrine
