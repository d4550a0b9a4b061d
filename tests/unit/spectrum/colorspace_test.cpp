#include "core/random.h"
#include "spectrum/colorspace.h"

namespace vitrine {
namespace {

const std::vector<std::string> spaceNames = {"srgb", "dci-p3", "rec2020", "aces2065-1"};

TEST(RgbColorSpace, IsKnownByPbrtsNames) {
    for (const auto& name : spaceNames) {
        const RgbColorSpace* space = RgbColorSpace::named(name);
        ASSERT_NE(space, nullptr) << name;
        EXPECT_EQ(space->name(), name);
        EXPECT_EQ(space, RgbColorSpace::named(name));
    }
    EXPECT_EQ(RgbColorSpace::named("sRGB"), &RgbColorSpace::srgb());
    EXPECT_EQ(RgbColorSpace::named("ACES2065-1"), RgbColorSpace::named("aces2065-1"));
    EXPECT_EQ(RgbColorSpace::named("adobe"), nullptr);
    EXPECT_EQ(RgbColorSpace::named(""), nullptr);
}

TEST(RgbColorSpace, SrgbHasTheStandardsMatrix) {
    // IEC 61966-2-1, for a D65 of rounded chromaticity; ours is the sum over the tables.
    const float expected[3][3] = {
        {0.4124f, 0.2126f, 0.0193f}, {0.3576f, 0.7152f, 0.1192f}, {0.1805f, 0.0722f, 0.9505f}};
    for (int i = 0; i < 3; ++i) {
        Rgb primary(0);
        primary[i] = 1;
        const Xyz xyz = RgbColorSpace::srgb().toXyz(primary);
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(xyz[j], expected[i][j], 2.5e-4) << i << j;
    }
}

TEST(RgbColorSpace, WhiteIsItsIlluminantAndPrimariesHaveTheirChromaticity) {
    for (const auto& name : spaceNames) {
        SCOPED_TRACE(name);
        const RgbColorSpace& space = *RgbColorSpace::named(name);
        const auto& xy = space.chromaticities();
        const auto expectChromaticity = [](const Xyz& xyz, const V2f& expected) {
            const float sum = xyz.x + xyz.y + xyz.z;
            EXPECT_NEAR(xyz.x / sum, expected.x, 1e-5);
            EXPECT_NEAR(xyz.y / sum, expected.y, 1e-5);
        };
        for (int i = 0; i < 3; ++i) {
            Rgb primary(0);
            primary[i] = 1;
            expectChromaticity(space.toXyz(primary), xy[std::size_t(i)]);
        }
        const Xyz white = space.toXyz(Rgb(1));
        expectChromaticity(white, xy[3]);
        EXPECT_NEAR(white.y, 1, 1e-5);
        EXPECT_NEAR(white.x, innerProduct(space.illuminant(), cieX()) / double(cieYIntegral), 1e-5);
        EXPECT_NEAR(white.z, innerProduct(space.illuminant(), cieZ()) / double(cieYIntegral), 1e-5);
    }
    const auto& d65 = RgbColorSpace::srgb().chromaticities()[3];
    EXPECT_NEAR(d65.x, 0.3127f, 1e-4);
    EXPECT_NEAR(d65.y, 0.3290f, 1e-4);
}

TEST(RgbColorSpace, GoesToXyzAndBack) {
    RandomStream random(1);
    for (const auto& name : spaceNames)
        for (int i = 0; i < 100; ++i) {
            const RgbColorSpace& space = *RgbColorSpace::named(name);
            const Rgb rgb(random.uniform(), random.uniform(), random.uniform());
            EXPECT_LT((space.fromXyz(space.toXyz(rgb)) - rgb).length(), 1e-6f);
        }
}

TEST(SigmoidPolynomial, MaximumIsTheLargestValue) {
    RandomStream random(2);
    for (int i = 0; i < 300; ++i) {
        // A parabola through random values at three wavelengths, some with the extremum inside, some outside.
        const double y0 = random.uniform(-3, 3), y1 = random.uniform(-3, 3), y2 = random.uniform(-3, 3);
        const double a = (y0 - 2 * y1 + y2) / (2 * 235. * 235), b = (y2 - y0) / 470;
        const SigmoidPolynomial p{float(a), float(b - 2 * a * 595), float(y1 - b * 595 + a * 595 * 595)};
        float largest = 0;
        for (float lambda = 360; lambda <= 830; lambda += 0.25f)
            largest = std::max(largest, p(lambda));
        EXPECT_NEAR(p.maxValue(), largest, 1e-5f);
    }
    EXPECT_EQ((SigmoidPolynomial{0, 0, infinity}).maxValue(), 1);
    EXPECT_EQ((SigmoidPolynomial{0, 0, -infinity}).maxValue(), 0);
    EXPECT_EQ((SigmoidPolynomial{0, 0, 0}).maxValue(), 0.5f);
    EXPECT_FLOAT_EQ((SigmoidPolynomial{0, 0.01f, 0}).maxValue(), SigmoidPolynomial::sigmoid(8.3f));
}

TEST(SigmoidPolynomial, SigmoidIsAccurateEverywhere) {
    EXPECT_EQ(SigmoidPolynomial::sigmoid(0), 0.5f);
    EXPECT_EQ(SigmoidPolynomial::sigmoid(infinity), 1);
    EXPECT_EQ(SigmoidPolynomial::sigmoid(-infinity), 0);
    EXPECT_EQ(SigmoidPolynomial::sigmoid(3e38f), 1);
    EXPECT_EQ(SigmoidPolynomial::sigmoid(-3e38f), 0);
    for (double x = -1e6; x < 1e6; x = x < -1e-6 ? x / 1.1 : x < 1e-6 ? x + 1e-6 : x * 1.1) {
        const long double exact = 0.5L + (long double)x / (2 * sqrtl(1 + (long double)x * x));
        // Relative, also where the value is tiny.
        EXPECT_NEAR(double(SigmoidPolynomial::sigmoid(float(x))) / double(exact), 1, 2e-6) << x;
    }
}

TEST(SigmoidPolynomial, SamplesLikeItEvaluates) {
    for (const SigmoidPolynomial& p :
         {SigmoidPolynomial{1e-4f, -0.1f, 25}, SigmoidPolynomial{0, 0, infinity}, SigmoidPolynomial{0, 0, -infinity},
          SigmoidPolynomial{-3e-4f, 0.3f, -70}, SigmoidPolynomial{0, 0, 1e25f}})
        for (int i = 0; i < 100; ++i) {
            const auto lambda = SampledWavelengths::visible(float(i) / 100);
            const SampledSpectrum s = p.sample(lambda);
            for (int k = 0; k < spectrumSamples; ++k)
                ASSERT_EQ(s[k], p(lambda[k]));
        }
}

TEST(RgbSpectra, AlbedoUnboundedAndIlluminantShareTheUplift) {
    const RgbColorSpace& srgb = RgbColorSpace::srgb();
    const Rgb rgb(0.1f, 0.2f, 0.4f);
    const RgbAlbedoSpectrum half(srgb, rgb / 0.8f), albedo(srgb, rgb);
    const RgbUnboundedSpectrum unbounded(srgb, rgb);
    const RgbIlluminantSpectrum light(srgb, rgb);
    const SigmoidPolynomial expected = srgb.sigmoid(rgb / 0.8f); // 2 max = 0.8
    for (float lambda = 360; lambda <= 830; lambda += 7) {
        EXPECT_EQ(albedo(lambda), srgb.sigmoid(rgb)(lambda));
        EXPECT_FLOAT_EQ(unbounded(lambda), 0.8f * expected(lambda));
        EXPECT_FLOAT_EQ(light(lambda), 0.8f * expected(lambda) * srgb.illuminant()(lambda));
        EXPECT_LE(albedo(lambda), albedo.maxValue());
        EXPECT_LE(unbounded(lambda), unbounded.maxValue() * 1.000001f);
        EXPECT_LE(light(lambda), light.maxValue() * 1.000001f);
    }
    EXPECT_FALSE(albedo.isConstant());
}

TEST(RgbSpectra, OfBlackAreExactlyBlack) {
    const RgbColorSpace& srgb = RgbColorSpace::srgb();
    const auto lambda = SampledWavelengths::visible(0.4f);
    EXPECT_TRUE(RgbAlbedoSpectrum(srgb, Rgb(0)).sample(lambda).isBlack());
    EXPECT_TRUE(RgbUnboundedSpectrum(srgb, Rgb(0)).sample(lambda).isBlack());
    EXPECT_TRUE(RgbIlluminantSpectrum(srgb, Rgb(0)).sample(lambda).isBlack());
    EXPECT_EQ(RgbIlluminantSpectrum(srgb, Rgb(0)).maxValue(), 0);
}

TEST(RgbSpectra, GreyLightIsItsWhiteScaled) {
    const RgbColorSpace& srgb = RgbColorSpace::srgb();
    const RgbIlluminantSpectrum light(srgb, Rgb(80));
    for (float lambda = 360; lambda <= 830; lambda += 1)
        EXPECT_EQ(light(lambda), 160 * 0.5f * srgb.illuminant()(lambda));
    EXPECT_EQ(&light.illuminant(), &srgb.illuminant());
}

} // namespace
} // namespace vitrine
