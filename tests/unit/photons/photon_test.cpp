// Photon records and the schedules of radii.
#include "core/random.h"
#include "core/sampling.h"
#include "photons/photon.h"
#include "photons/radius_schedule.h"

namespace vitrine {
namespace {

TEST(Photon, KeepsItsDirection) {
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.f, -1.f}) {
            V3f w(0);
            w[axis] = sign;
            EXPECT_EQ(Photon::unpackDirection(Photon::packDirection(w)), w);
        }
    RandomStream random(83);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const V3f w = sampleUniformSphere(V2f(random.uniform(), random.uniform()));
        const V3f back = Photon::unpackDirection(Photon::packDirection(w));
        EXPECT_NEAR(back.length(), 1, 1e-6);
        worst = std::max(worst, double((back - w).length()));
    }
    EXPECT_LT(degrees(worst), 0.12);
    EXPECT_GT(degrees(worst), 0.02) << "then the bound says nothing";
}

TEST(Photon, KeepsTheRest) {
    for (const int depth : {0, 1, 100, Photon::maxDepth})
        for (const auto history : {LightHistory::Scattered, LightHistory::Caustic, LightHistory::Hidden})
            for (const bool front : {false, true}) {
                const Photon photon(V3f(1, -2, 3.5f), V3f(0, 1, 0), front, depth, history, SampledSpectrum(1, 2, 3, 4));
                EXPECT_EQ(photon.p(), V3f(1, -2, 3.5f));
                EXPECT_EQ(photon.front(), front);
                EXPECT_EQ(photon.depth(), depth);
                EXPECT_EQ(photon.history(), history);
                EXPECT_EQ(photon.w(), V3f(0, 1, 0));
                EXPECT_EQ(photon.power()[2], 3);
            }
}

TEST(SharedRadius, IsTheProductOfKnausAndZwicker) {
    for (const double alpha : {0.1, 2. / 3, 0.9}) {
        double product = 1;
        for (std::uint64_t pass = 0; pass < 20000; ++pass) {
            if (pass < 200 || pass % 997 == 0) {
                ASSERT_NEAR(sharedRadiusFactor(pass, alpha) / std::sqrt(product), 1, 1e-6) << pass;
            }
            product *= (double(pass) + 1 + alpha) / (double(pass) + 2);
        }
    }
    EXPECT_EQ(sharedRadiusFactor(1000000, 1), 1);
    EXPECT_EQ(sharedRadiusFactor(0, 0.5), 1);
}

TEST(SharedRadius, FallsAsTheTheorySays) {
    // r^2 ~ pass^(alpha - 1).
    const double ratio = sharedRadiusFactor(4000000, 0.5) / sharedRadiusFactor(1000000, 0.5);
    EXPECT_NEAR(ratio, std::pow(4., -0.25), 1e-4);
}

TEST(PointRadius, IsTheRuleOfHachisukaEtAl) {
    PointRadius radius;
    radius.found(0, 0.7);
    EXPECT_EQ(radius.factor, 1);
    radius.found(10, 0.7);
    EXPECT_FLOAT_EQ(radius.factor, float(std::sqrt(0.7)));
    EXPECT_FLOAT_EQ(radius.photons, 7);
    radius.found(20, 0.7);
    EXPECT_FLOAT_EQ(radius.factor, float(std::sqrt(0.7 * (7 + 14) / 27.)));
    EXPECT_FLOAT_EQ(radius.photons, 21);
}

TEST(PointRadius, SumsOfDensitiesAreTheirNormalisedTau) {
    // The paper keeps tau' = (tau + phi) R'^2 / R^2 and shows tau / (pi R^2 passes): the mean of the passes' densities
    // phi / (pi R^2), which is what the film sums up.
    PointRadius radius;
    double tau = 0, densities = 0, r2 = 1;
    RandomStream random(84);
    for (int pass = 0; pass < 50; ++pass) {
        const auto m = std::uint32_t(20 * random.uniform());
        const double phi = m * random.uniformDouble();
        densities += phi / (piD * r2);
        radius.found(m, 0.6);
        const double next = double(radius.factor) * double(radius.factor);
        tau = (tau + phi) * next / r2;
        r2 = next;
        EXPECT_NEAR(tau / (piD * r2), densities, 1e-5 * densities + 1e-12);
    }
}

} // namespace
} // namespace vitrine
