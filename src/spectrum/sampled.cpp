#include "spectrum/sampled.h"

#include "spectrum/spectrum.h"

#include <array>

namespace vitrine {

namespace {

using Lanes = SampledSpectrum::Lanes;

/// u, u + 1/4, u + 2/4, u + 3/4, those from 1 on less 1.
Lanes stratify(float u) {
    const Lanes shifted = u + Lanes{0, 0.25f, 0.5f, 0.75f};
    const Lanes zero{};
    const Lanes wrapped = shifted >= zero + 1 ? shifted - 1 : shifted;
    return wrapped;
}

Lanes clampToRange(Lanes lambda) {
    const Lanes low = Lanes{} + lambdaMin, high = Lanes{} + lambdaMax;
    lambda = lambda > low ? lambda : low;
    return lambda < high ? lambda : high;
}

} // namespace

SampledWavelengths SampledWavelengths::visible(float u) {
    // The inverse of the distribution is 538 - artanh(t)/0.0072 with t falling from tanh(0.0072 (538 - 360)) to
    // -tanh(0.0072 (830 - 538)); its density 1/cosh^2 is 1 - t^2 over the integral.
    constexpr float tFirst = 0.85691062f, tRange = 1.82750197f;
    const Lanes t = tFirst - tRange * stratify(u);
    const Lanes ratio = (1 + t) / (1 - t);
    Lanes lambda;
    for (int i = 0; i < spectrumSamples; ++i)
        lambda[i] = 538 - (0.5f / 0.0072f) * std::log(ratio[i]);

    SampledWavelengths result;
    result.lambda_ = SampledSpectrum(clampToRange(lambda));
    result.pdf_ = SampledSpectrum((0.0072f / tRange) * (1 - t * t));
    return result;
}

namespace {

/// The density of SampledWavelengths::picture, constant over each nanometre, with the inverse of its distribution.
class PictureDensity {
  public:
    PictureDensity() {
        // Rows of the matrix from XYZ to linear sRGB (IEC 61966-2-1).
        constexpr double toRgb[3][3] = {{3.2404542, -1.5371385, -0.4985314},
                                        {-0.9692660, 1.8760108, 0.0415560},
                                        {0.0556434, -0.2040259, 1.0572252}};
        std::array<double, bins> lengths;
        double sum = 0;
        for (int k = 0; k < bins; ++k) {
            const float lambda = lambdaMin + float(k) + 0.5f;
            const double xyz[3] = {cieX()(lambda), cieY()(lambda), cieZ()(lambda)};
            double length2 = 0;
            for (const auto& row : toRgb)
                length2 += sqr(row[0] * xyz[0] + row[1] * xyz[1] + row[2] * xyz[2]);
            sum += lengths[std::size_t(k)] = std::sqrt(length2);
        }
        constexpr double uniformPart = 0.25;
        double cdf = 0;
        for (std::size_t k = 0; k < bins; ++k) {
            first_[k] = float(cdf);
            pdf_[k] = float((1 - uniformPart) * lengths[k] / sum + uniformPart / bins);
            cdf += pdf_[k];
        }
        first_[bins] = 2;
        // At most one bin begins within a step of the guide.
        static_assert(uniformPart / bins > 1. / guides);
        for (std::size_t i = 0, k = 0; i < guides; ++i) {
            while (k + 1 < bins && first_[k + 1] <= float(i) / guides)
                ++k;
            guide_[i] = std::uint16_t(k);
        }
    }

    void sample(float u, float& lambda, float& pdf) const {
        std::size_t k = guide_[std::min(std::size_t(u * guides), std::size_t(guides - 1))];
        k += first_[k + 1] <= u;
        pdf = pdf_[k];
        lambda = lambdaMin + float(k) + std::min((u - first_[k]) / pdf, 1.f);
    }

  private:
    static constexpr int bins = 470, guides = 2048;
    std::array<float, bins + 1> first_;       ///< distribution at the bin's beginning; behind the last one 2
    std::array<float, bins> pdf_;             ///< density per nm
    std::array<std::uint16_t, guides> guide_; ///< the bin in which u = i / guides lies
};

} // namespace

SampledWavelengths SampledWavelengths::picture(float u) {
    static const PictureDensity density;
    const Lanes strata = stratify(u);
    SampledWavelengths result;
    for (int i = 0; i < spectrumSamples; ++i) {
        float lambda, pdf;
        density.sample(strata[i], lambda, pdf);
        result.lambda_.set(i, lambda);
        result.pdf_.set(i, pdf);
    }
    return result;
}

SampledWavelengths SampledWavelengths::rotated(int by) const {
    SampledWavelengths result;
    result.lambda_ = vitrine::rotated(lambda_, by);
    result.pdf_ = vitrine::rotated(pdf_, by);
    return result;
}

SampledWavelengths SampledWavelengths::uniform(float u) {
    SampledWavelengths result;
    result.lambda_ = SampledSpectrum(clampToRange(lambdaMin + (lambdaMax - lambdaMin) * stratify(u)));
    result.pdf_ = SampledSpectrum(1 / (lambdaMax - lambdaMin));
    return result;
}

} // namespace vitrine
