#include "spectrum/sampled.h"

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

SampledWavelengths SampledWavelengths::uniform(float u) {
    SampledWavelengths result;
    result.lambda_ = SampledSpectrum(clampToRange(lambdaMin + (lambdaMax - lambdaMin) * stratify(u)));
    result.pdf_ = SampledSpectrum(1 / (lambdaMax - lambdaMin));
    return result;
}

} // namespace vitrine
