// Spectral distributions as the scene gives them.
#pragma once

#include "spectrum/sampled.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// A function of wavelength (nm). Immutable, shared between threads.
class Spectrum {
  public:
    virtual ~Spectrum() = default;
    virtual float operator()(float lambda) const = 0;
    virtual SampledSpectrum sample(const SampledWavelengths& lambda) const {
        return SampledSpectrum((*this)(lambda[0]), (*this)(lambda[1]), (*this)(lambda[2]), (*this)(lambda[3]));
    }
    /// An upper bound over [360, 830] nm.
    virtual float maxValue() const = 0;
    /// Same value at every wavelength (an index of refraction that does not disperse).
    virtual bool isConstant() const { return false; }
};

using SpectrumPtr = std::shared_ptr<const Spectrum>;

class ConstantSpectrum final : public Spectrum {
  public:
    explicit ConstantSpectrum(float value) : value_(value) {}
    float operator()(float) const override { return value_; }
    SampledSpectrum sample(const SampledWavelengths&) const override { return SampledSpectrum(value_); }
    float maxValue() const override { return value_; }
    bool isConstant() const override { return true; }

  private:
    float value_;
};

/// Values at each whole nanometre from 360 to 830; between them the nearest (as pbrt-v4), outside 0. The fastest spectrum
/// to sample: what lights emit should be one.
class DenseSpectrum final : public Spectrum {
  public:
    /// \param values 471 values, one a nanometre. \throws std::invalid_argument for another number
    explicit DenseSpectrum(std::vector<float> values);
    explicit DenseSpectrum(const Spectrum& other);
    float operator()(float lambda) const override;
    SampledSpectrum sample(const SampledWavelengths& lambda) const override;
    float maxValue() const override { return max_; }

  private:
    std::vector<float> values_; ///< with a zero before and behind (nanometre.h)
    float max_ = 0;
};

/// Linear between given (wavelength, value) pairs; zero outside them (as pbrt-v4).
class PiecewiseLinearSpectrum final : public Spectrum {
  public:
    /// \throws std::invalid_argument unless wavelengths ascend strictly, all is finite, and there is at least one pair.
    PiecewiseLinearSpectrum(std::vector<float> lambdas, std::vector<float> values);
    float operator()(float lambda) const override;
    SampledSpectrum sample(const SampledWavelengths& lambda) const override;
    float maxValue() const override { return max_; }
    bool isConstant() const override;

  private:
    bool coversVisible() const;

    std::vector<float> lambdas_, values_;
    std::vector<std::uint32_t> segment_; ///< for each whole nanometre from 360 on, the segment to start the search at
    float max_ = 0;
};

/// Planck's law, scaled to a maximum of 1 (which may lie outside the visible range).
class BlackbodySpectrum final : public Spectrum {
  public:
    /// \throws std::invalid_argument unless kelvin is positive and finite
    explicit BlackbodySpectrum(float kelvin);
    float operator()(float lambda) const override;
    float maxValue() const override { return 1; }

  private:
    double peak_; ///< wavelength of the maximum, nm
};

/// `spectrum` times a constant, not negative.
class ScaledSpectrum final : public Spectrum {
  public:
    ScaledSpectrum(SpectrumPtr spectrum, float scale) : spectrum_(std::move(spectrum)), scale_(scale) {}
    float operator()(float lambda) const override { return scale_ * (*spectrum_)(lambda); }
    SampledSpectrum sample(const SampledWavelengths& lambda) const override {
        return spectrum_->sample(lambda) * scale_;
    }
    float maxValue() const override { return scale_ * spectrum_->maxValue(); }
    bool isConstant() const override { return spectrum_->isConstant(); }
    const Spectrum& spectrum() const { return *spectrum_; }
    float scale() const { return scale_; }

  private:
    SpectrumPtr spectrum_;
    float scale_;
};

/// The integral of a b over [360, 830] nm by the sum over whole nanometres.
double innerProduct(const Spectrum& a, const Spectrum& b);

/// The spectrum known in scene files by `name` (metal-Ag-eta, glass-BK7, stdillum-D65 ...: all of pbrt-v4's but its camera
/// sensors), or null. Illuminants are scaled to the luminance of a constant 1 (integral with cieY = cieYIntegral). Tables
/// go on beyond their ends with the end's value. Glasses are Schott's formulas (pbrt-v4 has tables of them), D50 is CIE's.
SpectrumPtr namedSpectrum(std::string_view name);
/// All names that namedSpectrum knows, sorted.
const std::vector<std::string>& namedSpectra();

/// CIE daylight (the D illuminants) of a colour temperature, as pbrt-v4's: 1 near 560 nm, not normalised to a luminance;
/// `kelvin` is on the scale of the illuminants' names (6500 is D65). Below 4000 K, where CIE defines none, a blackbody.
/// \throws std::invalid_argument unless kelvin is positive and finite
DenseSpectrum daylightSpectrum(float kelvin);

/// CIE 1931 2-degree colour matching functions at each nanometre.
const DenseSpectrum& cieX();
const DenseSpectrum& cieY();
const DenseSpectrum& cieZ();
inline constexpr float cieYIntegral = 106.856895f; ///< integral of cieY over [360, 830] nm

} // namespace vitrine
