#include "support/analytic_shapes.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

const V3d low(-1, -2, -3), high(4, 5, 6);

TEST(Box, RefusesNonsense) {
    const auto complaint = [](const V3d& pMin, const V3d& pMax) -> std::string {
        try {
            Box box(Transform(), false, pMin, pMax);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(complaint(V3d(0, 0, 0), V3d(1, 0, 1)), "\"pmin.y\" is 0, must be less than \"pmax.y\", which is 0");
    EXPECT_EQ(complaint(V3d(0, 0, 2), V3d(1, 1, 1)), "\"pmin.z\" is 2, must be less than \"pmax.z\", which is 1");
    EXPECT_EQ(complaint(V3d(0, 0, 0), V3d(infinityD, 1, 1)), "\"pmax.x\" is inf, must be finite");
}

TEST(Box, EveryFaceFacesOutAndItsParametersRunOverIt) {
    const Box box(Transform(), false, low, high);
    for (int axis = 0; axis < 3; ++axis)
        for (const bool greater : {false, true}) {
            const int next = (axis + 1) % 3, last = (axis + 2) % 3;
            V3d o = low + (high - low) * 0.25, d(0, 0, 0);
            o[axis] = greater ? 20 : -20;
            d[axis] = greater ? -1 : 1;
            const Ray ray{o, d, infinityD};
            PrimitiveHit hit;
            ASSERT_TRUE(box.intersect(0, ray, 0, infinityD, hit));
            const SurfacePoint point = box.pointAt(ray, hit);
            EXPECT_EQ(point.p[axis], greater ? high[axis] : low[axis]);
            EXPECT_EQ(point.ng, toFloat(-d));
            EXPECT_FLOAT_EQ(point.uv.x, greater ? 0.25f : 0.75f);
            EXPECT_FLOAT_EQ(point.uv.y, 0.25f);
            EXPECT_FLOAT_EQ(std::abs(point.dpdu[next]), float(high[next] - low[next]));
            EXPECT_FLOAT_EQ(point.dpdv[last], float(high[last] - low[last]));
            EXPECT_GT(point.dpdu.cross(point.dpdv).dot(point.ng), 0);
            ASSERT_TRUE(box.intersect(0, ray, hit.s, infinityD, hit));
            EXPECT_EQ(box.pointAt(ray, hit).ng, toFloat(d));
        }
}

TEST(Box, RaysAlongFacesOutsideMiss) {
    const Box box(Transform(), false, low, high);
    PrimitiveHit hit;
    EXPECT_FALSE(box.intersect(0, Ray{V3d(-9, 5.000001, 0), V3d(1, 0, 0), infinityD}, 0, infinityD, hit));
    ASSERT_TRUE(box.intersect(0, Ray{V3d(-9, 4.999999, 0), V3d(1, 0, 0), infinityD}, 0, infinityD, hit));
    EXPECT_DOUBLE_EQ(hit.s, 8);
    EXPECT_FALSE(box.intersect(0, Ray{V3d(0, 0, 0), V3d(1, 0, 0), infinityD}, 4, infinityD, hit)) << "sMax exclusive";
}

TEST(Box, ThroughItsEdgesFromAnywhere) {
    // Rounding must not put the start of the way in beyond the neighbouring face, which would be met at once.
    RandomStream rng(20281);
    for (const double distance : {1., 1e5})
        for (const NamedTransform& placement : placements(1, distance)) {
            const Box box(placement.worldFromObject, false, low, high);
            int tried = 0;
            for (int i = 0; i < 5000; ++i) {
                V3d edge = low + (high - low) * rng.uniform(0.2, 0.8);
                const int along = int(rng.uniform(0, 3));
                for (const int axis : {(along + 1) % 3, (along + 2) % 3})
                    edge[axis] = rng.uniform() < 0.5f ? low[axis] : high[axis];
                const V3d o = randomUnit(rng) * 30;
                const Ray ray = placement.worldFromObject.ray(Ray{o, edge - o, infinityD});
                PrimitiveHit hit;
                if (!box.intersect(0, ray, 0, infinityD, hit)) continue;
                const SurfacePoint point = box.pointAt(ray, hit);
                const V3d inside = placement.worldFromObject.point((low + high) / 2) - point.p;
                const Ray on{offsetOrigin(point, toFloat(inside)), inside, infinityD};
                ++tried;
                ASSERT_TRUE(box.intersect(0, on, 0, infinityD, hit));
                ASSERT_GT(hit.s, 1.9);
                ASSERT_LT(hit.s, 2.1);
            }
            EXPECT_GT(tried, 1000);
        }
}

TEST(Box, AreaUnderAnyTransform) {
    EXPECT_DOUBLE_EQ(Box(Transform(), false, low, high).area(), 2 * (5 * 7 + 7 * 9 + 9 * 5));
    M44d m;
    m.setScale(V3d(2, 3, -4));
    EXPECT_NEAR(Box(Transform(m * tiltedRotation()), false, low, high).area(), 2 * (10 * 21 + 21 * 36 + 36 * 10),
                1e-10);
}

} // namespace
} // namespace vitrine::test
