#include "photons/radius_schedule.h"

namespace vitrine {

namespace {

/// log(Gamma(n + 1 + alpha) / Gamma(n + 2)), to 1e-10 for n of 64 and above (Tricomi & Erdelyi 1951): the difference of two
/// large logarithms would lose digits.
double logGammaRatio(double n, double alpha) {
    const double power = alpha - 1, w = n + 1 + alpha / 2;
    return power * std::log(w) + std::log1p(-power * (power * power - 1) / (24 * w * w));
}

} // namespace

float sharedRadiusFactor(std::uint64_t pass, double alpha) {
    if (alpha == 1) return 1;
    // The product of (k + alpha) / (k + 1) over k from 1 to pass: the first factors one by one, the others by the gamma
    // function, so that a pass far on costs no more than an early one.
    constexpr std::uint64_t oneByOne = 64;
    double product = 1;
    for (std::uint64_t k = 1; k <= std::min(pass, oneByOne); ++k)
        product *= (double(k) + alpha) / (double(k) + 1);
    if (pass > oneByOne)
        product *= std::exp(logGammaRatio(double(pass), alpha) - logGammaRatio(double(oneByOne), alpha));
    return float(std::sqrt(product));
}

} // namespace vitrine
