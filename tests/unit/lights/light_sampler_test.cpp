#include "core/random.h"
#include "lights/constant_infinite_light.h"
#include "lights/distant_light.h"
#include "lights/light_sampler.h"
#include "lights/point_light.h"
#include "lights/scene_sphere.h"
#include "shapes/plane.h"

namespace vitrine {
namespace {

LightPtr pointLight(float intensity) {
    return std::make_shared<PointLight>(V3d(0), std::make_shared<ConstantSpectrum>(intensity));
}

const SceneSphere unitSphere{V3d(0), 1};

std::shared_ptr<PointLight> bandLight(std::vector<float> lambdas, std::vector<float> values) {
    return PointLight::create(Transform(), {std::make_shared<PiecewiseLinearSpectrum>(lambdas, values)});
}

TEST(LightSampler, ProbabilitiesFollowPower) {
    const auto sky = std::make_shared<ConstantInfiniteLight>(std::make_shared<ConstantSpectrum>(1 / pi));
    // 4 pi^2 r^2 / pi: as much as the first point light
    const std::vector<LightPtr> lights{pointLight(1), pointLight(6), sky};
    const LightSampler sampler(lights, unitSphere);
    const double even = 0.2 / 3;
    EXPECT_NEAR(sampler.probability(lights[0].get()), 0.8 * 0.125 + even, 1e-6);
    EXPECT_NEAR(sampler.probability(lights[1].get()), 0.8 * 0.75 + even, 1e-6);
    EXPECT_NEAR(sampler.probability(lights[2].get()), 0.8 * 0.125 + even, 1e-6);
    EXPECT_EQ(sampler.probability(pointLight(1).get()), 0) << "a light it does not know";
}

TEST(LightSampler, MissesNoLineHoweverNarrow) {
    for (int nm = 360; nm <= 830; ++nm) {
        const float lambda = float(nm);
        const std::vector<LightPtr> lights{pointLight(1e-9f),
                                           bandLight({lambda - 0.1f, lambda, lambda + 0.1f}, {0, 1000, 0})};
        const LightSampler sampler(lights, unitSphere);
        ASSERT_GT(sampler.probability(lights[1].get()), 0.89) << nm;
    }
}

TEST(LightSampler, EveryLightThatShinesHasItsPart) {
    const auto sun = std::make_shared<DistantLight>(V3d(0, 1, 0), std::make_shared<ConstantSpectrum>(1e-30f));
    const std::vector<LightPtr> lights{pointLight(1e30f), pointLight(1e-30f), sun, pointLight(0)};
    for (const double radius : {0., 1e-12, 1., 1e30}) {
        const LightSampler sampler(lights, {V3d(0), radius});
        EXPECT_GT(sampler.probability(lights[1].get()), 0.06) << radius;
        EXPECT_EQ(sampler.probability(lights[3].get()), 0) << radius;
        EXPECT_GT(sampler.probability(sun.get()), 0.06) << radius;
    }
}

TEST(LightSampler, OfLightsThatShineTooBrightForFloatsNoneIsLost) {
    const auto sun = std::make_shared<DistantLight>(V3d(0, 1, 0), std::make_shared<ConstantSpectrum>(1e7f));
    const std::vector<LightPtr> lights{pointLight(1), sun};
    EXPECT_GT(LightSampler(lights, {V3d(0), 1e18}).probability(sun.get()), 0.8);
}

TEST(LightSampler, InfiniteShapesAreNeverChosen) {
    const auto floor = std::make_shared<AreaLight>(std::make_shared<Plane>(Transform(), false, V3d(0, 1, 0), 0),
                                                   std::make_shared<ConstantSpectrum>(1.f), false);
    const std::vector<LightPtr> lights{pointLight(1), floor};
    const LightSampler sampler(lights, unitSphere);
    EXPECT_EQ(sampler.probability(floor.get()), 0);
    EXPECT_EQ(sampler.probability(lights[0].get()), 1);
}

TEST(LightSampler, SamplesAsItSays) {
    std::vector<LightPtr> lights{pointLight(1), pointLight(0), pointLight(2.5f), pointLight(0.3f)};
    const LightSampler sampler(lights, unitSphere);
    std::map<const Light*, int> counts;
    const int n = 100000; // evenly spread numbers: counts are exact to a few
    for (int i = 0; i < n; ++i) {
        const auto chosen = sampler.sample((float(i) + 0.5f) / n);
        ++counts[chosen.light];
        EXPECT_EQ(chosen.probability, sampler.probability(chosen.light));
    }
    for (const auto& light : lights)
        EXPECT_NEAR(counts[light.get()], n * sampler.probability(light.get()), 5);
    EXPECT_EQ(counts[lights[1].get()], 0) << "a black light";
}

TEST(LightSampler, BlackLightsAreAllAlikeWhenThereAreNoOthers) {
    const std::vector<LightPtr> lights{pointLight(0), pointLight(0)};
    const LightSampler sampler(lights, unitSphere);
    EXPECT_FLOAT_EQ(sampler.probability(lights[0].get()), 0.5f);
    EXPECT_FLOAT_EQ(sampler.probability(lights[1].get()), 0.5f);
}

TEST(LightSampler, UniformTakesNoNoteOfPower) {
    const std::vector<LightPtr> lights{pointLight(0), pointLight(9), pointLight(1)};
    const LightSampler sampler(lights, unitSphere, LightSampler::Choice::Uniform);
    for (const auto& light : lights)
        EXPECT_FLOAT_EQ(sampler.probability(light.get()), 1 / 3.f);
}

TEST(LightSampler, CountsVisibleLightMore) {
    const auto band = [](float low, float high) {
        const std::vector<float> lambdas{low, high}, values{1, 1};
        return std::make_shared<PointLight>(V3d(0), std::make_shared<PiecewiseLinearSpectrum>(lambdas, values));
    };
    const std::vector<LightPtr> lights{band(520, 580), band(760, 820)};
    const LightSampler sampler(lights, unitSphere);
    EXPECT_GT(sampler.probability(lights[0].get()), 5 * sampler.probability(lights[1].get()));
}

TEST(LightSampler, MayBeEmpty) {
    EXPECT_TRUE(LightSampler().empty());
    EXPECT_TRUE(LightSampler(std::vector<LightPtr>(), unitSphere).empty());
}

} // namespace
} // namespace vitrine
