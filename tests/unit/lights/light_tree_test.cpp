#include "core/random.h"
#include "core/sampling.h"
#include "lights/light_tree.h"

#include <numeric>

namespace vitrine {
namespace {

V3d randomPoint(RandomStream& random, double size) {
    return V3d(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
}

V3f randomDirection(RandomStream& random) {
    const float u = random.uniform();
    return sampleUniformSphere(V2f(u, random.uniform()));
}

/// A small light that shines to one side or both, a bare point, or something large.
LightBounds randomBounds(RandomStream& random, double spread) {
    const V3d at = randomPoint(random, spread);
    const double kind = random.uniformDouble();
    LightBounds bounds;
    bounds.box = Box3d(at);
    if (kind > 0.2) bounds.box.extendBy(at + randomPoint(random, kind > 0.9 ? spread : 0.1));
    if (kind > 0.4) {
        bounds.normals = DirectionCone::about(toDouble(randomDirection(random)));
        bounds.normals.cosAngle = random.uniform(0.5, 1);
        bounds.cosReach = random.uniform(0, 0.9);
        bounds.twoSided = kind > 0.7;
    }
    bounds.intensity = std::exp(random.uniform(-8, 8));
    return bounds;
}

std::vector<LightBounds> randomLights(std::uint64_t seed, int count, double spread) {
    RandomStream random(seed, count);
    std::vector<LightBounds> lights;
    for (int i = 0; i < count; ++i)
        lights.push_back(randomBounds(random, spread));
    return lights;
}

LightReceiver randomReceiver(RandomStream& random, double size) {
    const V3d p = randomPoint(random, size);
    return random.uniform() < 0.5f ? LightReceiver(p) : LightReceiver(p, randomDirection(random));
}

/// Probabilities of all, and the samples that have them. The sum falls short of 1 by how often a group that may bring light
/// turns out to hold no light that does.
void expectConsistent(const LightTree& tree, std::size_t count, const LightReceiver& at) {
    std::vector<double> p;
    for (unsigned i = 0; i < count; ++i)
        p.push_back(tree.probability(at, i));
    const double sum = std::accumulate(p.begin(), p.end(), 0.);
    ASSERT_LE(sum, 1 + 1e-9);
    // Each light has an interval of u: evenly spaced numbers tell its length to one of them at either end.
    constexpr int n = 4096;
    std::vector<int> drawn(count);
    int none = 0;
    for (int i = 0; i < n; ++i) {
        const auto choice = tree.sample(at, (i + 0.5) / n);
        none += !choice;
        if (!choice) continue;
        ASSERT_NEAR(choice->probability, p[choice->leaf], 1e-12 * p[choice->leaf]);
        ++drawn[choice->leaf];
    }
    for (std::size_t i = 0; i < count; ++i)
        ASSERT_NEAR(drawn[i], n * p[i], 1.001) << i;
    ASSERT_NEAR(none, n * (1 - sum), 1.001 + double(count) / 2);
    if (count == 1) {
        ASSERT_EQ(sum, none == 0);
    }
}

TEST(LightTree, DrawsWithTheProbabilitiesThatItTells) {
    RandomStream random(1);
    for (const int count : {1, 2, 7, 8, 9, 64, 500})
        for (const double spread : {0., 1e-9, 1., 1e12}) {
            const auto lights = randomLights(2, count, spread);
            const LightTree tree(lights);
            for (int i = 0; i < 12; ++i)
                expectConsistent(tree, lights.size(), randomReceiver(random, i % 3 ? spread : 10 * spread + 1));
            expectConsistent(tree, lights.size(), LightReceiver(lights[0].box.center(), V3f(0, 0, 1)));
        }
}

TEST(LightTree, TenThousandLightsThatShineAllAroundSumToOne) {
    RandomStream random(3);
    auto lights = randomLights(4, 10000, 100);
    for (LightBounds& light : lights) {
        light.normals = {};
        light.cosReach = -1;
    }
    const LightTree tree(lights);
    for (int i = 0; i < 5; ++i) {
        const LightReceiver at(randomPoint(random, 100));
        double sum = 0;
        for (unsigned light = 0; light < lights.size(); ++light)
            sum += tree.probability(at, light);
        EXPECT_NEAR(sum, 1, 1e-9);
    }
}

TEST(LightTree, LightsAtOnePlaceAreSharedByIntensity) {
    std::vector<LightBounds> lights(1000);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        lights[i].box = Box3d(V3d(1, 2, 3));
        lights[i].intensity = double(i);
    }
    const LightTree tree(lights);
    const LightReceiver at(V3d(0, 0, 0), V3f(0, 0, 1));
    EXPECT_EQ(tree.probability(at, 0), 0) << "it does not shine";
    for (unsigned i = 1; i < lights.size(); ++i)
        EXPECT_NEAR(tree.probability(at, i), i / 499500., 1e-4 / 499500. * i);
}

TEST(LightTree, PassesOverWhatShinesAwayOrLiesBehind) {
    LightBounds up, down, behind;
    up.box = down.box = Box3d(V3d(-1, 5, -1), V3d(1, 5, 1));
    behind.box = Box3d(V3d(0, -5, 0));
    up.normals = DirectionCone::about(V3d(0, 1, 0));
    down.normals = DirectionCone::about(V3d(0, -1, 0));
    up.cosReach = down.cosReach = 0;
    up.intensity = 1e6;
    down.intensity = behind.intensity = 1;
    const LightReceiver floor(V3d(0, 0, 0), V3f(0, 1, 0));
    EXPECT_EQ(LightTree({up, down, behind}).probability(floor, 1), 1);
    EXPECT_FALSE(LightTree({up, behind}).sample(floor, 0.5));
    EXPECT_GT(LightTree({up, behind}).probability(LightReceiver(V3d(0, 0, 0)), 1), 0.99) << "seen from all around";
    up.twoSided = true;
    EXPECT_GT(LightTree({up, down}).probability(floor, 0), 0.99);
}

TEST(LightTree, NoLightsAndNoneThatShine) {
    EXPECT_TRUE(LightTree().empty());
    EXPECT_FALSE(LightTree().sample(LightReceiver(), 0.5));
    LightBounds dark;
    dark.box = Box3d(V3d(0, 0, 0));
    const LightTree tree({dark, dark});
    EXPECT_TRUE(tree.empty());
    EXPECT_EQ(tree.probability(LightReceiver(V3d(1, 1, 1)), 1), 0);
}

TEST(DirectionCones, UnitedHoldBoth) {
    RandomStream random(5);
    for (int i = 0; i < 10000; ++i) {
        DirectionCone cones[2];
        for (DirectionCone& cone : cones) {
            cone.axis = toDouble(randomDirection(random)).normalized();
            cone.cosAngle = random.uniform() < 0.3f ? 1 : random.uniform(-1, 1);
        }
        if (i % 10 == 0) cones[1].axis = i % 20 ? cones[0].axis : -cones[0].axis;
        const DirectionCone both = unite(cones[0], cones[1]);
        for (const DirectionCone& cone : cones) {
            const V3d side = cone.axis.cross(toDouble(randomDirection(random))).normalized();
            const V3d edge = cone.axis * cone.cosAngle + side * safeSqrt(1 - sqr(cone.cosAngle));
            EXPECT_GE(edge.dot(both.axis), both.cosAngle - 1e-7);
        }
    }
}

} // namespace
} // namespace vitrine
