// Limits of the layered model: where it must come to something simpler.
#include "bsdfs/bsdf.h"
#include "bsdfs/henyey_greenstein.h"
#include "core/random.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

constexpr TransportMode radiance = TransportMode::Radiance;
const V3f slanted = V3f(0.3f, -0.4f, 0.6f).normalized(), other = V3f(-0.5f, 0.1f, 0.7f).normalized();

CoatMedium thick(float thickness, float albedo = 0) {
    CoatMedium medium;
    medium.thickness = thickness;
    medium.albedo = SampledSpectrum(albedo);
    return medium;
}

TEST(LayeredBsdf, CoatOfIndexOneIsTheBareBase) {
    const DiffuseBsdf matt(SampledSpectrum(0.1f, 0.3f, 0.6f, 0.9f));
    const ConductorBsdf metal(TrowbridgeReitz(0.3f, 0.2f), SampledSpectrum(0.2f), SampledSpectrum(3));
    for (const DielectricBsdf& coat : {DielectricBsdf(1), DielectricBsdf(1, TrowbridgeReitz(0.4f, 0.4f))}) {
        const CoatedDiffuseBsdf overMatt(coat, matt, thick(0), 1);
        const CoatedConductorBsdf overMetal(coat, metal, thick(0), 1);
        for (int i = 0; i < 4; ++i) {
            EXPECT_NEAR(overMatt.f(slanted, other, radiance)[i] / matt.f(slanted, other, radiance)[i], 1, 1e-5);
            EXPECT_NEAR(overMetal.f(slanted, other, radiance)[i] / metal.f(slanted, other, radiance)[i], 1, 1e-4);
        }
        EXPECT_NEAR(overMatt.pdf(slanted, other, radiance), matt.pdf(slanted, other, radiance), 1e-5);
        EXPECT_NEAR(overMetal.pdf(slanted, other, radiance), metal.pdf(slanted, other, radiance), 1e-5);
    }
}

TEST(LayeredBsdf, CoatOfIndexOneAbsorbsTwice) {
    const DiffuseBsdf matt(SampledSpectrum(0.5f));
    const CoatedDiffuseBsdf coated(DielectricBsdf(1), matt, thick(0.3f), 1);
    const float both = std::exp(-0.3f / slanted.z - 0.3f / other.z);
    EXPECT_NEAR(coated.f(slanted, other, radiance)[0], 0.5f * invPi * both, 1e-6);
    // The same from below.
    EXPECT_NEAR(coated.f(-slanted, -other, radiance)[0], 0.5f * invPi * both, 1e-6);
}

TEST(LayeredBsdf, BlackBaseLeavesTheCoat) {
    const DiffuseBsdf black(SampledSpectrum(0.f));
    const DielectricBsdf rough(1.5f, TrowbridgeReitz(0.3f, 0.3f));
    const CoatedDiffuseBsdf roughCoat(rough, black, thick(0.01f), 1);
    EXPECT_EQ(roughCoat.f(slanted, other, radiance)[0], rough.f(slanted, other, radiance)[0]);
    const CoatedDiffuseBsdf polished(DielectricBsdf(1.5f), black, thick(0.01f), 1);
    EXPECT_EQ(Bsdf(polished).isNonSpecular(), false);
    const auto s = polished.sample(slanted, 0, V2f(0.5f, 0.5f), radiance);
    ASSERT_TRUE(s && s->isSpecular());
    EXPECT_FALSE(polished.sample(slanted, 0.9f, V2f(0.5f, 0.5f), radiance));
}

