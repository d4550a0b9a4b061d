// Mirrors, polished glass and panes: the exact directions, weights and flags.
#include "bsdfs/bsdf.h"
#include "core/random.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

const V3f slanted = V3f(0.6f, -0.3f, 0.5f).normalized();

TEST(Mirror, ReflectsByTheFresnelFormula) {
    const SampledSpectrum eta(0.2f), k(3.9f);
    const Bsdf bsdf = ConductorBsdf({}, eta, k);
    EXPECT_EQ(bsdf.lobes(), lobe::reflection | lobe::specular);
    EXPECT_FALSE(bsdf.isNonSpecular());
    for (const V3f& wo : {slanted, -slanted}) {
        const auto s = bsdf.sample(wo, 0.5f, V2f(0.3f, 0.4f), TransportMode::Radiance);
        ASSERT_TRUE(s);
        EXPECT_EQ(s->wi, V3f(-wo.x, -wo.y, wo.z));
        EXPECT_EQ(s->pdf, 1);
        EXPECT_EQ(s->eta, 1);
        EXPECT_FLOAT_EQ(s->f[0] * std::abs(s->wi.z), fresnelConductor(std::abs(wo.z), eta, k)[0]);
        EXPECT_EQ(bsdf.pdf(wo, s->wi, TransportMode::Radiance), 0);
        EXPECT_TRUE(bsdf.f(wo, s->wi, TransportMode::Radiance).isBlack());
    }
}

TEST(PolishedGlass, RefractsFromBothSides) {
    const float eta = 1.5f;
    const Bsdf bsdf = DielectricBsdf(eta);
    EXPECT_EQ(bsdf.lobes(), lobe::reflection | lobe::transmission | lobe::specular);
    for (const V3f& wo : {slanted, V3f(0.3f, 0.1f, -0.9f).normalized()}) {
        const float across = wo.z > 0 ? eta : 1 / eta;
        const auto radiance = bsdf.sample(wo, 0.999f, V2f(0, 0), TransportMode::Radiance);
        const auto importance = bsdf.sample(wo, 0.999f, V2f(0, 0), TransportMode::Importance);
        ASSERT_TRUE(radiance && importance);
        EXPECT_EQ(radiance->lobes, lobe::transmission | lobe::specular);
        EXPECT_FLOAT_EQ(radiance->eta, across);
        EXPECT_NEAR(radiance->wi.x, -wo.x / across, 1e-6);
        EXPECT_NEAR(radiance->wi.length(), 1, 1e-6);
        EXPECT_LT(radiance->wi.z * wo.z, 0);
        EXPECT_NEAR(importance->f[1] / radiance->f[1], sqr(across), 1e-5);
        const float reflectance = fresnelDielectric(std::abs(wo.z), across).reflectance;
        EXPECT_FLOAT_EQ(radiance->pdf, 1 - reflectance);
        const auto mirrored = bsdf.sample(wo, 0, V2f(0, 0), TransportMode::Radiance);
        ASSERT_TRUE(mirrored);
        EXPECT_EQ(mirrored->lobes, lobe::reflection | lobe::specular);
        EXPECT_EQ(mirrored->wi, V3f(-wo.x, -wo.y, wo.z));
        EXPECT_FLOAT_EQ(mirrored->pdf, reflectance);
        EXPECT_EQ(mirrored->eta, 1);
    }
}

TEST(PolishedGlass, ReflectsTotallyFromInside) {
    const V3f wo = V3f(0.8f, 0, -0.6f);
    for (float uc : {0.f, 0.5f, 0.99999994f}) {
        const auto s = DielectricBsdf(1.5f).sample(wo, uc, V2f(0, 0), TransportMode::Radiance);
        ASSERT_TRUE(s);
        EXPECT_TRUE(s->isReflection());
        EXPECT_EQ(s->pdf, 1);
    }
}

TEST(PolishedGlass, OfMatchingIndexIsNotThere) {
    for (const DielectricBsdf& bsdf : {DielectricBsdf(1), DielectricBsdf(1, TrowbridgeReitz(0.5f, 0.5f))}) {
        EXPECT_EQ(bsdf.lobes(), lobe::transmission | lobe::specular);
        for (float uc : {0.f, 0.7f}) {
            const auto s = bsdf.sample(slanted, uc, V2f(0.2f, 0.9f), TransportMode::Radiance);
            ASSERT_TRUE(s);
            EXPECT_NEAR((s->wi + slanted).length(), 0, 1e-6);
            EXPECT_EQ(s->pdf, 1);
            EXPECT_NEAR(s->f[0] * std::abs(s->wi.z), 1, 1e-6);
        }
    }
}

// The sum R + T R T + T R^3 T + ... of what leaves either face, term by term.
TEST(Pane, SumsTheReflectionsBetweenItsFaces) {
    const Bsdf bsdf = ThinDielectricBsdf(1.5f);
    for (const V3f& wo : {slanted, -slanted, V3f(0, 0, 1), V3f(0.9999f, 0, 0.01414f)}) {
        const double once = fresnelDielectric(std::abs(wo.z), 1.5f).reflectance;
        double reflected = once, passed = 0, inside = 1 - once;
        for (int bounce = 0; bounce < 10000; ++bounce) {
            (bounce % 2 ? reflected : passed) += inside * (1 - once);
            inside *= once;
        }
        const auto mirrored = bsdf.sample(wo, 0, V2f(0, 0), TransportMode::Radiance);
        const auto straight = bsdf.sample(wo, 0.9999999f, V2f(0, 0), TransportMode::Radiance);
        ASSERT_TRUE(mirrored && straight);
        EXPECT_NEAR(mirrored->pdf, reflected, 1e-6);
        EXPECT_NEAR(straight->pdf, passed, 1e-6);
        EXPECT_EQ(straight->wi, -wo);
        EXPECT_EQ(straight->eta, 1);
        EXPECT_NEAR(straight->f[3] * std::abs(wo.z), passed, 1e-6);
        EXPECT_EQ(mirrored->wi, V3f(-wo.x, -wo.y, wo.z));
    }
}

TEST(Regularize, MakesMirrorsRoughButLeavesPanes) {
    Bsdf mirror = ConductorBsdf({}, SampledSpectrum(1), SampledSpectrum(2)), glass = DielectricBsdf(1.5f),
         matched = DielectricBsdf(1), pane = ThinDielectricBsdf(1.5f), wall = DiffuseBsdf(SampledSpectrum(0.5f));
    for (Bsdf* bsdf : {&mirror, &glass, &matched, &pane, &wall})
        bsdf->regularize();
    EXPECT_EQ(mirror.lobes(), lobe::reflection | lobe::glossy);
    EXPECT_EQ(glass.lobes(), lobe::reflection | lobe::transmission | lobe::glossy);
    EXPECT_EQ(matched.lobes(), lobe::transmission | lobe::specular);
    EXPECT_FALSE(pane.isNonSpecular());
    EXPECT_TRUE(wall.isNonSpecular());
    TrowbridgeReitz facets(0.2f, 0.5f);
    facets.regularize();
    EXPECT_FLOAT_EQ(facets.alphaX(), 0.3f);
    EXPECT_FLOAT_EQ(facets.alphaY(), 0.5f);
    facets = TrowbridgeReitz(0.06f, 0.01f);
    facets.regularize();
    EXPECT_FLOAT_EQ(facets.alphaX(), 0.12f);
    EXPECT_FLOAT_EQ(facets.alphaY(), 0.1f);
}

} // namespace
} // namespace vitrine
