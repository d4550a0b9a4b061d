// The judge is judged: right densities pass, wrong ones do not.
#include "core/sampling.h"
#include "support/chi_squared.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

std::optional<V3f> cosineSample(RandomStream& random) {
    const float u = random.uniform();
    return sampleCosineHemisphere(V2f(u, random.uniform()));
}

double cosineDensity(const V3f& w) {
    return std::max(0.f, w.z) / piD;
}

// Percentiles of the chi-squared distribution: NIST/SEMATECH e-Handbook, table 1.3.6.7.4.
TEST(ChiSquared, TailsAgreeWithTables) {
    EXPECT_NEAR(chiSquaredPValue(3.841, 1), 0.05, 2e-5);
    EXPECT_NEAR(chiSquaredPValue(6.635, 1), 0.01, 2e-5);
    EXPECT_NEAR(chiSquaredPValue(18.307, 10), 0.05, 2e-5);
    EXPECT_NEAR(chiSquaredPValue(124.342, 100), 0.05, 2e-5);
    EXPECT_NEAR(chiSquaredPValue(77.929, 100), 0.95, 2e-5);
    EXPECT_EQ(chiSquaredPValue(0, 7), 1);
    EXPECT_NEAR(chiSquaredPValue(2, 2), std::exp(-1.), 1e-12);
}

TEST(ChiSquared, Thresholds) {
    EXPECT_NEAR(std::pow(1 - sidakThreshold(0.01, 250), 250), 0.99, 1e-12);
    EXPECT_NEAR(normalPValue(1.959964), 0.05, 1e-6);
}

TEST(ChiSquared, QuadratureIntegratesPeaksAndSteps) {
    EXPECT_NEAR(integrateSphere(cosineDensity), 1, 1e-6);
    // A von Mises-Fisher lobe of width 0.1 rad off the axis: its normalisation is known.
    const double kappa = 100;
    const V3f mean = V3f(1, 2, 0.5f).normalized();
    const auto lobe = [&](const V3f& w) {
        return kappa / (2 * piD * (1 - std::exp(-2 * kappa))) * std::exp(kappa * (double(mean.dot(w)) - 1));
    };
    EXPECT_NEAR(integrateSphere(lobe), 1, 1e-4);
    // A cap whose edge crosses cells.
    EXPECT_NEAR(integrateSphere([&](const V3f& w) { return mean.dot(w) > 0.5f ? 1. : 0.; }), piD, 1e-3);
}

TEST(ChiSquared, AcceptsTheRightDensity) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const ChiSquaredResult result = chiSquaredSphere(cosineSample, cosineDensity, {.seed = seed});
        EXPECT_GT(result.pValue, sidakThreshold(0.01, 5)) << result.report;
        EXPECT_NEAR(result.mass, 1, 1e-4);
        EXPECT_GT(result.dof, 200);
    }
}

TEST(ChiSquared, RefusesAWrongDensity) {
    // Uniform on the hemisphere instead of cosine; a cosine tilted by a tenth; one whose mass is 0.98.
    const auto uniform = [](const V3f& w) { return w.z > 0 ? 0.5 / piD : 0.; };
    const auto tilted = [](const V3f& w) { return cosineDensity(w) * (1 + 0.1 * w.x); };
    const auto light = [](const V3f& w) { return cosineDensity(w) * 0.98; };
    EXPECT_LT(chiSquaredSphere(cosineSample, uniform).pValue, 1e-6);
    EXPECT_LT(chiSquaredSphere(cosineSample, tilted).pValue, 1e-6);
    EXPECT_LT(chiSquaredSphere(cosineSample, light).pValue, 1e-6);
}

TEST(ChiSquared, RefusesMassAboveOneAndNaN) {
    EXPECT_EQ(chiSquaredSphere(cosineSample, [](const V3f& w) { return 1.01 * cosineDensity(w); }).pValue, 0);
    EXPECT_EQ(chiSquaredSphere(cosineSample, [](const V3f&) { return std::nan(""); }).pValue, 0);
    const auto broken = [](RandomStream&) { return std::optional<V3f>(V3f(NAN, 0, 0)); };
    EXPECT_EQ(chiSquaredSphere(broken, cosineDensity).pValue, 0);
}

TEST(ChiSquared, CountsMissingSamplesAsMissingMass) {
    const auto half = [](RandomStream& random) -> std::optional<V3f> {
        const auto w = cosineSample(random);
        return random.uniform() < 0.5f ? w : std::nullopt;
    };
    const auto result = chiSquaredSphere(half, [](const V3f& w) { return cosineDensity(w) / 2; });
    EXPECT_GT(result.pValue, 0.01) << result.report;
    EXPECT_LT(chiSquaredSphere(half, cosineDensity).pValue, 1e-6);
}

TEST(ChiSquared, RefusesSamplesWhereTheDensityIsZero) {
    // 20 of 100000 samples point down: too few for Pearson's statistic to mind.
    const auto leaky = [](RandomStream& random) -> std::optional<V3f> {
        auto w = cosineSample(random);
        if (random.uniform() < 2e-4f) w->z = -w->z;
        return w;
    };
    EXPECT_LT(chiSquaredSphere(leaky, cosineDensity).pValue, 1e-6);
}

TEST(ChiSquared, WorksOnTheSquare) {
    const auto ramp = [](RandomStream& random) -> std::optional<V2f> {
        const float x = std::sqrt(random.uniform());
        return V2f(x, random.uniform());
    };
    const auto result = chiSquaredSquare(ramp, [](const V2f& p) { return 2. * p.x; });
    EXPECT_GT(result.pValue, 0.01) << result.report;
    EXPECT_LT(chiSquaredSquare(ramp, [](const V2f& p) { return 2. * p.y; }).pValue, 1e-6);
}

} // namespace
} // namespace vitrine::test
