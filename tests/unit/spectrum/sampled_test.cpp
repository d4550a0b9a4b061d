#include "core/random.h"
#include "spectrum/sampled.h"
#include "spectrum/spectrum.h"

namespace vitrine {
namespace {

constexpr float justBelowOne = 0x1.fffffep-1f;

double visibleDensity(double lambda) {
    const double c = std::cosh(0.0072 * (lambda - 538));
    return 1 / (c * c) * 0.0072 / (std::tanh(0.0072 * (830 - 538)) - std::tanh(0.0072 * (360 - 538)));
}

TEST(SampledWavelengths, VisibleCarryTheirDensity) {
    for (int i = 0; i < 1000; ++i) {
        const auto w = SampledWavelengths::visible(float(i) / 1000);
        for (int k = 0; k < spectrumSamples; ++k) {
            ASSERT_GE(w[k], lambdaMin);
            ASSERT_LE(w[k], lambdaMax);
            ASSERT_NEAR(w.pdf()[k] / visibleDensity(double(w[k])), 1, 1e-5) << w[k] << " nm";
        }
    }
}

TEST(SampledWavelengths, VisibleInvertTheDistribution) {
    // The probability of wavelengths up to lambda is u.
    const double first = std::tanh(0.0072 * (360 - 538)), last = std::tanh(0.0072 * (830 - 538));
    for (int i = 0; i <= 1000; ++i) {
        const float u = std::min(float(i) / 1000, justBelowOne);
        const double lambda = double(SampledWavelengths::visible(u)[0]);
        ASSERT_NEAR((std::tanh(0.0072 * (lambda - 538)) - first) / (last - first), double(u), 2e-6);
    }
}

TEST(SampledWavelengths, PictureAscendWithU) {
    constexpr int steps = 1 << 14;
    double last = double(lambdaMin);
    for (int i = 0; i < steps; ++i) {
        const auto w = SampledWavelengths::picture(float(i) / steps);
        ASSERT_GE(double(w[0]), last);
        ASSERT_LE(w[0], lambdaMax);
        // Within a nanometre d lambda / d u is 1 / pdf, as far as single precision tells wavelengths apart (3e-5 nm).
        if (i > 0 && std::floor(double(w[0])) == std::floor(last)) {
            const double step = 1 / (double(steps) * double(w.pdf()[0]));
            ASSERT_NEAR(double(w[0]) - last, step, 2e-4) << w[0] << " nm";
        }
        last = double(w[0]);
    }
    EXPECT_NEAR(SampledWavelengths::picture(justBelowOne)[0], lambdaMax, 1e-2);
    EXPECT_EQ(SampledWavelengths::picture(0)[0], lambdaMin);
}

TEST(SampledWavelengths, PictureEstimateIntegralsWithoutBias) {
    for (const DenseSpectrum* f : {&cieX(), &cieY(), &cieZ()}) {
        double estimate = 0, squares = 0, visibleSquares = 0;
        constexpr int n = 1 << 14;
        const auto once = [&](const SampledWavelengths& w) {
            return double((f->sample(w) / w.pdf()).average()) / innerProduct(*f, ConstantSpectrum(1));
        };
        for (int i = 0; i < n; ++i) {
            const float u = (float(i) + 0.5f) / n;
            const double value = once(SampledWavelengths::picture(u)), visible = once(SampledWavelengths::visible(u));
            estimate += value / n;
            squares += value * value / n;
            visibleSquares += visible * visible / n;
        }
        EXPECT_NEAR(estimate, 1, 1e-3);
        // The noise of the most noisy of the three, Z, is what it was made for.
        if (f == &cieZ()) {
            EXPECT_LT(squares - 1, 0.35 * (visibleSquares - 1));
        }
    }
}

TEST(SampledWavelengths, AreStratified) {
    for (const bool uniform : {false, true}) {
        const auto draw = [uniform](float u) {
            return uniform ? SampledWavelengths::uniform(u) : SampledWavelengths::visible(u);
        };
        for (int i = 0; i < 256; ++i) {
            const auto w = draw(float(i) / 256);
            for (int k = 1; k < spectrumSamples; ++k) {
                const float u = float((i + 64 * k) % 256) / 256;
                ASSERT_FLOAT_EQ(w[k], draw(u)[0]) << i << ", " << k;
            }
            EXPECT_EQ(w.hero(), w[0]);
        }
    }
}

TEST(SampledWavelengths, UniformCoverTheRange) {
    const auto w = SampledWavelengths::uniform(0.1f);
    EXPECT_FLOAT_EQ(w[0], 407);
    EXPECT_FLOAT_EQ(w[3], 407 + 470 * 0.75f);
    EXPECT_FLOAT_EQ(SampledWavelengths::uniform(0.8f)[1], 360 + 470 * 0.05f);
    for (int k = 0; k < spectrumSamples; ++k)
        EXPECT_FLOAT_EQ(w.pdf()[k], 1 / 470.f);
}

TEST(SampledWavelengths, AtTheEndsOfTheUnitInterval) {
    for (const float u : {0.f, 1e-40f, 0x1p-24f, 0.25f, 0.5f, 0.75f, std::nextafter(0.75f, 0.f), justBelowOne})
        for (const auto& w : {SampledWavelengths::visible(u), SampledWavelengths::uniform(u)}) {
            EXPECT_TRUE(w.lambda().isFinite());
            EXPECT_GE(w.lambda().min(), lambdaMin);
            EXPECT_LE(w.lambda().max(), lambdaMax);
            EXPECT_GT(w.pdf().min(), 0);
        }
}

TEST(SampledWavelengths, TerminatedTheyKeepTheHeroWithItsWeight) {
    auto w = SampledWavelengths::visible(0.3f);
    const auto before = w;
    EXPECT_FALSE(w.secondaryTerminated());
    for (int times = 0; times < 2; ++times) { // the second time changes nothing
        w.terminateSecondary();
        EXPECT_TRUE(w.secondaryTerminated());
        EXPECT_EQ(w.hero(), before.hero());
        EXPECT_EQ(w.pdf()[0], before.pdf()[0] / 4);
        for (int k = 1; k < spectrumSamples; ++k)
            EXPECT_EQ(w.pdf()[k], 0);
    }
}

TEST(SampledSpectrum, Arithmetic) {
    const SampledSpectrum a(1, 2, 3, 4), b(2, 4, 8, 16);
    const auto expectEqual = [](const SampledSpectrum& s, float x, float y, float z, float w) {
        EXPECT_EQ(s[0], x);
        EXPECT_EQ(s[1], y);
        EXPECT_EQ(s[2], z);
        EXPECT_EQ(s[3], w);
    };
    expectEqual(a + b, 3, 6, 11, 20);
    expectEqual(b - a, 1, 2, 5, 12);
    expectEqual(a * b, 2, 8, 24, 64);
    expectEqual(b / a, 2, 2, 8.f / 3, 4);
    expectEqual(2 * a, 2, 4, 6, 8);
    expectEqual(b / 2, 1, 2, 4, 8);
    EXPECT_EQ(b.max(), 16);
    EXPECT_EQ(b.min(), 2);
    EXPECT_EQ(b.average(), 7.5f);
    EXPECT_TRUE(SampledSpectrum().isBlack());
    EXPECT_FALSE(SampledSpectrum(0, 0, 0, 1e-30f).isBlack());
    EXPECT_FALSE(SampledSpectrum(0, NAN, 0, 0).isFinite());
    EXPECT_FALSE(SampledSpectrum(0, 0, infinity, 0).isFinite());
    expectEqual(mapSpectrum(a, [](float x) { return x * x; }), 1, 4, 9, 16);
}

TEST(SampledSpectrum, DivisionByZeroCanBeTakenForZero) {
    const auto q = safeDivide(SampledSpectrum(1, 0, infinity, 6), SampledSpectrum(0, 0, -0.f, 3));
    EXPECT_EQ(q[0], 0);
    EXPECT_EQ(q[1], 0);
    EXPECT_EQ(q[2], 0);
    EXPECT_EQ(q[3], 2);
}

} // namespace
} // namespace vitrine
