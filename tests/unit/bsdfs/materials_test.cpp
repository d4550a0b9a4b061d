// Materials: parameters to BSDFs, in air and in other media, and refusals.
#include "bsdfs/conductor_material.h"
#include "bsdfs/dielectric_material.h"
#include "bsdfs/diffuse_material.h"
#include "bsdfs/interface_material.h"
#include "bsdfs/thindielectric_material.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace vitrine {
namespace {

const V3f straight(0, 0, 1);
const V3f slanted = V3f(0.6f, -0.3f, 0.5f).normalized();

SpectrumPtr constant(float value) {
    return std::make_shared<ConstantSpectrum>(value);
}

/// Falls from 1.6 at 360 nm to 1.5 at 830 nm.
SpectrumPtr dispersive() {
    return std::make_shared<PiecewiseLinearSpectrum>(std::vector<float>{360, 830}, std::vector<float>{1.6f, 1.5f});
}

/// The value, times the cosine, of the reflection at direction wo.
SampledSpectrum reflected(const Material& material, const V3f& wo, float etaOutside = 1) {
    auto lambda = SampledWavelengths::visible(0.4f);
    const auto s = material.bsdf({{}, etaOutside}, lambda).sample(wo, 0, V2f(0.5f, 0.5f), TransportMode::Radiance);
    return s && s->isReflection() ? s->f * std::abs(s->wi.z) : SampledSpectrum();
}

TEST(DiffuseMaterial, HasTheReflectanceBoundedToOne) {
    const auto value = [](const Material& material) {
        auto lambda = SampledWavelengths::visible(0.1f);
        return material.bsdf({}, lambda).f(slanted, straight, TransportMode::Radiance)[0] * pi;
    };
    EXPECT_FLOAT_EQ(value(DiffuseMaterial()), 0.5f);
    EXPECT_FLOAT_EQ(value(DiffuseMaterial(constant(0.2f))), 0.2f);
    EXPECT_FLOAT_EQ(value(DiffuseMaterial(constant(3))), 1.f);
    EXPECT_EQ(DiffuseMaterial().interior(), nullptr);
    EXPECT_FALSE(DiffuseMaterial().isInterface());
}

TEST(DiffuseMaterial, FollowsItsSpectrum) {
    const DiffuseMaterial material(
        std::make_shared<PiecewiseLinearSpectrum>(std::vector<float>{360, 830}, std::vector<float>{0, 1}));
    const auto lambda = SampledWavelengths::uniform(0.3f);
    auto copy = lambda;
    const SampledSpectrum f = material.bsdf({}, copy).f(straight, slanted, TransportMode::Radiance);
    for (int i = 0; i < spectrumSamples; ++i)
        EXPECT_NEAR(f[i] * pi, (lambda[i] - 360) / 470, 1e-5);
    EXPECT_FALSE(copy.secondaryTerminated());
}

TEST(ConductorMaterial, IsCopperUnlessToldOtherwise) {
    auto lambda = SampledWavelengths::visible(0.7f);
    const SpectrumPtr eta = namedSpectrum("metal-Cu-eta"), k = namedSpectrum("metal-Cu-k");
    ASSERT_TRUE(eta && k);
    const auto s = ConductorMaterial().bsdf({}, lambda).sample(straight, 0, V2f(0, 0), TransportMode::Radiance);
    const SampledSpectrum expected = fresnelConductor(1, eta->sample(lambda), k->sample(lambda));
    for (int i = 0; i < spectrumSamples; ++i)
        EXPECT_FLOAT_EQ(s->f[i], expected[i]);
    EXPECT_FALSE(lambda.secondaryTerminated());
}

TEST(ConductorMaterial, ReflectsWhatIsAskedAtNormalIncidenceInAnyMedium) {
    for (float r : {0.f, 0.3f, 0.9f, 0.9999f})
        for (float etaOutside : {1.f, 1.33f})
            EXPECT_NEAR(reflected(ConductorMaterial::fromReflectance(constant(r)), straight, etaOutside)[0], r, 2e-5);
    EXPECT_NEAR(reflected(ConductorMaterial::fromReflectance(constant(1)), straight)[0], 0.9999, 1e-5);
}

TEST(ConductorMaterial, LosesContrastInAMedium) {
    const ConductorMaterial silver(constant(0.05f), constant(4));
    EXPECT_FLOAT_EQ(reflected(silver, slanted, 1.5f)[0],
                    fresnelConductor(slanted.z, SampledSpectrum(0.05f / 1.5f), SampledSpectrum(4 / 1.5f))[0]);
}

TEST(Roughness, IsRemappedBySquareRootByDefault) {
    auto lambda = SampledWavelengths::visible(0.7f);
    const SampledSpectrum eta(1), k(2);
    const auto value = [&](const Bsdf& bsdf) { return bsdf.f(straight, slanted, TransportMode::Radiance)[0]; };
    const auto expected = [&](float x, float y) { return value(ConductorBsdf(TrowbridgeReitz(x, y), eta, k)); };
    EXPECT_FLOAT_EQ(value(ConductorMaterial(constant(1), constant(2), 0.25f, 0.09f).bsdf({}, lambda)),
                    expected(0.5f, 0.3f));
    EXPECT_FLOAT_EQ(value(ConductorMaterial(constant(1), constant(2), 0.25f, 0.09f, false).bsdf({}, lambda)),
                    expected(0.25f, 0.09f));
    const Bsdf glass = DielectricMaterial({constant(1.5f), nullptr, {}}, 0.25f, 0.09f).bsdf({}, lambda);
    EXPECT_FLOAT_EQ(value(glass), value(DielectricBsdf(1.5f, TrowbridgeReitz(0.5f, 0.3f))));
}

TEST(DielectricMaterial, IsGlassByDefault) {
    const DielectricMaterial material;
    EXPECT_NEAR(reflected(material, straight)[0], 0.04, 1e-6);
    ASSERT_TRUE(material.interior());
    EXPECT_EQ((*material.interior()->eta)(500), 1.5f);
    EXPECT_EQ(material.interior()->absorption, nullptr);
    EXPECT_FALSE(material.interior()->priority);
}

TEST(DielectricMaterial, EndsSecondaryWavelengthsOnlyWhenItDisperses) {
    auto lambda = SampledWavelengths::visible(0.3f);
    DielectricMaterial({constant(1.5f), nullptr, {}}).bsdf({}, lambda);
    ThinDielectricMaterial(constant(1.5f)).bsdf({}, lambda);
    EXPECT_FALSE(lambda.secondaryTerminated());
    auto other = lambda;
    const Bsdf bsdf = DielectricMaterial({dispersive(), nullptr, {}}).bsdf({}, lambda);
    EXPECT_TRUE(lambda.secondaryTerminated());
    const auto s = bsdf.sample(straight, 0.99f, V2f(0, 0), TransportMode::Radiance);
    EXPECT_FLOAT_EQ(s->eta, (*dispersive())(lambda.hero()));
    ThinDielectricMaterial{dispersive()}.bsdf({}, other);
    EXPECT_TRUE(other.secondaryTerminated());
}

TEST(DielectricMaterial, WithAPriorityIsRelativeToWhatLiesOutside) {
    const Interior nested{constant(1.5f), nullptr, 2}, alone{constant(1.5f), nullptr, {}};
    const auto eta = [](const Interior& interior) {
        auto lambda = SampledWavelengths::visible(0.3f);
        const Bsdf bsdf = DielectricMaterial(interior).bsdf({{}, 1.33f}, lambda);
        return bsdf.sample(straight, 0.99f, V2f(0, 0), TransportMode::Radiance)->eta;
    };
    EXPECT_FLOAT_EQ(eta(nested), 1.5f / 1.33f);
    EXPECT_FLOAT_EQ(eta(alone), 1.5f);
}

TEST(DielectricMaterial, IsNotThereInItsLike) {
    auto lambda = SampledWavelengths::visible(0.3f);
    const DielectricMaterial glass({dispersive(), nullptr, 1});
    const Bsdf bsdf = glass.bsdf({{}, (*dispersive())(lambda.hero())}, lambda);
    const auto s = bsdf.sample(slanted, 0, V2f(0, 0), TransportMode::Radiance);
    ASSERT_TRUE(s && s->isTransmission());
    EXPECT_NEAR((s->wi + slanted).length(), 0, 1e-6);
}

TEST(DielectricMaterial, CountsAsAirWhereItsSpectrumHasNoData) {
    const auto narrow =
        std::make_shared<PiecewiseLinearSpectrum>(std::vector<float>{360, 361}, std::vector<float>{1.5f, 1.5f});
    auto lambda = SampledWavelengths::visible(0.5f);
    const auto s =
        DielectricMaterial({narrow, nullptr, {}}).bsdf({}, lambda).sample(slanted, 0, {}, TransportMode::Radiance);
    ASSERT_TRUE(s && s->isTransmission());
    EXPECT_EQ(s->eta, 1);
}

TEST(InterfaceMaterial, LetsEverythingPass) {
    EXPECT_TRUE(InterfaceMaterial().isInterface());
    auto lambda = SampledWavelengths::visible(0.5f);
    const auto s = InterfaceMaterial().bsdf({}, lambda).sample(slanted, 0, V2f(0, 0), TransportMode::Radiance);
    ASSERT_TRUE(s && s->isTransmission());
    EXPECT_NEAR((s->wi + slanted).length(), 0, 1e-6);
}

TEST(Materials, RefuseNonsense) {
    const auto throws = [](auto make) { EXPECT_THROW(make(), std::invalid_argument); };
    for (float bad : {-0.1f, NAN, INFINITY}) {
        throws([&] { DiffuseMaterial m(constant(bad)); });
        throws([&] { ConductorMaterial m(constant(bad), constant(1)); });
        throws([&] { ConductorMaterial m(constant(1), constant(bad)); });
        throws([&] { ConductorMaterial m(constant(1), constant(1), bad, 0); });
        throws([&] { ConductorMaterial m(constant(1), constant(1), 0, bad, false); });
        throws([&] { ConductorMaterial::fromReflectance(constant(bad)); });
        throws([&] { DielectricMaterial m({constant(bad), nullptr, {}}); });
        throws([&] { DielectricMaterial m({nullptr, constant(bad), {}}); });
        throws([&] { DielectricMaterial m({}, bad, 0); });
        throws([&] { DielectricMaterial m({}, 0, bad); });
        throws([&] { ThinDielectricMaterial m(constant(bad)); });
    }
    throws([] { DielectricMaterial m({constant(0), nullptr, {}}); });
    throws([] { ThinDielectricMaterial m(constant(0)); });
    throws([] { ConductorMaterial::fromReflectance(nullptr); });
    // Squares of such indices are not within a float's range: pictures were black.
    for (float absurd : {1e30f, 1e5f, 1e-5f, 1e-30f}) {
        throws([&] { DielectricMaterial m({constant(absurd), nullptr, {}}); });
        throws([&] { ThinDielectricMaterial m(constant(absurd)); });
    }
    throws([] { ConductorMaterial m(constant(1e30f), constant(1)); });
    throws([] { ConductorMaterial m(constant(1), constant(1e30f)); });
    EXPECT_NO_THROW(DielectricMaterial({constant(1e4f), nullptr, {}}, 0, 0));
    EXPECT_NO_THROW(ConductorMaterial(constant(1e-5f), constant(1e-5f)));
    try {
        DielectricMaterial m({}, 0, -2);
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "\"vroughness\" is -2, but must be 0 or more and finite");
    }
}

} // namespace
} // namespace vitrine
