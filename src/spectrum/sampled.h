// Four wavelengths a path carries and values at them. Hero wavelength spectral sampling: Wilkie et al. 2014.
#pragma once

#include "core/vec.h"

namespace vitrine {

inline constexpr int spectrumSamples = 4;
inline constexpr float lambdaMin = 360, lambdaMax = 830; ///< nm

/// Values at the four wavelengths of a path (radiance, throughput, reflectance ...).
class SampledSpectrum {
  public:
    using Lanes [[gnu::vector_size(16)]] = float;

    SampledSpectrum() : v_{0, 0, 0, 0} {}
    explicit SampledSpectrum(float c) : v_{c, c, c, c} {}
    SampledSpectrum(float a, float b, float c, float d) : v_{a, b, c, d} {}
    explicit SampledSpectrum(Lanes v) : v_(v) {}

    float operator[](int i) const { return v_[i]; }
    void set(int i, float value) { v_[i] = value; }
    Lanes lanes() const { return v_; }

    SampledSpectrum& operator+=(const SampledSpectrum& o) { return v_ += o.v_, *this; }
    SampledSpectrum& operator-=(const SampledSpectrum& o) { return v_ -= o.v_, *this; }
    SampledSpectrum& operator*=(const SampledSpectrum& o) { return v_ *= o.v_, *this; }
    SampledSpectrum& operator*=(float s) { return v_ *= s, *this; }
    SampledSpectrum& operator/=(float s) { return v_ /= s, *this; }
    friend SampledSpectrum operator+(SampledSpectrum a, const SampledSpectrum& b) { return a += b; }
    friend SampledSpectrum operator-(SampledSpectrum a, const SampledSpectrum& b) { return a -= b; }
    friend SampledSpectrum operator*(SampledSpectrum a, const SampledSpectrum& b) { return a *= b; }
    friend SampledSpectrum operator*(SampledSpectrum a, float s) { return a *= s; }
    friend SampledSpectrum operator*(float s, SampledSpectrum a) { return a *= s; }
    friend SampledSpectrum operator/(SampledSpectrum a, float s) { return a /= s; }
    friend SampledSpectrum operator/(const SampledSpectrum& a, const SampledSpectrum& b) {
        return SampledSpectrum(a.v_ / b.v_);
    }

    float max() const { return std::max(std::max(v_[0], v_[1]), std::max(v_[2], v_[3])); }
    float min() const { return std::min(std::min(v_[0], v_[1]), std::min(v_[2], v_[3])); }
    float average() const { return (v_[0] + v_[1] + v_[2] + v_[3]) * 0.25f; }
    bool isBlack() const { return v_[0] == 0 && v_[1] == 0 && v_[2] == 0 && v_[3] == 0; }
    bool isFinite() const {
        return std::isfinite(v_[0]) && std::isfinite(v_[1]) && std::isfinite(v_[2]) && std::isfinite(v_[3]);
    }

  private:
    Lanes v_;
};

/// Entry i becomes entry i - by, those below 0 come in again at the end. \param by 0 to 3
inline SampledSpectrum rotated(const SampledSpectrum& s, int by) {
    using Indices [[gnu::vector_size(16)]] = std::int32_t;
    return SampledSpectrum(__builtin_shuffle(s.lanes(), (Indices{0, 1, 2, 3} + by) & 3));
}

/// What rotated() did, undone.
inline SampledSpectrum rotatedBack(const SampledSpectrum& s, int by) {
    return rotated(s, (4 - by) & 3);
}

template <class F>
SampledSpectrum mapSpectrum(const SampledSpectrum& s, F&& f) {
    return SampledSpectrum(f(s[0]), f(s[1]), f(s[2]), f(s[3]));
}

/// a / b where b is not zero, else 0.
inline SampledSpectrum safeDivide(const SampledSpectrum& a, const SampledSpectrum& b) {
    const SampledSpectrum::Lanes zero{};
    return SampledSpectrum(b.lanes() != zero ? a.lanes() / b.lanes() : zero);
}

/// The wavelengths of a path (nm) and their densities (1/nm). Entry 0 is the hero.
class SampledWavelengths {
  public:
    /// Stratified, importance sampled for the eye: density proportional to 1/cosh^2(0.0072 (lambda - 538)) on
    /// [360, 830] (Radziszewski et al. 2009, as pbrt-v4). \param u uniform in [0,1)
    static SampledWavelengths visible(float u);
    /// Stratified, importance sampled for pictures in linear sRGB: the density is three parts of the length of the
    /// vector of sRGB's colour matching functions and one part uniform on [360, 830]. Four strata of it show a third of
    /// the colour noise of visible(), and a hero alone three quarters (docs/decisions.md). \param u uniform in [0,1)
    static SampledWavelengths picture(float u);
    /// Uniform on [360, 830], stratified.
    static SampledWavelengths uniform(float u);

    float operator[](int i) const { return lambda_[i]; }
    const SampledSpectrum& lambda() const { return lambda_; }
    const SampledSpectrum& pdf() const { return pdf_; }
    float hero() const { return lambda_[0]; }
    /// The same with entry `by` (0 to 3) as the hero: a path whose hero is chosen among the four of its pass.
    SampledWavelengths rotated(int by) const;
    bool secondaryTerminated() const { return pdf_[1] == 0 && pdf_[2] == 0 && pdf_[3] == 0; }
    /// The path goes on with its hero wavelength alone, weighted once (a dispersive interface was met).
    void terminateSecondary() {
        if (secondaryTerminated()) return;
        pdf_ = SampledSpectrum(pdf_[0] / spectrumSamples, 0, 0, 0);
    }

  private:
    SampledSpectrum lambda_, pdf_;
};

} // namespace vitrine
