#include "film/primaries.h"

#include <ImathMatrix.h>

#include <stdexcept>

namespace vitrine {

namespace {

using Imath::M33d;

constexpr float rec709[8] = {0.64f, 0.33f, 0.3f, 0.6f, 0.15f, 0.06f, 0.3127f, 0.329f};

/// Row-vector matrix from RGB to XYZ in which white has Y = 1 (SMPTE RP 177-1993).
M33d xyzFromRgb(std::span<const float, 8> c) {
    const auto xyz = [&](std::size_t i) {
        const double x = double(c[2 * i]), y = double(c[2 * i + 1]);
        return V3d(x / y, 1, (1 - x - y) / y);
    };
    M33d primaries;
    for (int i = 0; i < 3; ++i) {
        const V3d p = xyz(std::size_t(i));
        for (int j = 0; j < 3; ++j)
            primaries[i][j] = p[j];
    }
    const double determinant = primaries.determinant();
    if (!std::isfinite(determinant) || std::abs(determinant) < 1e-9)
        throw std::invalid_argument("the picture's chromaticities span no colour space");
    // How much of each primary makes up white.
    const V3d amounts = xyz(3) * primaries.inverse();
    M33d matrix;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            matrix[i][j] = amounts[i] * primaries[i][j];
    return matrix;
}

} // namespace

Image inRec709(const Image& image, std::span<const float, 8> chromaticities) {
    const auto isZero = [](float v) { return v == 0; };
    if (image.channels != 3 || std::all_of(chromaticities.begin(), chromaticities.end(), isZero) ||
        std::equal(chromaticities.begin(), chromaticities.end(), rec709))
        return image;
    const M33d matrix = xyzFromRgb(chromaticities) * xyzFromRgb(rec709).inverse();
    Image result = image;
    for (std::size_t i = 0; i + 3 <= result.pixels.size(); i += 3) {
        float* p = &result.pixels[i];
        const V3d rgb = V3d(double(p[0]), double(p[1]), double(p[2])) * matrix;
        for (int c = 0; c < 3; ++c)
            p[c] = float(rgb[c]);
    }
    return result;
}

} // namespace vitrine
