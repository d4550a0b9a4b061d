#include "bsdfs/fresnel.h"
#include "core/random.h"

#include <gtest/gtest.h>

#include <complex>

namespace vitrine {
namespace {

/// The textbook's complex formulas (Born & Wolf, sec. 1.5.2 with a complex index).
double textbook(double cosI, std::complex<double> index) {
    const std::complex<double> cosT = std::sqrt(1. - (1 - cosI * cosI) / (index * index));
    const auto parallel = (index * cosI - cosT) / (index * cosI + cosT);
    const auto perpendicular = (cosI - index * cosT) / (cosI + index * cosT);
    return (std::norm(parallel) + std::norm(perpendicular)) / 2;
}

TEST(FresnelDielectric, KnownValues) {
    EXPECT_NEAR(fresnelDielectric(1, 1.5f).reflectance, 0.04, 1e-7);
    EXPECT_NEAR(fresnelDielectric(1, 1 / 1.5f).reflectance, 0.04, 1e-7);
    EXPECT_EQ(fresnelDielectric(0, 1.5f).reflectance, 1);
    // Brewster's angle: only the perpendicular half is reflected, ((eta^2 - 1) / (eta^2 + 1))^2 / 2.
    const double eta = 1.5, brewster = std::cos(std::atan(eta));
    EXPECT_NEAR(fresnelDielectric(float(brewster), 1.5f).reflectance, sqr((eta * eta - 1) / (eta * eta + 1)) / 2, 1e-6);
    for (float c : {1.f, 0.7f, 0.3f, 0.01f, 1e-5f, 1e-18f})
        EXPECT_EQ(fresnelDielectric(c, 1).reflectance, 0) << c;
}

TEST(FresnelDielectric, TotalReflectionBeyondTheCriticalAngle) {
    const double critical = std::sqrt(1 - sqr(1 / 1.5));
    EXPECT_EQ(fresnelDielectric(float(critical) - 1e-4f, 1 / 1.5f).reflectance, 1);
    EXPECT_EQ(fresnelDielectric(float(critical) - 1e-4f, 1 / 1.5f).cosT, 0);
    EXPECT_LT(fresnelDielectric(float(critical) + 1e-4f, 1 / 1.5f).reflectance, 1);
}

TEST(FresnelDielectric, SameFromBothSides) {
    RandomStream random(1);
    for (int i = 0; i < 10000; ++i) {
        const float cosI = random.uniform(), eta = float(random.uniform(1, 3));
        const auto outside = fresnelDielectric(cosI, eta);
        EXPECT_NEAR(outside.cosT, std::sqrt(1 - (1 - sqr(double(cosI))) / sqr(double(eta))), 1e-6);
        EXPECT_NEAR(outside.reflectance, textbook(cosI, eta), 2e-6);
        // From inside, near the critical angle, cosT as a float fixes cosI only to within its rounding over cosI; and
        // dR/dcosI is at most 4 max(eta, 1/eta), at grazing.
        const double doubt = std::min(1e-3, 5e-7 / cosI);
        EXPECT_NEAR(fresnelDielectric(outside.cosT, 1 / eta).reflectance, outside.reflectance, 2e-6 + 4 * eta * doubt);
    }
}

TEST(Refract, ObeysSnellsLawInThePlaneOfIncidence) {
    RandomStream random(2);
    for (int i = 0; i < 10000; ++i) {
        const V3f n = V3f(random.uniform() - 0.5f, random.uniform() - 0.5f, random.uniform() + 0.1f).normalized();
        V3f w = V3f(random.uniform() - 0.5f, random.uniform() - 0.5f, random.uniform() - 0.5f).normalized();
        if (w.dot(n) < 0) w = -w;
        const float eta = float(random.uniform(0.4, 2.5));
        const auto [reflectance, cosT] = fresnelDielectric(std::min(1.f, w.dot(n)), eta);
        if (reflectance == 1) continue;
        const V3f t = refract(w, n, eta, w.dot(n), cosT);
        EXPECT_NEAR(t.length(), 1, 2e-6);
        EXPECT_NEAR((t.cross(n) * eta + w.cross(n)).length(), 0, 2e-6);
        EXPECT_LE(t.dot(n), 1e-6f);
    }
}

TEST(FresnelConductor, AgreesWithComplexArithmetic) {
    RandomStream random(3);
    for (int i = 0; i < 20000; ++i) {
        const float cosI = i % 10 == 0 ? 1.f : random.uniform();
        SampledSpectrum eta, k;
        for (int lane = 0; lane < spectrumSamples; ++lane) {
            eta.set(lane, float(std::exp(random.uniform(std::log(0.03), std::log(6.)))));
            k.set(lane, float(std::exp(random.uniform(std::log(0.001), std::log(200.)))));
        }
        const SampledSpectrum r = fresnelConductor(cosI, eta, k);
        for (int lane = 0; lane < spectrumSamples; ++lane)
            EXPECT_NEAR(r[lane], textbook(cosI, {eta[lane], k[lane]}), 5e-6)
                << "cos " << cosI << ", index " << eta[lane] << " + " << k[lane] << " i";
    }
}

TEST(FresnelConductor, WithoutAbsorptionIsADielectric) {
    for (float eta : {0.6f, 1 / 1.5f, 1.33f, 1.5f, 2.4f})
        for (int i = 0; i <= 100; ++i) {
            const float cosI = float(i) / 100;
            const float r = fresnelConductor(cosI, SampledSpectrum(eta), SampledSpectrum(0))[2];
            EXPECT_NEAR(r, fresnelDielectric(cosI, eta).reflectance, 2e-4) << "eta " << eta << ", cos " << cosI;
        }
}

TEST(FresnelConductor, IsFiniteAndAShareWhateverTheIndex) {
    for (float eta : {0.f, 1e-6f, 0.05f, 1.f, 50.f})
        for (float k : {0.f, 1e-6f, 1.f, 200.f, 1e4f})
            for (float cosI : {0.f, 1e-18f, 1e-4f, 0.5f, 1.f}) {
                const SampledSpectrum r = fresnelConductor(cosI, SampledSpectrum(eta), SampledSpectrum(k));
                EXPECT_TRUE(r[0] >= 0 && r[0] <= 1.000001f) << eta << " " << k << " " << cosI << ": " << r[0];
            }
}

} // namespace
} // namespace vitrine
