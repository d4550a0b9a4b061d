#include "core/random.h"
#include "lights/constant_infinite_light.h"
#include "lights/light_sampler.h"
#include "lights/point_light.h"

namespace vitrine {
namespace {

LightPtr pointLight(float intensity) {
    return std::make_shared<PointLight>(V3d(0), std::make_shared<ConstantSpectrum>(intensity));
}

TEST(LightSampler, ProbabilitiesFollowPower) {
    const auto sky = std::make_shared<ConstantInfiniteLight>(std::make_shared<ConstantSpectrum>(1 / pi));
    sky->preprocess(V3d(0), 1); // 4 pi^2 r^2 / pi: as much as the first point light
    const std::vector<LightPtr> lights{pointLight(1), pointLight(6), sky};
    const LightSampler sampler(lights);
    EXPECT_NEAR(sampler.probability(lights[0].get()), 0.125, 1e-6);
    EXPECT_NEAR(sampler.probability(lights[1].get()), 0.75, 1e-6);
    EXPECT_NEAR(sampler.probability(lights[2].get()), 0.125, 1e-6);
    EXPECT_EQ(sampler.probability(pointLight(1).get()), 0) << "a light it does not know";
}

TEST(LightSampler, SamplesAsItSays) {
    std::vector<LightPtr> lights{pointLight(1), pointLight(0), pointLight(2.5f), pointLight(0.3f)};
    const LightSampler sampler(lights);
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
    const LightSampler sampler(lights);
    EXPECT_FLOAT_EQ(sampler.probability(lights[0].get()), 0.5f);
    EXPECT_FLOAT_EQ(sampler.probability(lights[1].get()), 0.5f);
}

TEST(LightSampler, UniformTakesNoNoteOfPower) {
    const std::vector<LightPtr> lights{pointLight(0), pointLight(9), pointLight(1)};
    const LightSampler sampler(lights, LightSampler::Choice::Uniform);
    for (const auto& light : lights)
        EXPECT_FLOAT_EQ(sampler.probability(light.get()), 1 / 3.f);
}

TEST(LightSampler, CountsVisibleLightMore) {
    const auto band = [](float low, float high) {
        const std::vector<float> lambdas{low, high}, values{1, 1};
        return std::make_shared<PointLight>(V3d(0), std::make_shared<PiecewiseLinearSpectrum>(lambdas, values));
    };
    const std::vector<LightPtr> lights{band(520, 580), band(760, 820)};
    const LightSampler sampler(lights);
    EXPECT_GT(sampler.probability(lights[0].get()), 5 * sampler.probability(lights[1].get()));
}

TEST(LightSampler, MayBeEmpty) {
    EXPECT_TRUE(LightSampler().empty());
    EXPECT_TRUE(LightSampler(std::vector<LightPtr>()).empty());
}

} // namespace
} // namespace vitrine
