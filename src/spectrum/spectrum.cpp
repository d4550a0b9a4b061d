#include "spectrum/spectrum.h"

#include "spectrum/nanometre.h"

#include <stdexcept>

namespace vitrine {

// ---- DenseSpectrum

DenseSpectrum::DenseSpectrum(std::vector<float> values) : values_(std::move(values)) {
    if (values_.size() != std::size_t(nanometres))
        throw std::invalid_argument("a dense spectrum has 471 values, one a nanometre from 360 to 830");
    max_ = *std::max_element(values_.begin(), values_.end());
    values_.insert(values_.begin(), 0.f);
    values_.push_back(0.f);
}

DenseSpectrum::DenseSpectrum(const Spectrum& other)
    : DenseSpectrum([&other] {
          std::vector<float> values;
          for (int i = 0; i < nanometres; ++i)
              values.push_back(other(lambdaMin + float(i)));
          return values;
      }()) {}

float DenseSpectrum::operator()(float lambda) const {
    return values_[std::size_t(nanometreSlot(lambda))];
}

SampledSpectrum DenseSpectrum::sample(const SampledWavelengths& lambda) const {
    const SlotLanes slot = nanometreSlot(lambda.lambda().lanes());
    const float* const v = values_.data();
    return SampledSpectrum(v[slot[0]], v[slot[1]], v[slot[2]], v[slot[3]]);
}

// ---- PiecewiseLinearSpectrum

PiecewiseLinearSpectrum::PiecewiseLinearSpectrum(std::vector<float> lambdas, std::vector<float> values)
    : lambdas_(std::move(lambdas)), values_(std::move(values)) {
    if (lambdas_.empty() || lambdas_.size() != values_.size())
        throw std::invalid_argument("a spectrum needs at least one pair of wavelength and value");
    for (std::size_t i = 0; i < lambdas_.size(); ++i) {
        if (!std::isfinite(lambdas_[i]) || !std::isfinite(values_[i]))
            throw std::invalid_argument("the wavelengths and values of a spectrum must be finite");
        if (i > 0 && !(lambdas_[i] > lambdas_[i - 1]))
            throw std::invalid_argument("the wavelengths of a spectrum must increase");
    }
    max_ = *std::max_element(values_.begin(), values_.end());
    if (!coversVisible()) max_ = std::max(max_, 0.f);

    // Where to look for a wavelength: the segment that holds the whole nanometre below it.
    segment_.reserve(nanometres);
    std::uint32_t segment = 0;
    for (int i = 0; i < nanometres; ++i) {
        while (segment + 2 < lambdas_.size() && lambdas_[segment + 1] <= lambdaMin + float(i))
            ++segment;
        segment_.push_back(segment);
    }
}

bool PiecewiseLinearSpectrum::coversVisible() const {
    return lambdas_.front() <= lambdaMin && lambdas_.back() >= lambdaMax;
}

float PiecewiseLinearSpectrum::operator()(float lambda) const {
    if (!(lambda >= lambdas_.front() && lambda <= lambdas_.back())) return 0;
    if (lambdas_.size() == 1) return values_[0];
    std::size_t i = lambda < lambdaMin ? 0 : segment_[std::size_t(std::min(int(lambda - lambdaMin), nanometres - 1))];
    while (i + 2 < lambdas_.size() && lambdas_[i + 1] <= lambda)
        ++i;
    const float t = (lambda - lambdas_[i]) / (lambdas_[i + 1] - lambdas_[i]);
    return lerp(t, values_[i], values_[i + 1]);
}

SampledSpectrum PiecewiseLinearSpectrum::sample(const SampledWavelengths& lambda) const {
    return mapSpectrum(lambda.lambda(), [this](float l) { return PiecewiseLinearSpectrum::operator()(l); });
}

bool PiecewiseLinearSpectrum::isConstant() const {
    const auto differs = [this](float v) { return v != values_.front(); };
    return coversVisible() && std::none_of(values_.begin(), values_.end(), differs);
}

// ---- BlackbodySpectrum

BlackbodySpectrum::BlackbodySpectrum(float kelvin) {
    if (!(kelvin > 0) || !std::isfinite(kelvin))
        throw std::invalid_argument("the temperature of a blackbody must be positive and finite, in kelvin");
    constexpr double wienDisplacement = 2.8977721e6; // nm K
    peak_ = wienDisplacement / double(kelvin);
}

float BlackbodySpectrum::operator()(float lambda) const {
    // Planck's law over its value at the peak: with r = peak / lambda, r^5 (e^x0 - 1) / (e^(x0 r) - 1), where
    // x0 = h c / (k b) is 4.965... (CODATA 2010, as pbrt-v4) at every temperature.
    constexpr double x0 = 6.62606957e-34 * 299792458 / (1.3806488e-23 * 2.8977721e-3);
    const double r = peak_ / double(lambda), x = x0 * r;
    // Beyond this the exponential alone rules, and the fifth power may overflow.
    if (x > 700) return 0;
    return float(r * r * r * r * r * (std::expm1(x0) / std::expm1(x)));
}

// ---- Integrals

double innerProduct(const Spectrum& a, const Spectrum& b) {
    double sum = 0;
    for (int i = 0; i < nanometres; ++i) {
        const float lambda = lambdaMin + float(i);
        sum += double(a(lambda)) * double(b(lambda));
    }
    return sum;
}

} // namespace vitrine
