// The transfer curve of sRGB (IEC 61966-2-1).
#pragma once

#include <cmath>
#include <cstdint>

namespace vitrine {

/// \param x linear; negative values are mirrored
inline double srgbFromLinear(double x) {
    if (x < 0) return -srgbFromLinear(-x);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

inline double linearFromSrgb(double x) {
    if (x < 0) return -linearFromSrgb(-x);
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

/// The nearest of the 256 codes to a linear value, clamped to [0, 1]; NaN gives 0.
std::uint8_t srgbByte(float linear);

} // namespace vitrine
