// From the spectrum of a light to the numbers in a pixel: photometric() and sensorXyz() together.
#include "core/random.h"
#include "spectrum/colorspace.h"

namespace vitrine {
namespace {

/// What a camera that looks straight at a light records: the mean over all wavelength samples.
Rgb seenDirectly(const Spectrum& light, float scale, const RgbColorSpace& space, bool terminate = false) {
    constexpr int count = 1 << 15;
    const float perUnit = scale / photometric(light);
    V3d sum(0);
    for (int i = 0; i < count; ++i) {
        auto lambda = SampledWavelengths::visible((float(i) + 0.5f) / count);
        if (terminate) lambda.terminateSecondary();
        sum += toDouble(sensorXyz(light.sample(lambda) * perUnit, lambda));
    }
    return space.fromXyz(toFloat(sum / count));
}

TEST(Photometric, IsTheIntegralWithY) {
    EXPECT_FLOAT_EQ(photometric(ConstantSpectrum(1)), float(innerProduct(cieY(), ConstantSpectrum(1))));
    EXPECT_FLOAT_EQ(photometric(ConstantSpectrum(3)), 3 * photometric(ConstantSpectrum(1)));
    EXPECT_NEAR(photometric(*namedSpectrum("stdillum-A")), cieYIntegral, 1e-3);
}

TEST(Photometric, OfAnRgbLightIsThatOfItsWhite) {
    const RgbColorSpace& srgb = RgbColorSpace::srgb();
    for (const Rgb& rgb : {Rgb(1), Rgb(80), Rgb(5, 1, 0.2f)})
        EXPECT_FLOAT_EQ(photometric(RgbIlluminantSpectrum(srgb, rgb)), photometric(srgb.illuminant()));
    const auto light = std::make_shared<RgbIlluminantSpectrum>(srgb, Rgb(5, 1, 0.2f));
    EXPECT_FLOAT_EQ(photometric(ScaledSpectrum(light, 3)), 3 * photometric(srgb.illuminant()));
    // Not so for reflectances.
    EXPECT_FLOAT_EQ(photometric(RgbAlbedoSpectrum(srgb, Rgb(0.5f))), 0.5f * photometric(ConstantSpectrum(1)));
}

TEST(Sensor, AGreyLightShowsAsItsRgb) {
    for (const auto* name : {"srgb", "rec2020", "aces2065-1", "dci-p3"}) {
        const RgbColorSpace& space = *RgbColorSpace::named(name);
        const Rgb seen = seenDirectly(RgbIlluminantSpectrum(space, Rgb(80)), 1, space);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(seen[i], 80, 0.01) << name;
    }
}

TEST(Sensor, AColouredLightShowsAsItsRgb) {
    const RgbColorSpace& srgb = RgbColorSpace::srgb();
    for (const Rgb& rgb : {Rgb(10, 50, 90), Rgb(1, 0.5f, 0.1f), Rgb(0.2f, 3, 0.1f)}) {
        const Rgb seen = seenDirectly(RgbIlluminantSpectrum(srgb, rgb), 2, srgb);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(seen[i], 2 * rgb[i], 2.5e-3 * 2 * std::max({rgb.x, rgb.y, rgb.z})) << rgb;
    }
}

TEST(Sensor, AnyOtherLightShowsWithLuminanceOne) {
    const std::vector<SpectrumPtr> lights = {namedSpectrum("stdillum-A"), std::make_shared<ConstantSpectrum>(7.f),
                                             std::make_shared<BlackbodySpectrum>(3000.f),
                                             namedSpectrum("stdillum-F11")};
    for (const auto& light : lights) {
        const Xyz xyz = RgbColorSpace::srgb().toXyz(seenDirectly(*light, 1, RgbColorSpace::srgb()));
        EXPECT_NEAR(xyz.y, 1, 1e-3);
    }
}

TEST(Sensor, TheHeroAloneGivesTheSameMean) {
    const RgbColorSpace& srgb = RgbColorSpace::srgb();
    const RgbIlluminantSpectrum light(srgb, Rgb(10, 50, 90));
    const Rgb four = seenDirectly(light, 1, srgb), one = seenDirectly(light, 1, srgb, true);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(one[i], four[i], 0.01);
}

TEST(Sensor, IsTheMeanOfMatchingFunctionsOverDensity) {
    RandomStream random(1);
    for (int i = 0; i < 200; ++i) {
        auto lambda = SampledWavelengths::visible(random.uniform());
        if (i % 2) lambda.terminateSecondary();
        const SampledSpectrum L(random.uniform(), random.uniform(), random.uniform(), random.uniform());
        V3d expected(0);
        for (int k = 0; k < spectrumSamples; ++k)
            if (lambda.pdf()[k] > 0)
                expected += V3d(cieX()(lambda[k]), cieY()(lambda[k]), cieZ()(lambda[k])) *
                            double(L[k] / lambda.pdf()[k] / spectrumSamples);
        const V3d found = toDouble(sensorXyz(L, lambda));
        EXPECT_LT((found - expected).length(), 1e-5 * (1 + expected.length()));
    }
}

} // namespace
} // namespace vitrine
