#include "core/random.h"
#include "film/compare.h"
#include "film/ssim.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace vitrine {
namespace {

Image constantImage(int width, int height, const std::vector<float>& pixel) {
    Image image{width, height, int(pixel.size()), {}};
    for (int i = 0; i < width * height; ++i)
        image.pixels.insert(image.pixels.end(), pixel.begin(), pixel.end());
    return image;
}

Image randomImage(int width, int height, int channels, std::uint64_t seed) {
    Image image{width, height, channels, {}};
    RandomStream random(seed);
    for (int i = 0; i < width * height * channels; ++i)
        image.pixels.push_back(random.uniform());
    return image;
}

TEST(Compare, EqualPicturesHaveNoError) {
    const Image image = randomImage(30, 20, 3, 1);
    const Comparison c = compareImages(image, image);
    EXPECT_EQ(c.relMse, 0);
    EXPECT_EQ(c.mse, 0);
    EXPECT_EQ(c.psnr, infinityD);
    EXPECT_NEAR(c.ssim.value(), 1, 1e-12);
    EXPECT_EQ(c.meanRatio, (std::vector<double>{1, 1, 1}));
    EXPECT_EQ(c.pixels, 600u);
}

TEST(Compare, NumbersOfConstantPictures) {
    // relMSE: (0.25 / 1.01 + 0 + 1 / 4.01) / 3; MSE: 1.25 / 3; peak 2.
    const Comparison c = compareImages(constantImage(40, 30, {1.5f, 0, 1}), constantImage(40, 30, {1, 0, 2}));
    EXPECT_NEAR(c.relMse, (0.25 / 1.01 + 1 / 4.01) / 3, 1e-12);
    EXPECT_NEAR(c.mse, 1.25 / 3, 1e-12);
    EXPECT_EQ(c.peak, 2);
    EXPECT_NEAR(c.psnr, 10 * std::log10(4 / (1.25 / 3)), 1e-9);
    EXPECT_EQ(c.meanRatio, (std::vector<double>{1.5, 1, 0.5}));
    // SSIM of constants: the luminance term alone.
    const double x = 0.2126 * 1.5 + 0.0722, y = 0.2126 + 2 * 0.0722, c1 = sqr(0.01 * 2);
    EXPECT_NEAR(c.ssim.value(), (2 * x * y + c1) / (x * x + y * y + c1), 1e-6);
}

TEST(Compare, ThousandthOfThePixelsWithTheLargestErrorIsDropped) {
    const Image reference = constantImage(100, 30, {0});
    Image image = reference;
    image.pixels[17] = 1e6f, image.pixels[1500] = 1e5f, image.pixels[2999] = 1e4f;
    EXPECT_EQ(compareImages(image, reference).relMse, 0);
    image.pixels[5] = 1; // the fourth stays
    EXPECT_NEAR(compareImages(image, reference).relMse, 100. / 2997, 1e-12);
    EXPECT_NEAR(compareImages(image, reference).mse, (1e12 + 1e10 + 1e8 + 1) / 3000, 1);
}

TEST(Compare, ReferencesVarianceIsTakenOff) {
    const Image a = constantImage(10, 10, {1.5f, 0.5f}), b = constantImage(10, 10, {1, 1});
    const Image variance = constantImage(10, 10, {0.1f, 0.04f});
    EXPECT_NEAR(compareImages(a, b, &variance).relMse, (0.25 - 0.07) / 1.01, 1e-8);
    EXPECT_LT(compareImages(b, b, &variance).relMse, 0);
}

TEST(Compare, VarianceOfDroppedPixelsIsDroppedToo) {
    const Image reference = constantImage(100, 10, {1});
    Image image = reference, variance = constantImage(100, 10, {0});
    image.pixels[3] = 50;
    variance.pixels[3] = 2500;
    EXPECT_EQ(compareImages(image, reference, &variance).relMse, 0);
}

TEST(Compare, PixelsThatAreNotFiniteAreCountedAndLeftOut) {
    const Image b = constantImage(12, 12, {1, 1, 1});
    Image a = b, c = b;
    a.pixels[3 * 5 + 1] = std::nanf("");
    a.pixels[3 * 6] = infinity;
    c.pixels[3 * 6] = -infinity;
    const Comparison result = compareImages(a, c);
    EXPECT_EQ(result.badPixelsA, 2u);
    EXPECT_EQ(result.badPixelsB, 1u);
    EXPECT_EQ(result.pixels, 142u);
    EXPECT_EQ(result.relMse, 0);
    EXPECT_EQ(result.meanRatio, (std::vector<double>{1, 1, 1}));
    // Both bad pixels lie in the first row: windows that begin in the second row do not see them.
    EXPECT_NEAR(result.ssim.value(), 1, 1e-12);
}

TEST(Compare, PicturesThatCannotBeComparedAreRefused) {
    const Image image = constantImage(4, 3, {1, 1, 1});
    EXPECT_THROW(compareImages(image, constantImage(3, 4, {1, 1, 1})), std::invalid_argument);
    EXPECT_THROW(compareImages(image, constantImage(4, 3, {1})), std::invalid_argument);
    EXPECT_THROW(compareImages(Image{}, Image{}), std::invalid_argument);
    const Image nan = constantImage(4, 3, {std::nanf(""), 0, 0});
    EXPECT_THROW(compareImages(image, nan), std::invalid_argument);
    const Image smallVariance = constantImage(4, 2, {1, 1, 1});
    EXPECT_THROW(compareImages(image, image, &smallVariance), std::invalid_argument);
    EXPECT_FALSE(compareImages(image, image).ssim.has_value());
}

/// Section III-B of the paper, word for word: two-dimensional weights, central moments.
double ssimByDefinition(const Image& a, const Image& b, double range) {
    double weights[11][11], total = 0, mean = 0;
    for (int y = 0; y < 11; ++y)
        for (int x = 0; x < 11; ++x)
            total += weights[y][x] = std::exp(-(sqr(x - 5) + sqr(y - 5)) / (2 * 1.5 * 1.5));
    int windows = 0;
    for (int top = 0; top + 11 <= a.height; ++top)
        for (int left = 0; left + 11 <= a.width; ++left, ++windows) {
            double mx = 0, my = 0, sxx = 0, syy = 0, sxy = 0;
            const auto forEach = [&](auto f) {
                for (int y = 0; y < 11; ++y)
                    for (int x = 0; x < 11; ++x) {
                        const std::size_t pixel = std::size_t((top + y) * a.width + left + x);
                        f(weights[y][x] / total, double(luminance(a, pixel)), double(luminance(b, pixel)));
                    }
            };
            forEach([&](double w, double x, double y) { mx += w * x, my += w * y; });
            forEach([&](double w, double x, double y) {
                sxx += w * sqr(x - mx), syy += w * sqr(y - my), sxy += w * (x - mx) * (y - my);
            });
            const double c1 = sqr(0.01 * range), c2 = sqr(0.03 * range);
            mean += (2 * mx * my + c1) * (2 * sxy + c2) / ((mx * mx + my * my + c1) * (sxx + syy + c2));
        }
    return mean / windows;
}

TEST(Ssim, FollowsItsDefinition) {
    const Image a = randomImage(23, 17, 3, 1), b = randomImage(23, 17, 3, 2);
    EXPECT_NEAR(meanSsim(a, b, 1).value(), ssimByDefinition(a, b, 1), 1e-10);
    Image near = a;
    for (std::size_t i = 0; i < near.pixels.size(); ++i)
        near.pixels[i] = 0.9f * a.pixels[i] + 0.05f * b.pixels[i];
    EXPECT_NEAR(meanSsim(near, a, 2).value(), ssimByDefinition(near, a, 2), 1e-10);
    EXPECT_GT(meanSsim(near, a, 1).value(), 0.9);
    EXPECT_LT(meanSsim(a, b, 1).value(), 0.3);
    EXPECT_FALSE(meanSsim(randomImage(10, 40, 1, 3), randomImage(10, 40, 1, 3), 1).has_value());
}

TEST(HeatMap, ShowsTheSignOfTheDifference) {
    const Image b = constantImage(4, 1, {0.4f, 0.4f, 0.4f});
    Image a = b;
    for (std::size_t c = 0; c < 3; ++c)
        a.pixels[c] = 0.525f, a.pixels[3 + c] = 0.1f;
    a.pixels[6] = std::nanf("");
    const Image map = heatMap(a, b, 0.5f);
    ASSERT_EQ(map.pixels.size(), 12u);
    EXPECT_NEAR(map.at(0, 0, 0), 0.5f, 1e-5f); // 0.125 / 0.5 / 0.5
    EXPECT_EQ(map.at(0, 0, 2), 0);
    EXPECT_EQ(map.at(1, 0, 2), 1); // clamped
    EXPECT_EQ(map.at(1, 0, 0), 0);
    EXPECT_EQ(V3f(map.at(2, 0, 0), map.at(2, 0, 1), map.at(2, 0, 2)), V3f(1, 1, 0));
    EXPECT_EQ(V3f(map.at(3, 0, 0), map.at(3, 0, 1), map.at(3, 0, 2)), V3f(0));
}

} // namespace
} // namespace vitrine
