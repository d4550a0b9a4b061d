// Where shadow rays end: never on the lamp that they go to, and behind all that stands before it.
#include "core/random.h"
#include "core/sampling.h"
#include "scene_text.h"

#include <fmt/format.h>

#include <functional>

namespace vitrine {
namespace {

/// More shapes than the caster for a handful takes, out of everybody's way.
std::string crowd() {
    std::string text = "AttributeBegin\nTranslate 0 -3e5 0\n";
    for (unsigned i = 0; i <= maxFlatPrimitives; ++i)
        text += "Shape \"disk\" \"float radius\" 0.01\n";
    return text + "AttributeEnd\n";
}

struct ShadowCount {
    int rays = 0, occluded = 0;
};

ShadowCount castShadows(const Scene& scene, const std::function<V3d(RandomStream&)>& place) {
    ShadowCount count;
    RandomStream random(5);
    const auto lambda = SampledWavelengths::visible(0.5f);
    for (int i = 0; i < 3000; ++i) {
        const V3d p = place(random);
        const V2f u(random.uniform(), random.uniform());
        for (const LightPtr& light : scene.world.lights.lights()) {
            const auto sample = light->sample(p, u, lambda);
            if (!sample) continue;
            ++count.rays;
            count.occluded += scene.world.caster->occluded(Ray{p, sample->shadow.d, sample->shadow.tMax});
        }
    }
    return count;
}

const std::string crowdOrNone[] = {"", crowd()};

TEST(ShadowEnds, LampsDoNotShadeThemselves) {
    const char* const lamps[] = {
        "Shape \"sphere\"",
        "Shape \"disk\"",
        "Shape \"cylinder\"",
        "Shape \"box\"",
        "Shape \"bilinearmesh\" \"point3 P\" [-1 0 -1  1 0 -1  -1 0 1  1 0 1]",
        "Rotate 33 1 2 3 Shape \"bilinearmesh\" \"point3 P\" [-1 0 -1  1 0 -1  -1 0 1  1 0 1]",
        "Rotate 33 1 2 3 Shape \"bilinearmesh\" \"point3 P\" [-1 0 -1  1 0 -1  -1 0 1  1 0 1] "
        "\"point2 uv\" [0 0 3 0 0 2 4 4]",
        "Rotate 33 1 2 3 Shape \"bilinearmesh\" \"point3 P\" [-1 0 -1  1 0 -1  -2 0 1  1 0 2]",
        "Rotate 33 1 2 3 Shape \"trianglemesh\" \"point3 P\" [-1 0 -1  1 0.3 -1  -1 0 1] \"integer indices\" [0 1 2]",
        "Shape \"revolution\" \"point2 P\" [0 -1  1.2 -1  1.2 1  0 1]"};
    for (const std::string& others : crowdOrNone)
        for (const char* lamp : lamps)
            for (const double away : {0., 1e4}) {
                const Scene scene = built(fmt::format("WorldBegin\n{}Translate {} 0 0\nScale 2 2 2\n"
                                                      "AreaLightSource \"diffuse\" \"bool twosided\" false\n{}\n",
                                                      others, away, lamp));
                // From anywhere, from near the surface to far away.
                const ShadowCount count = castShadows(scene, [&](RandomStream& random) {
                    const V3d w = toDouble(sampleUniformSphere(V2f(random.uniform(), random.uniform())));
                    return V3d(away, 0, 0) + w * (4 + std::pow(10., random.uniform(-2, 5)));
                });
                EXPECT_GT(count.rays, 400) << lamp;
                EXPECT_EQ(count.occluded, 0) << lamp << " at " << away << (others.empty() ? "" : " in a crowd");
            }
}

TEST(ShadowEnds, PointLightsInASurfaceAreNotHiddenByIt) {
    const char* const ceilings[] = {"Shape \"plane\" \"float d\" 3",
                                    "Shape \"box\" \"point3 pmin\" [-9 3 -9] \"point3 pmax\" [9 4 9]",
                                    "Shape \"bilinearmesh\" \"point3 P\" [-9 3 -9  9 3 -9  -9 3 9  9 3 9]"};
    for (const std::string& others : crowdOrNone)
        for (const char* ceiling : ceilings) {
            const Scene scene =
                built("WorldBegin\n" + others + "LightSource \"point\" \"point3 from\" [0.123 3 0.456]\n" + ceiling);
            const ShadowCount count = castShadows(scene, [](RandomStream& random) {
                return V3d(random.uniform(-8, 8), random.uniform(-5, 2.99f), random.uniform(-8, 8));
            });
            EXPECT_EQ(count.rays, 3000);
            EXPECT_EQ(count.occluded, 0) << ceiling << (others.empty() ? "" : " in a crowd");
        }
}

TEST(ShadowEnds, NoLightLeaksThroughASlabBeforeAFarLamp) {
    const char* const lamps[] = {
        "Shape \"bilinearmesh\" \"point3 P\" [-2e4 1e5 -2e4  2e4 1e5 -2e4  -2e4 1e5 2e4  2e4 1e5 2e4]",
        "Shape \"trianglemesh\" \"point3 P\" [-2e4 1e5 -2e4  2e4 1e5 -2e4  -2e4 1e5 2e4] \"integer indices\" [0 1 2]"};
    const char* const slabs[] = {
        "Shape \"box\" \"point3 pmin\" [-3e4 99999.93 -3e4] \"point3 pmax\" [3e4 99999.95 3e4]",
        "Shape \"bilinearmesh\" \"point3 P\" [-3e4 99999.95 -3e4  3e4 99999.95 -3e4  -3e4 99999.95 3e4  3e4 99999.95 "
        "3e4]",
        "Shape \"plane\" \"float d\" 99999.99"};
    for (const std::string& others : crowdOrNone)
        for (const char* lamp : lamps)
            for (const char* slab : slabs) {
                const Scene scene = built("WorldBegin\n" + others + slab +
                                          "\nAreaLightSource \"diffuse\" \"bool twosided\" true\n" + lamp);
                const ShadowCount count = castShadows(scene, [](RandomStream& random) {
                    return V3d(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5));
                });
                EXPECT_EQ(count.rays, 3000);
                EXPECT_EQ(count.occluded, count.rays)
                    << slab << " before " << lamp << (others.empty() ? "" : " in a crowd");
            }
}

} // namespace
} // namespace vitrine
