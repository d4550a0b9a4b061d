#include "film/srgb.h"

#include <algorithm>
#include <array>

namespace vitrine {

namespace {

/// Linear values at which the code goes from k to k + 1. A search among them rounds exactly and spares the powers.
std::array<float, 255> makeThresholds() {
    std::array<float, 255> thresholds;
    for (std::size_t k = 0; k < thresholds.size(); ++k)
        thresholds[k] = float(linearFromSrgb((double(k) + 0.5) / 255));
    return thresholds;
}

} // namespace

std::uint8_t srgbByte(float linear) {
    static const std::array<float, 255> thresholds = makeThresholds();
    if (!(linear > 0)) return 0;
    return std::uint8_t(std::upper_bound(thresholds.begin(), thresholds.end(), linear) - thresholds.begin());
}

} // namespace vitrine
