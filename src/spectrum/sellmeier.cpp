#include "spectrum/sellmeier.h"

namespace vitrine {

template <class T>
T SellmeierSpectrum::squaredIndex(T lambda) const {
    const T l = lambda * 1e-3f, l2 = l * l;
    const auto& [p, q, r] = terms_;
    return 1 + (p.b * l2 / (l2 - p.c) + q.b * l2 / (l2 - q.c) + r.b * l2 / (l2 - r.c));
}

float SellmeierSpectrum::operator()(float lambda) const {
    return std::sqrt(squaredIndex(lambda));
}

SampledSpectrum SellmeierSpectrum::sample(const SampledWavelengths& lambda) const {
    SampledSpectrum::Lanes n = squaredIndex(lambda.lambda().lanes());
    for (int i = 0; i < spectrumSamples; ++i)
        n[i] = std::sqrt(n[i]);
    return SampledSpectrum(n);
}

} // namespace vitrine