TEST(LayeredBsdf, PolishedCoatOnAMirrorIsAMirror) {
    const CoatedConductorBsdf mirror(DielectricBsdf(1.5f), ConductorBsdf({}, SampledSpectrum(0), SampledSpectrum(1)),
                                     thick(0), 3);
    EXPECT_EQ(mirror.lobes(), lobe::reflection | lobe::specular);
    EXPECT_EQ(mirror.roughness(), 0);
    EXPECT_TRUE(mirror.f(slanted, other, radiance).isBlack());
    EXPECT_EQ(mirror.pdf(slanted, other, radiance), 0);
    for (float uc : {0.01f, 0.5f, 0.99f}) {
        const auto s = mirror.sample(slanted, uc, V2f(0.2f, 0.7f), radiance);
        ASSERT_TRUE(s && s->isSpecular());
        EXPECT_NEAR((s->wi - V3f(-slanted.x, -slanted.y, slanted.z)).length(), 0, 1e-6);
        EXPECT_NEAR(s->f[0] * s->wi.z / s->pdf, 1, 1e-5);
    }
}

TEST(LayeredBsdf, MatteUnderPolishIsNearlyTheClosedForm) {
    // Reflections inside repeat with the part R of what the base sends up: T T' / eta^2 * rho / pi / (1 - rho R).
    const float rho = 0.6f, eta = 1.5f;
    double inside = 0; // midpoints
    for (int i = 0; i < 4000; ++i) {
        const float cosine = (float(i) + 0.5f) / 4000;
        inside += 2 * cosine * fresnelDielectric(cosine, 1 / eta).reflectance / 4000;
    }
    const double expected = (1 - fresnelDielectric(slanted.z, eta).reflectance) *
                            (1 - fresnelDielectric(other.z, eta).reflectance) / sqr(eta) * rho / piD /
                            (1 - rho * inside);
    CoatMedium medium = thick(0);
    medium.samples = 60000;
    medium.maxDepth = 200;
    const CoatedDiffuseBsdf coated(DielectricBsdf(eta), DiffuseBsdf(SampledSpectrum(rho)), medium, 5);
    EXPECT_NEAR(coated.f(slanted, other, radiance)[0] / expected, 1, 0.01);
}

TEST(LayeredBsdf, RoughnessIsThatOfTheNarrowestLobeBesidesDeltas) {
    const DiffuseBsdf matt(SampledSpectrum(0.5f));
    const auto metal = [](float alpha) {
        return ConductorBsdf(TrowbridgeReitz(alpha, alpha), SampledSpectrum(0.2f), SampledSpectrum(3));
    };
    const DielectricBsdf polished(1.5f), rough(1.5f, TrowbridgeReitz(0.2f, 0.2f));
    EXPECT_EQ(CoatedDiffuseBsdf(polished, matt, thick(0), 0).roughness(), 1);
    EXPECT_EQ(CoatedDiffuseBsdf(rough, matt, thick(0), 0).roughness(), 0.2f);
    EXPECT_EQ(CoatedConductorBsdf(polished, metal(0.3f), thick(0), 0).roughness(), 0.3f);
    EXPECT_EQ(CoatedConductorBsdf(rough, metal(0), thick(0), 0).roughness(), 0.2f);
    EXPECT_EQ(CoatedConductorBsdf(polished, metal(0), thick(1, 0.5f), 0).roughness(), 1);
}

TEST(HenyeyGreenstein, HasTheMeanCosineOfItsName) {
    RandomStream random(4, 4);
    const V3f before = V3f(1, 2, -2).normalized();
    for (float g : {-0.8f, 0.f, 0.3f, 0.9f}) {
        const HenyeyGreenstein phase(g);
        double sum = 0, mass = 0;
        constexpr int n = 20000;
        for (int i = 0; i < n; ++i) {
            const float u = random.uniform();
            sum += double(before.dot(phase.sample(before, V2f(u, random.uniform()))));
            const float cosine = -1 + 2 * (float(i) + 0.5f) / n;
            mass += double(phase(V3f(0, 0, 1), V3f(safeSqrt(1 - sqr(cosine)), 0, cosine))) * 4 * piD / n;
        }
        EXPECT_NEAR(sum / n, g, 5 / std::sqrt(3. * n));
        EXPECT_NEAR(mass, 1, 1e-3);
    }
}

// GatherPoint holds a Bsdf for each eye path of a tile, or of the picture (the tree search).
TEST(Bsdf, StaysSmall) {
    EXPECT_LE(sizeof(Bsdf), 96u);
}

} // namespace
} // namespace vitrine
