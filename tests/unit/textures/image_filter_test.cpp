// Means over what a pixel sees of an image.
#include "made_image.h"
#include "textures/image_filter.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using test::centre;
using test::makeCache;
using test::makeImage;
using test::scattered;

constexpr ImageFilter filters[] = {ImageFilter::Point, ImageFilter::Bilinear, ImageFilter::Trilinear, ImageFilter::Ewa};

ImageSampling with(ImageFilter filter, float maxAnisotropy = 8) {
    return {filter, ImageWrap::Repeat, maxAnisotropy};
}

/// A footprint given in texels.
ImageFootprint texels(const CachedImage& image, const V2d& dx, const V2d& dy) {
    const V2d size(image.size(0));
    return {dx / size, dy / size};
}

TEST(ImageFilter, WithoutAFootprintTheFinestLevelCounts) {
    const auto cache = makeCache();
    const auto image = makeImage(*cache, V2i(33, 20), 1, scattered);
    for (int i = 0; i < 200; ++i) {
        const V2d at(double(scattered(i, 1, 0)), double(scattered(i, 2, 0)));
        for (const ImageFilter filter : filters) {
            const auto interpolation =
                filter == ImageFilter::Point ? TexelInterpolation::Nearest : TexelInterpolation::Bilinear;
            EXPECT_EQ(filtered(*image, with(filter), at, {}), image->look(0, at, ImageWrap::Repeat, interpolation));
        }
    }
}

TEST(ImageFilter, OfALargeFootprintIsTheImagesMean) {
    const auto cache = makeCache();
    for (const V2i& size : {V2i(64, 64), V2i(100, 37), V2i(300, 1), V2i(5, 200)}) {
        const auto image = makeImage(*cache, size, 1, scattered);
        double sum = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                sum += double(scattered(x, y, 0));
        const double longer = std::max(size.x, size.y);
        for (const ImageFilter filter : filters)
            for (const double side : {2 * longer, 1e3 * longer, 1e9 * longer})
                EXPECT_NEAR(
                    filtered(*image, with(filter), V2d(0.3, 0.8), texels(*image, V2d(side, 0), V2d(0, side)))[0],
                    sum / (size.x * size.y), 1e-5);
    }
}

TEST(ImageFilter, LevelsFitTheFootprintInTexelsWhateverTheImagesShape) {
    // Stripes of 4 texels along s: a footprint of one texel sees them, one of 64 does not, and t plays no part.
    const auto cache = makeCache();
    const auto stripes = [](int x, int, int) { return float(x / 4 % 2); };
    for (const V2i& size : {V2i(512, 512), V2i(512, 8), V2i(512, 1)}) {
        const auto image = makeImage(*cache, size, 1, stripes);
        for (const ImageFilter filter : filters) {
            const auto contrast = [&](double side) {
                const ImageFootprint footprint = texels(*image, V2d(side, 0), V2d(0, std::min(side, double(size.y))));
                const auto at = [&](double x) {
                    return filtered(*image, with(filter), V2d(x / size.x, 0.5), footprint)[0];
                };
                return std::abs(at(70) - at(66));
            };
            EXPECT_GT(contrast(0.5), 0.9) << int(filter) << ' ' << size.y;
            EXPECT_LT(contrast(64), 1e-3) << int(filter) << ' ' << size.y;
        }
    }
}

TEST(ImageFilter, OnlyEwaKeepsSharpAcrossALongFootprint) {
    const auto cache = makeCache();
    // Diagonal stripes, the footprint lies along them.
    const auto image = makeImage(*cache, V2i(256, 256), 1, [](int x, int y, int) { return float((x + y) / 16 % 2); });
    const ImageFootprint footprint = texels(*image, V2d(8, -8), V2d(0.7, 0.7));
    const auto contrast = [&](const ImageSampling& sampling) {
        return std::abs(filtered(*image, sampling, V2d(140, 140) / 256., footprint)[0] -
                        filtered(*image, sampling, V2d(148, 148) / 256., footprint)[0]);
    };
    EXPECT_GT(contrast(with(ImageFilter::Ewa, 16)), 0.95);
    EXPECT_LT(contrast(with(ImageFilter::Ewa, 1)), 0.6);
    EXPECT_LT(contrast(with(ImageFilter::Trilinear)), 0.6);
}

/// The mean of (x - x0)^2 under a filter is how wide it is.
TEST(ImageFilter, EwaIsAsWideAsItsGaussian) {
    const auto cache = makeCache();
    constexpr int n = 512;
    const auto squares = makeImage(*cache, V2i(n, n), 3, [](int x, int y, int c) {
        const float dx = float(x) - n / 2 + 0.5f, dy = float(y) - n / 2 + 0.5f;
        return c == 0 ? dx * dx : c == 1 ? dy * dy : dx * dy;
    });
    for (const auto& [dx, dy] : {std::pair(V2d(16, 0), V2d(0, 16)),
                                 {V2d(32, 0), V2d(0, 8)},
                                 {V2d(0, 8), V2d(40, 0)},
                                 {V2d(20, 20), V2d(-6, 6)},
                                 {V2d(20, 4), V2d(10, 12)},
                                 {V2d(3, -24), V2d(8, 2)}}) {
        const Texel width = filtered(*squares, with(ImageFilter::Ewa), V2d(0.5, 0.5), texels(*squares, dx, dy));
        const double xx = (sqr(dx.x) + sqr(dy.x)) / 4, yy = (sqr(dx.y) + sqr(dy.y)) / 4,
                     xy = (dx.x * dx.y + dy.x * dy.y) / 4;
        // A lookup's own width depends on where between texels it falls, by a third at most.
        const double minor = std::abs(dx.x * dy.y - dx.y * dy.x) / std::sqrt(4 * std::max(xx, yy));
        EXPECT_NEAR(width[0], xx, 0.1 * xx + 0.1 * sqr(minor)) << dx << dy;
        EXPECT_NEAR(width[1], yy, 0.1 * yy + 0.1 * sqr(minor)) << dx << dy;
        EXPECT_NEAR(width[2], xy, 0.1 * std::sqrt(xx * yy) + 0.1 * sqr(minor)) << dx << dy;
    }
}

} // namespace
} // namespace vitrine
