// Direct light by a tree over lights: what LightSampler draws and what it says of it.
#include "core/random.h"
#include "lights/constant_infinite_light.h"
#include "lights/light_sampler.h"
#include "lights/point_light.h"
#include "lights/scene_sphere.h"
#include "lights/spot_light.h"
#include "shapes/disk.h"
#include "shapes/plane.h"
#include "shapes/sphere.h"
#include "support/meshes.h"

namespace vitrine {
namespace {

using Choice = LightSampler::Choice;

const SampledWavelengths lambda = SampledWavelengths::visible(0.5f);
const SceneSphere lit{V3d(0), 10};

SpectrumPtr constant(float value) {
    return std::make_shared<ConstantSpectrum>(value);
}

V3d randomPoint(RandomStream& random, double size) {
    return V3d(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
}

V3f randomDirection(RandomStream& random) {
    const float u = random.uniform();
    return sampleUniformSphere(V2f(u, random.uniform()));
}

/// Lights of all kinds: meshes of several faces among them.
std::vector<LightPtr> allKinds() {
    const Transform tilt(M44d(0.8, 0.6, 0, 0, -0.36, 0.48, 0.8, 0, 0.48, -0.64, 0.6, 0, 3, -2, 1, 1));
    MeshInput bent = test::patch(V3d(0, 0, 0), V3d(1, 0, 0), V3d(0, 1, 0), V3d(1, 1, 1));
    MeshInput shaded = test::asTriangles(test::cubeMesh(V3d(4, 4, 0), 0.5));
    for (const V3f& p : shaded.p)
        shaded.n.push_back(V3f(p.z, p.x, 1)); // such that some faces are turned, wholly or in part
    return {std::make_shared<AreaLight>(test::onlyShape(test::icosphere(1, V3d(-4, 0, 0))), constant(1), false),
            std::make_shared<AreaLight>(test::onlyShape(test::cubeMesh(V3d(0, 4, 2))), constant(2), true),
            std::make_shared<AreaLight>(test::onlyShape(bent), constant(3), false),
            std::make_shared<AreaLight>(test::onlyShape(shaded), constant(3), false),
            std::make_shared<AreaLight>(std::make_shared<Disk>(tilt, false, 0, 1, 0, 360), constant(5), false),
            std::make_shared<AreaLight>(std::make_shared<Sphere>(tilt, false, 0.5, -0.5, 0.5, 360), constant(5), false),
            std::make_shared<PointLight>(V3d(-3, -3, -3), constant(4)),
            std::make_shared<SpotLight>(tilt, constant(9), SpotLight::Cone{40, 20}),
            std::make_shared<SpotLight>(tilt, constant(9), SpotLight::Cone{170, 120}),
            std::make_shared<SpotLight>(Transform(M44d(3, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1)), constant(9),
                                        SpotLight::Cone{30, 5}),
            std::make_shared<PointLight>(V3d(1, 1, 1), constant(0))};
}

TEST(LightChoice, ReachesAllThatShines) {
    const auto lights = allKinds();
    for (const LightPtr& light : lights) {
        // One light at a time: whatever part of it brings light must be drawn with some probability.
        std::vector<LightBounds> bounds;
        for (unsigned part = 0; part < light->partCount(); ++part)
            bounds.push_back(light->partBounds(part));
        const LightTree tree(bounds);
        RandomStream random(7);
        int lightens = 0;
        for (int i = 0; i < 20000; ++i) {
            const LightReceiver at(randomPoint(random, 6), randomDirection(random));
            const auto part = unsigned(random.uniform() * float(light->partCount()));
            const V2f u(random.uniform(), random.uniform());
            const auto sample = light->samplePart(part, at, u, lambda);
            if (!sample || !(sample->wi.dot(at.n) > 0)) continue;
            ++lightens;
            ASSERT_GT(tree.probability(at, part), 0) << at.p.x << ' ' << at.p.y << ' ' << at.p.z;
        }
        EXPECT_EQ(lightens > 0, !light->power(lambda).isBlack());
    }
}

TEST(LightChoice, DensityOfWhatARayHitsIsThatOfItsSample) {
    const auto lights = allKinds();
    const LightSampler sampler(lights, lit, Choice::Tree);
    RandomStream random(8);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const LightReceiver at(randomPoint(random, 6), i % 2 ? randomDirection(random) : V3f(0, 0, 0));
        const V2f u(random.uniform(), random.uniform());
        const auto sample = sampler.sample(at, random.uniform(), u, lambda);
        if (!sample || sample->isDelta) continue;
        ASSERT_GT(sample->pdf, 0);
        // The densities of all faces that the ray meets; the sampled one is among them.
        const Ray ray{at.p, sample->shadow.d, infinityD};
        double nearest = infinityD;
        bool grazes = false; // then the sampled point, which lies off the surface, is not where the ray meets it
        for (const LightPtr& light : lights) {
            const auto* area = dynamic_cast<const AreaLight*>(light.get());
            if (!area) continue;
            for (unsigned prim = 0; prim < area->shape().primitiveCount(); ++prim) {
                PrimitiveHit hit;
                for (double from = 0; area->shape().intersect(prim, ray, from, infinityD, hit); from = hit.s) {
                    const SurfacePoint point = area->shape().pointAt(ray, hit);
                    grazes |= std::abs(point.ng.dot(sample->wi)) < 0.05f;
                    const double pdf = sampler.pdf(at, *area, hit, point);
                    nearest = std::min(nearest, std::abs(pdf / double(sample->pdf) - 1));
                }
            }
        }
        if (grazes) continue;
        ASSERT_LT(nearest, 1e-2) << "density " << sample->pdf;
        ++hits;
    }
    EXPECT_GT(hits, 5000);
}

TEST(LightChoice, LightsAtInfinityStandBesideTheTree) {
    std::vector<LightPtr> lights = allKinds();
    const auto sky = std::make_shared<ConstantInfiniteLight>(constant(1e-3f));
    const auto plane =
        std::make_shared<AreaLight>(std::make_shared<Plane>(Transform(), false, V3d(0, 0, 1), 0.), constant(1), false);
    lights.push_back(sky);
    lights.push_back(plane);
    const LightSampler sampler(lights, lit, Choice::Tree);
    const float perSteradian = 1 / (4 * pi);
    const double share = double(sampler.pdf(*sky, V3f(0, 0, 1)) / perSteradian);
    EXPECT_GT(share, 0.09) << "one of two";
    EXPECT_LT(share, 0.2);
    const LightReceiver at(V3d(0, 0, 0));
    int escapes = 0;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) {
        const auto sample = sampler.sample(at, float(i) / n, V2f(0.5f, 0.5f), lambda);
        escapes += sample && sample->shadow.tMax == infinityD;
    }
    EXPECT_NEAR(escapes, n * share, 2);
    EXPECT_EQ(sampler.pdf(at, *plane, {}, {}), 0) << "infinite shapes are never chosen";
    EXPECT_EQ(LightSampler(allKinds(), lit, Choice::Tree).pdf(*sky, V3f(0, 0, 1)), 0) << "a light it does not know";
}

TEST(LightChoice, OnlyManyPartsAreWorthATree) {
    std::vector<LightPtr> few;
    for (std::size_t i = 0; i < LightSampler::fewParts; ++i)
        few.push_back(std::make_shared<PointLight>(V3d(double(i), 0, 0), constant(1)));
    EXPECT_FALSE(LightSampler(few, lit, Choice::Fitting).usesTree());
    EXPECT_FALSE(LightSampler(few, lit, Choice::Uniform).usesTree());
    EXPECT_TRUE(LightSampler(few, lit, Choice::Tree).usesTree());
    few.push_back(few[0]);
    EXPECT_TRUE(LightSampler(few, lit, Choice::Fitting).usesTree());
    EXPECT_FALSE(LightSampler(few, lit, Choice::Power).usesTree());
    EXPECT_TRUE(LightSampler({std::make_shared<AreaLight>(test::onlyShape(test::icosphere(0)), constant(1), false)},
                             lit, Choice::Fitting)
                    .usesTree())
        << "faces count";
}

TEST(LightChoice, NothingShines) {
    const LightSampler sampler({std::make_shared<PointLight>(V3d(0, 0, 0), constant(0))}, lit, Choice::Tree);
    EXPECT_FALSE(sampler.sample(LightReceiver(V3d(1, 0, 0)), 0.5f, V2f(0.5f, 0.5f), lambda));
}

} // namespace
} // namespace vitrine
