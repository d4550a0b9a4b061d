#include "core/random.h"
#include "spectrum/spectrum.h"

namespace vitrine {
namespace {

/// sample() must say what operator() says, to the bit.
void expectSamplesAgree(const Spectrum& spectrum) {
    for (int i = 0; i < 200; ++i) {
        const auto lambda = SampledWavelengths::visible(float(i) / 200);
        const SampledSpectrum s = spectrum.sample(lambda);
        for (int k = 0; k < spectrumSamples; ++k)
            ASSERT_EQ(s[k], spectrum(lambda[k])) << lambda[k] << " nm";
    }
}

std::vector<float> ramp() {
    std::vector<float> values;
    for (int i = 0; i < 471; ++i)
        values.push_back(float(i + 1));
    return values;
}

TEST(ConstantSpectrum, IsConstant) {
    const ConstantSpectrum s(1.5f);
    EXPECT_EQ(s(360), 1.5f);
    EXPECT_EQ(s(2000), 1.5f);
    EXPECT_EQ(s.maxValue(), 1.5f);
    EXPECT_TRUE(s.isConstant());
    expectSamplesAgree(s);
}

TEST(DenseSpectrum, TakesTheNearestNanometre) {
    const DenseSpectrum s(ramp());
    EXPECT_EQ(s(360), 1);
    EXPECT_EQ(s(360.49f), 1);
    EXPECT_EQ(s(360.5f), 2); // halves up, as lround
    EXPECT_EQ(s(511.49997f), 152);
    EXPECT_EQ(s(511.5f), 153);
    EXPECT_EQ(s(829.5f), 471);
    EXPECT_EQ(s(830), 471);
    EXPECT_EQ(s.maxValue(), 471);
    EXPECT_FALSE(s.isConstant());
    expectSamplesAgree(s);
    RandomStream random(1);
    for (int i = 0; i < 10000; ++i) {
        const auto lambda = float(random.uniform(360, 830));
        ASSERT_EQ(s(lambda), float(std::lround(lambda) - 359)) << lambda;
    }
}

TEST(DenseSpectrum, IsZeroOutsideTheVisibleRange) {
    const DenseSpectrum s(ramp());
    EXPECT_EQ(s(359.5f), 1);
    for (const float lambda : {359.49f, 300.f, 0.f, -5.f, -infinity, 830.5f, 1000.f, 1e30f, infinity, NAN})
        EXPECT_EQ(s(lambda), 0) << lambda;
}

TEST(DenseSpectrum, CopiesAnotherSpectrumAtWholeNanometres) {
    const PiecewiseLinearSpectrum line({300, 900}, {0, 600});
    const DenseSpectrum s(line);
    for (int lambda = 360; lambda <= 830; ++lambda)
        EXPECT_FLOAT_EQ(s(float(lambda)), float(lambda - 300));
    EXPECT_THROW(DenseSpectrum(std::vector<float>(470, 1.f)), std::invalid_argument);
}

TEST(PiecewiseLinearSpectrum, InterpolatesAndIsZeroOutside) {
    const PiecewiseLinearSpectrum s({400, 500, 510}, {1, 3, 13});
    EXPECT_EQ(s(400), 1);
    EXPECT_FLOAT_EQ(s(450), 2);
    EXPECT_EQ(s(500), 3);
    EXPECT_FLOAT_EQ(s(505), 8);
    EXPECT_EQ(s(510), 13);
    for (const float lambda : {399.99f, 0.f, 510.01f, 1e9f, infinity, -infinity, NAN})
        EXPECT_EQ(s(lambda), 0) << lambda;
    EXPECT_EQ(s.maxValue(), 13);
    expectSamplesAgree(s);
}

TEST(PiecewiseLinearSpectrum, AgreesWithADirectSearch) {
    RandomStream random(2);
    // Wide and narrow steps (many within a nanometre), inside, across and outside the visible range.
    for (const double meanStep : {100., 20., 3., 0.2, 0.01})
        for (const double start : {1., 300., 400., 700., 829., 1000.}) {
            std::vector<float> lambdas, values;
            double lambda = start;
            for (int i = 0; i < 60; ++i) {
                lambdas.push_back(float(lambda));
                values.push_back(random.uniform());
                lambda += meanStep * random.uniform(0.2, 1.8);
            }
            const PiecewiseLinearSpectrum s(lambdas, values);
            for (int i = 0; i < 1000; ++i) {
                const auto l = float(random.uniform(double(lambdas.front()), double(lambdas.back())));
                std::size_t k = 0;
                while (k + 2 < lambdas.size() && lambdas[k + 1] <= l)
                    ++k;
                const double t = double(l - lambdas[k]) / double(lambdas[k + 1] - lambdas[k]);
                ASSERT_NEAR(double(s(l)), (1 - t) * double(values[k]) + t * double(values[k + 1]), 1e-6) << l;
            }
            for (std::size_t i = 0; i < lambdas.size(); ++i)
                ASSERT_FLOAT_EQ(s(lambdas[i]), values[i]);
        }
}

TEST(PiecewiseLinearSpectrum, OfOnePairIsAPoint) {
    const PiecewiseLinearSpectrum s({500}, {7});
    EXPECT_EQ(s(500), 7);
    EXPECT_EQ(s(500.1f), 0);
    EXPECT_FALSE(s.isConstant());
}

TEST(PiecewiseLinearSpectrum, IsConstantOnlyOverTheWholeVisibleRange) {
    EXPECT_TRUE(PiecewiseLinearSpectrum({360, 500, 830}, {2, 2, 2}).isConstant());
    EXPECT_FALSE(PiecewiseLinearSpectrum({360, 500, 830}, {2, 2.01f, 2}).isConstant());
    EXPECT_FALSE(PiecewiseLinearSpectrum({400, 700}, {2, 2}).isConstant());
    // Where it does not reach it is zero, which a bound must cover.
    EXPECT_EQ(PiecewiseLinearSpectrum({400, 700}, {-2, -1}).maxValue(), 0);
    EXPECT_EQ(PiecewiseLinearSpectrum({360, 830}, {-2, -1}).maxValue(), -1);
}

TEST(PiecewiseLinearSpectrum, RefusesBadTables) {
    using S = PiecewiseLinearSpectrum;
    EXPECT_THROW(S({}, {}), std::invalid_argument);
    EXPECT_THROW(S({400, 500}, {1}), std::invalid_argument);
    EXPECT_THROW(S({500, 400}, {1, 1}), std::invalid_argument);
    EXPECT_THROW(S({400, 400}, {1, 1}), std::invalid_argument);
    EXPECT_THROW(S({400, NAN}, {1, 1}), std::invalid_argument);
    EXPECT_THROW(S({400, infinity}, {1, 1}), std::invalid_argument);
    EXPECT_THROW(S({400, 500}, {1, NAN}), std::invalid_argument);
}

TEST(BlackbodySpectrum, FollowsPlanck) {
    const auto planck = [](double lambda, double kelvin) {
        const double c = 299792458, h = 6.62606957e-34, k = 1.3806488e-23, l = lambda * 1e-9;
        return 2 * h * c * c / (std::pow(l, 5) * std::expm1(h * c / (l * k * kelvin)));
    };
    for (const double kelvin : {1000., 2856., 3500., 5778., 6500., 12000., 100000.}) {
        const BlackbodySpectrum s{float(kelvin)};
        const double peak = planck(2.8977721e6 / kelvin, kelvin);
        for (double lambda = 360; lambda <= 830; lambda += 10)
            EXPECT_NEAR(double(s(float(lambda))) / (planck(lambda, kelvin) / peak), 1, 1e-6)
                << kelvin << " K, " << lambda;
        expectSamplesAgree(s);
    }
}

TEST(BlackbodySpectrum, PeaksWhereWienSays) {
    // 5000 K: 579.55 nm.
    const BlackbodySpectrum s(5000);
    EXPECT_NEAR(s(579.55f), 1, 1e-6);
    EXPECT_LT(s(570), s(579.55f));
    EXPECT_LT(s(589), s(579.55f));
    EXPECT_EQ(s.maxValue(), 1);
    for (float lambda = 360; lambda <= 830; lambda += 1)
        EXPECT_LE(s(lambda), 1.000001f);
}

TEST(BlackbodySpectrum, OfExtremeTemperaturesIsFinite) {
    for (const float kelvin : {1e-30f, 1e-3f, 1.f, 50.f, 1e6f, 1e30f}) {
        const BlackbodySpectrum s(kelvin);
        for (const float lambda : {360.f, 550.f, 830.f}) {
            EXPECT_TRUE(std::isfinite(s(lambda))) << kelvin;
            EXPECT_GE(s(lambda), 0);
            EXPECT_LE(s(lambda), 1.000001f);
        }
    }
    for (const float kelvin : {0.f, -1.f, infinity, NAN})
        EXPECT_THROW(BlackbodySpectrum{kelvin}, std::invalid_argument);
}

TEST(ScaledSpectrum, Scales) {
    const auto line = std::make_shared<PiecewiseLinearSpectrum>(std::vector<float>{360, 830}, std::vector<float>{0, 2});
    const ScaledSpectrum s(line, 3);
    EXPECT_FLOAT_EQ(s(595), 3);
    EXPECT_FLOAT_EQ(s.maxValue(), 6);
    EXPECT_FALSE(s.isConstant());
    EXPECT_TRUE(ScaledSpectrum(std::make_shared<ConstantSpectrum>(2.f), 3).isConstant());
    expectSamplesAgree(s);
}

TEST(InnerProduct, SumsOverWholeNanometres) {
    EXPECT_DOUBLE_EQ(innerProduct(ConstantSpectrum(2), ConstantSpectrum(3)), 6 * 471);
    EXPECT_DOUBLE_EQ(innerProduct(DenseSpectrum(ramp()), ConstantSpectrum(1)), 471 * 472 / 2.);
}

TEST(Cie1931, HasTheStandardsFigures) {
    EXPECT_FLOAT_EQ(cieY()(555), 1);
    EXPECT_FLOAT_EQ(cieX()(600), 1.0622f);
    EXPECT_FLOAT_EQ(cieZ()(445), 1.7826f);
    EXPECT_FLOAT_EQ(cieX()(360), 0.0001299f);
    EXPECT_FLOAT_EQ(cieY()(450), 0.038f);
    const ConstantSpectrum one(1);
    EXPECT_NEAR(innerProduct(cieY(), one), double(cieYIntegral), 1e-4);
    // The equal-energy white is 1/3, 1/3 (to the rounding of the tables).
    EXPECT_NEAR(innerProduct(cieX(), one) / innerProduct(cieY(), one), 1, 1e-3);
    EXPECT_NEAR(innerProduct(cieZ(), one) / innerProduct(cieY(), one), 1, 1e-3);
    expectSamplesAgree(cieX());
}

} // namespace
} // namespace vitrine
