#include "lights/emission.h"
#include "spectrum/colorspace.h"

#include <stdexcept>

namespace vitrine {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Emission, AnySpectrumBecomesOneNitTimesScale) {
    for (const SpectrumPtr& spectrum :
         {SpectrumPtr(std::make_shared<ConstantSpectrum>(7.f)),
          SpectrumPtr(std::make_shared<BlackbodySpectrum>(3000.f)),
          SpectrumPtr(std::make_shared<DenseSpectrum>(RgbColorSpace::srgb().illuminant()))}) {
        EXPECT_NEAR(innerProduct(*scaledEmission(spectrum, 1, -1, 0), cieY()), 1, 1e-5);
        EXPECT_NEAR(innerProduct(*scaledEmission(spectrum, 2.5, -1, 0), cieY()), 2.5, 1e-5);
        // A target divided by what one nit would reach.
        EXPECT_NEAR(innerProduct(*scaledEmission(spectrum, 2.5, 60, 12), cieY()), 12.5, 1e-4);
    }
}

TEST(Emission, RgbKeepsItsLuminance) {
    const auto& srgb = RgbColorSpace::srgb();
    for (const Rgb& rgb : {Rgb(1, 1, 1), Rgb(4, 4, 4), Rgb(0.5f, 2, 0.1f)}) {
        const auto l = scaledEmission(std::make_shared<RgbIlluminantSpectrum>(srgb, rgb), 1, -1, 0);
        const float expected = srgb.toXyz(rgb).y;
        EXPECT_NEAR(innerProduct(*l, cieY()), expected, 0.01 * expected) << rgb;
    }
}

TEST(Emission, HoldsTheSpectrumsShape) {
    const auto spectrum = std::make_shared<BlackbodySpectrum>(4000.f);
    const auto l = scaledEmission(spectrum, 3, -1, 0);
    const double factor = 3 / photometric(*spectrum);
    for (float lambda : {360.f, 450.f, 555.f, 700.f, 830.f})
        EXPECT_NEAR((*l)(lambda), factor * (*spectrum)(lambda), 1e-5 * factor) << lambda;
}

TEST(Emission, BlackStaysBlack) {
    const auto black = scaledEmission(std::make_shared<ConstantSpectrum>(0.f), 2, 100, 3);
    EXPECT_EQ(black->maxValue(), 0);
}

TEST(Emission, TargetsNotAboveZeroAreNone) {
    EXPECT_EQ(emissionScale(3, -1, 0), 3);
    EXPECT_EQ(emissionScale(3, 0, 0), 3);
    EXPECT_EQ(emissionScale(3, 8, 4), 6);
}

TEST(Emission, RefusesNonsense) {
    const auto one = std::make_shared<ConstantSpectrum>(1.f);
    EXPECT_THROW(scaledEmission(nullptr, 1, -1, 1), std::invalid_argument);
    EXPECT_THROW(scaledEmission(std::make_shared<ConstantSpectrum>(-1.f), 1, -1, 1), std::invalid_argument);
    EXPECT_THROW(scaledEmission(std::make_shared<ConstantSpectrum>(infinity), 1, -1, 1), std::invalid_argument);
    for (double scale : {-1., nan, infinityD})
        EXPECT_THROW(scaledEmission(one, scale, -1, 1), std::invalid_argument);
    for (double target : {nan, infinityD})
        EXPECT_THROW(scaledEmission(one, 1, target, 1), std::invalid_argument);
    for (double unit : {0., -1., nan, infinityD})
        EXPECT_THROW(scaledEmission(one, 1, 5, unit), std::invalid_argument);
}

} // namespace
} // namespace vitrine
