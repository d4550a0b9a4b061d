#include "lights/environment_image.h"

#include <stdexcept>

namespace vitrine {

namespace {

Rgb pixel(const Image& image, std::size_t index) {
    const float* p = image.pixels.data() + index * std::size_t(image.channels);
    return Rgb(std::max(p[0], 0.f), std::max(p[1], 0.f), std::max(p[2], 0.f));
}

const Image& checked(const Image& image) {
    if (image.channels < 3) throw std::invalid_argument("the image of an infinite light must have R, G and B");
    for (float value : image.pixels)
        if (!std::isfinite(value))
            throw std::invalid_argument("the image of an infinite light has values that are infinite or not a number");
    return image;
}

Rgb meanColour(const Image& image, const EnvironmentGrid& grid) {
    V3d sum(0, 0, 0);
    for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x)
            sum += toDouble(pixel(image, grid.texel(x, y))) * (grid.solidAngle(y) / (4 * piD));
    return toFloat(sum);
}

std::vector<float> means(const Image& image, const EnvironmentGrid& grid, EnvironmentLookup lookup) {
    const auto value = [&](int x, int y) {
        const Rgb rgb = pixel(image, grid.texel(x, y));
        return (rgb.x + rgb.y + rgb.z) / 3;
    };
    // Integrals of the tent over [-1.5, -0.5], [-0.5, 0.5] and [0.5, 1.5].
    constexpr float tent[3] = {1 / 8.f, 6 / 8.f, 1 / 8.f};
    std::vector<float> result;
    result.reserve(std::size_t(grid.width()) * std::size_t(grid.height()));
    for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x) {
            float mean = 0;
            for (int j = -1; j <= 1 && lookup == EnvironmentLookup::Bilinear; ++j)
                for (int i = -1; i <= 1; ++i)
                    mean += tent[i + 1] * tent[j + 1] * value(x + i, y + j);
            result.push_back(lookup == EnvironmentLookup::Nearest ? value(x, y) : mean);
        }
    return result;
}

double upperIlluminance(const Image& image, const EnvironmentGrid& grid, const RgbColorSpace& colorSpace) {
    const V3f luminance(colorSpace.toXyz(Rgb(1, 0, 0)).y, colorSpace.toXyz(Rgb(0, 1, 0)).y,
                        colorSpace.toXyz(Rgb(0, 0, 1)).y);
    double sum = 0;
    for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x) {
            const V2f centre((float(x) + 0.5f) / float(grid.width()), (float(y) + 0.5f) / float(grid.height()));
            const float cosine = std::max(0.f, grid.uniformDirection(centre).z);
            sum += double(pixel(image, grid.texel(x, y)).dot(luminance) * cosine) * grid.solidAngle(y) / 2;
        }
    return sum;
}

} // namespace

EnvironmentImage::EnvironmentImage(const Image& image, const RgbColorSpace& colorSpace, EnvironmentMapping mapping,
                                   EnvironmentLookup lookup)
    : grid_(mapping, checked(image).width, image.height), lookup_(lookup), white_(&colorSpace.illuminant()),
      mean_(colorSpace, meanColour(image, grid_)), texelMeans_(means(image, grid_, lookup)),
      pbrtIlluminance_(upperIlluminance(image, grid_, colorSpace)) {
    texels_.reserve(texelMeans_.size());
    for (std::size_t i = 0; i < texelMeans_.size(); ++i) {
        const Rgb rgb = pixel(image, i);
        // As RgbIlluminantSpectrum: a reflectance of largest component 1/2 keeps the sigmoid smooth.
        const float twice = 2 * std::max({rgb.x, rgb.y, rgb.z});
        texels_.push_back({twice > 0 ? colorSpace.sigmoid(rgb / twice) : SigmoidPolynomial(), twice});
    }
}

SampledSpectrum EnvironmentImage::radiance(const V2f& square, const SampledWavelengths& lambda) const {
    SampledSpectrum sum(0.f);
    if (lookup_ == EnvironmentLookup::Nearest) {
        const Texel& texel = texels_[grid_.texel(grid_.column(square.x), grid_.row(square.y))];
        if (texel.scale > 0) sum = texel.polynomial.sample(lambda) * texel.scale;
    } else {
        const float x = square.x * float(grid_.width()) - 0.5f, y = square.y * float(grid_.height()) - 0.5f;
        const float left = std::floor(x), top = std::floor(y);
        const float dx = x - left, dy = y - top;
        for (int j = 0; j <= 1; ++j)
            for (int i = 0; i <= 1; ++i) {
                const Texel& texel = texels_[grid_.texel(int(left) + i, int(top) + j)];
                const float weight = (i ? dx : 1 - dx) * (j ? dy : 1 - dy) * texel.scale;
                if (weight > 0) sum += texel.polynomial.sample(lambda) * weight;
            }
    }
    return sum.isBlack() ? sum : sum * white_->sample(lambda);
}

} // namespace vitrine
