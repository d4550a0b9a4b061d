#include "spectrum/colorspace.h"
#include "spectrum/nanometre.h"

#include <array>

namespace vitrine {

namespace {

#include "spectrum/data/cie1931.inc"

using Lanes = SampledSpectrum::Lanes;

/// X, Y, Z and nothing, side by side: a wavelength's three values in one load.
struct alignas(64) MatchingTable {
    std::array<Lanes, nanometreSlots> xyz{};

    constexpr MatchingTable() {
        for (std::size_t i = 0; i < std::size_t(nanometres); ++i)
            xyz[i + 1] = Lanes{cie1931x[i], cie1931y[i], cie1931z[i], 0};
    }
};
constinit const MatchingTable matching;

} // namespace

const DenseSpectrum& cieX() {
    static const DenseSpectrum x(std::vector<float>(std::begin(cie1931x), std::end(cie1931x)));
    return x;
}

const DenseSpectrum& cieY() {
    static const DenseSpectrum y(std::vector<float>(std::begin(cie1931y), std::end(cie1931y)));
    return y;
}

const DenseSpectrum& cieZ() {
    static const DenseSpectrum z(std::vector<float>(std::begin(cie1931z), std::end(cie1931z)));
    return z;
}

float photometric(const Spectrum& spectrum) {
    if (const auto* scaled = dynamic_cast<const ScaledSpectrum*>(&spectrum))
        return scaled->scale() * photometric(scaled->spectrum());
    if (const auto* rgb = dynamic_cast<const RgbIlluminantSpectrum*>(&spectrum)) return photometric(rgb->illuminant());
    return float(innerProduct(cieY(), spectrum));
}

Xyz sensorXyz(const SampledSpectrum& radiance, const SampledWavelengths& lambda) {
    const Lanes weight = safeDivide(radiance, lambda.pdf()).lanes() * (1.f / spectrumSamples);
    const SlotLanes slot = nanometreSlot(lambda.lambda().lanes());
    Lanes sum{};
    for (int i = 0; i < spectrumSamples; ++i)
        sum += matching.xyz[std::size_t(slot[i])] * weight[i];
    return Xyz(sum[0], sum[1], sum[2]);
}

} // namespace vitrine
