// Mixes of materials, and the parameters of coated and translucent ones.
#include "bsdfs/coatedconductor_material.h"
#include "bsdfs/coateddiffuse_material.h"
#include "bsdfs/conductor_material.h"
#include "bsdfs/dielectric_material.h"
#include "bsdfs/diffuse_material.h"
#include "bsdfs/diffusetransmission_material.h"
#include "bsdfs/interface_material.h"
#include "bsdfs/mix_material.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace vitrine {
namespace {

SpectrumPtr constant(float value) {
    return std::make_shared<ConstantSpectrum>(value);
}
MaterialPtr matt(float reflectance) {
    return std::make_shared<DiffuseMaterial>(constant(reflectance));
}

/// u of the place.
class Ramp final : public FloatTexture {
  public:
    float evaluate(const TexturePoint& at) const override { return at.uv.x; }
};

/// Share of points, seen in many ways, where `which` is there.
double share(const MixMaterial& mix, const Material& which, float u = 0) {
    int there = 0;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) {
        MaterialPoint at;
        at.p = V3d(1e-3 * i, 2, 3);
        at.uv = V2f(u, 0);
        const auto lambda = SampledWavelengths::visible(0.3f);
        there += &mix.resolve(at, lambda) == &which;
    }
    return double(there) / n;
}

TEST(MixMaterial, ShowsTheSecondAtTheShareOfTheAmount) {
    const MaterialPtr a = matt(0.1f), b = matt(0.9f);
    EXPECT_EQ(share(MixMaterial(a, b, 0, 1), *a), 1);
    EXPECT_EQ(share(MixMaterial(a, b, -2, 1), *a), 1);
    EXPECT_EQ(share(MixMaterial(a, b, 1, 1), *b), 1);
    EXPECT_EQ(share(MixMaterial(a, b, 3, 1), *b), 1);
    const double error = 5 * std::sqrt(0.21 / 20000);
    EXPECT_NEAR(share(MixMaterial(a, b, 0.3f, 1), *b), 0.3, error);
    const MixMaterial ramp(a, b, FloatTexturePtr(std::make_shared<Ramp>()), 1);
    EXPECT_EQ(share(ramp, *b, 0), 0);
    EXPECT_EQ(share(ramp, *b, 1), 1);
    EXPECT_NEAR(share(ramp, *b, 0.7f), 0.7, error);
}

TEST(MixMaterial, NestedOnesChooseIndependently) {
    const MaterialPtr a = matt(0.1f), b = matt(0.5f), c = matt(0.9f);
    const auto inner = std::make_shared<MixMaterial>(a, b, 0.5f, 1);
    const MixMaterial outer(inner, c, 0.5f, 2);
    const double error = 5 * std::sqrt(0.1875 / 20000);
    EXPECT_NEAR(share(outer, *a), 0.25, error);
    EXPECT_NEAR(share(outer, *b), 0.25, error);
}

TEST(MixMaterial, ChoosesOnceForAWayOfSeeingAPoint) {
    const MaterialPtr a = matt(0.1f), b = matt(0.9f);
    const MixMaterial mix(a, b, 0.5f, 1);
    int changedByDirection = 0, changedByPass = 0;
    for (int i = 0; i < 200; ++i) {
        MaterialPoint at;
        at.p = V3d(i, 0.5, 0);
        const auto lambda = SampledWavelengths::visible(0.3f), later = SampledWavelengths::visible(0.31f);
        const Material& chosen = mix.resolve(at, lambda);
        EXPECT_EQ(&mix.resolve(at, lambda), &chosen);
        changedByPass += &mix.resolve(at, later) != &chosen;
        at.wo = V3f(0.6f, 0, 0.8f);
        changedByDirection += &mix.resolve(at, lambda) != &chosen;
    }
    EXPECT_GT(changedByPass, 50) << "fixed eye paths must see both";
    EXPECT_GT(changedByDirection, 50);
}

TEST(MixMaterial, BoundsTheSolidOfItsDielectrics) {
    const auto glass = [](float eta, float absorption, std::optional<int> priority, float roughness) {
        return std::make_shared<DielectricMaterial>(Interior{constant(eta), constant(absorption), priority}, roughness,
                                                    roughness);
    };
    const auto polished = glass(1.5f, 0.2f, 1, 0);
    EXPECT_EQ(MixMaterial(matt(0.5f), polished, 0.5f, 1).interior(), polished->interior()) << "painted";
    EXPECT_EQ(MixMaterial(polished, glass(1.5f, 0.2f, 1, 0.3f), 0.5f, 1).interior(), polished->interior()) << "frosted";
    EXPECT_EQ(MixMaterial(matt(0.5f), matt(0.1f), 0.5f, 1).interior(), nullptr);
    for (const auto& different : {glass(1.4f, 0.2f, 1, 0), glass(1.5f, 0.3f, 1, 0), glass(1.5f, 0.2f, 2, 0),
                                  glass(1.5f, 0.2f, std::nullopt, 0)})
        EXPECT_THROW(MixMaterial(polished, different, 0.5f, 1), std::invalid_argument);
    EXPECT_THROW(MixMaterial(matt(0.5f), std::make_shared<InterfaceMaterial>(), 0.5f, 1), std::invalid_argument);
    EXPECT_THROW(MixMaterial(nullptr, matt(0.5f), 0.5f, 1), std::invalid_argument);
    EXPECT_THROW(MixMaterial(matt(0.1f), matt(0.5f), NAN, 1), std::invalid_argument);
}

