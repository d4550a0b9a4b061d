#include "bsdfs/fresnel.h"

namespace vitrine {

namespace {

using Lanes = SampledSpectrum::Lanes;

Lanes squareRoot(Lanes x) {
    Lanes r;
    for (int i = 0; i < spectrumSamples; ++i)
        r[i] = std::sqrt(x[i]);
    return r;
}

Lanes atLeast(Lanes x, float low) {
    const Lanes bound = {low, low, low, low};
    return x > bound ? x : bound;
}

} // namespace

// Born & Wolf, Principles of Optics, sec. 14.2, with (a + i b)^2 = (eta + i k)^2 - sin^2: b drops out of the
// reflectances but for a^2 + b^2, so that no complex number is needed and the four wavelengths go side by side.
SampledSpectrum fresnelConductor(float cosI, const SampledSpectrum& eta, const SampledSpectrum& k) {
    constexpr float tiny = std::numeric_limits<float>::min();
    const float cos2 = sqr(cosI), sin2 = std::max(0.f, 1 - cos2);
    const Lanes n = eta.lanes(), nk = n * k.lanes();
    const Lanes difference = n * n - k.lanes() * k.lanes() - sin2;       // a^2 - b^2; and a b = eta k
    const Lanes sum = squareRoot(difference * difference + 4 * nk * nk); // a^2 + b^2
    // The larger of a^2 and b^2 by addition, the other from their product: nothing cancels.
    const Lanes larger = atLeast((sum + (difference < 0 ? -difference : difference)) * 0.5f, tiny);
    const Lanes a = squareRoot(difference < 0 ? nk * nk / larger : larger);

    const Lanes cross = 2 * cosI * a;
    const Lanes perpendicular = (sum + cos2 - cross) / atLeast(sum + cos2 + cross, tiny);
    const Lanes p = cos2 * sum + sqr(sin2), q = cross * sin2;
    const Lanes parallel = perpendicular * ((p - q) / atLeast(p + q, tiny));
    return SampledSpectrum((parallel + perpendicular) * 0.5f);
}

} // namespace vitrine