TEST(Materials, SayWhetherPhotonsMayCount) {
    const auto mirror = std::make_shared<ConductorMaterial>();
    EXPECT_TRUE(mirror->isPolished());
    EXPECT_FALSE(ConductorMaterial(constant(1), constant(2), 0.1f, 0).isPolished());
    EXPECT_TRUE(MixMaterial(mirror, mirror, 0.5f, 1).isPolished());
    EXPECT_FALSE(MixMaterial(mirror, matt(0.5f), 0.5f, 1).isPolished());
    EXPECT_TRUE(CoatedConductorMaterial().isPolished());
    EXPECT_FALSE(CoatedDiffuseMaterial().isPolished());
    CoatParameters milky;
    milky.albedo = constant(0.5f);
    EXPECT_FALSE(CoatedConductorMaterial(MetalIndex(), 0, 0, milky).isPolished());
    // A texture may be rough elsewhere.
    EXPECT_FALSE(
        ConductorMaterial(constant(1), constant(2), FloatTexturePtr(std::make_shared<Ramp>()), 0).isPolished());
}

TEST(CoatedMaterials, HaveTheDefaultsOfPbrt) {
    auto lambda = SampledWavelengths::visible(0.3f);
    const V3f straight(0, 0, 1);
    for (const Bsdf& bsdf : {CoatedDiffuseMaterial().bsdf({}, lambda), CoatedConductorMaterial().bsdf({}, lambda)}) {
        const auto s = bsdf.sample(straight, 0, V2f(0.5f, 0.5f), TransportMode::Radiance);
        ASSERT_TRUE(s && s->isSpecular());
        EXPECT_NEAR(s->f[0], 0.04f, 1e-6) << "a polished coat of index 1.5";
    }
    EXPECT_FALSE(lambda.secondaryTerminated());
    CoatParameters dispersive;
    dispersive.eta =
        std::make_shared<PiecewiseLinearSpectrum>(std::vector<float>{360, 830}, std::vector<float>{1.6f, 1.5f});
    CoatedDiffuseMaterial(nullptr, dispersive).bsdf({}, lambda);
    EXPECT_TRUE(lambda.secondaryTerminated());
}

TEST(CoatedMaterials, RefuseNonsense) {
    const auto refuses = [](auto change, const char* message) {
        CoatParameters p;
        change(p);
        try {
            CoatedConductorMaterial m(MetalIndex(), 0, 0, p);
            FAIL() << message;
        } catch (const std::invalid_argument& error) {
            EXPECT_STREQ(error.what(), message);
        }
    };
    refuses([](auto& p) { p.thickness = -1; }, "\"thickness\" is -1, but must be 0 or more and finite");
    refuses([](auto& p) { p.g = 1.5f; }, "\"g\" is 1.5, but must lie in [-1, 1]");
    refuses([](auto& p) { p.nsamples = 0; }, "\"nsamples\" is 0, but must lie in [1, 65535]");
    refuses([](auto& p) { p.maxdepth = -1; }, "\"maxdepth\" is -1, but must lie in [0, 65535]");
    refuses([](auto& p) { p.uroughness = -2; }, "\"interface.uroughness\" is -2, but must be 0 or more and finite");
    refuses([](auto& p) { p.eta = constant(0); },
            "\"interface.eta\" is 0, but an index of refraction must be positive");
    EXPECT_THROW(CoatedConductorMaterial(MetalIndex(), -1, 0), std::invalid_argument);
    EXPECT_THROW(MetalIndex::ofReflectance(nullptr), std::invalid_argument);
}

TEST(DiffuseTransmissionMaterial, ScalesAndBounds) {
    const V3f above = V3f(0.6f, -0.3f, 0.5f).normalized(), below(0, 0, -1), straight(0, 0, 1);
    const auto values = [&](const Material& m) {
        auto lambda = SampledWavelengths::visible(0.3f);
        const Bsdf bsdf = m.bsdf({}, lambda);
        return V2f(bsdf.f(above, straight, TransportMode::Radiance)[0] * pi,
                   bsdf.f(above, below, TransportMode::Radiance)[0] * pi);
    };
    EXPECT_NEAR((values(DiffuseTransmissionMaterial()) - V2f(0.25f, 0.25f)).length(), 0, 1e-6);
    EXPECT_NEAR((values(DiffuseTransmissionMaterial(constant(0.2f), constant(0.7f))) - V2f(0.2f, 0.7f)).length(), 0,
                1e-6);
    EXPECT_NEAR((values(DiffuseTransmissionMaterial(constant(0.2f), constant(0.7f), 2)) - V2f(0.4f, 1)).length(), 0,
                1e-6);
    EXPECT_THROW(DiffuseTransmissionMaterial(nullptr, nullptr, -1), std::invalid_argument);
}

} // namespace
} // namespace vitrine
