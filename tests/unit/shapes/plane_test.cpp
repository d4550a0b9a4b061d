#include "support/analytic_shapes.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

TEST(Plane, RefusesNonsense) {
    EXPECT_THROW(Plane(Transform(), false, V3d(0, 0, 0), 1), std::invalid_argument);
    EXPECT_THROW(Plane(Transform(), false, V3d(0, infinityD, 0), 1), std::invalid_argument);
    EXPECT_THROW(Plane(Transform(), false, V3d(0, 1, 0), infinityD), std::invalid_argument);
}

TEST(Plane, LiesWhereItsEquationSays) {
    const Plane plane(Transform(), false, V3d(0, 2, 0), 3);
    const Ray ray{V3d(4, 6, -7), V3d(0, -3, 0), infinityD};
    PrimitiveHit hit;
    ASSERT_TRUE(plane.intersect(0, ray, 0, infinityD, hit));
    EXPECT_DOUBLE_EQ(hit.s, 1.5);
    const SurfacePoint point = plane.pointAt(ray, hit);
    EXPECT_EQ(point.p, V3d(4, 1.5, -7));
    EXPECT_EQ(point.ng, V3f(0, 1, 0));
    EXPECT_FALSE(plane.intersect(0, Ray{V3d(0, 6, 0), V3d(0, 1, 0), infinityD}, 0, infinityD, hit));
    EXPECT_FALSE(plane.intersect(0, Ray{V3d(0, 6, 0), V3d(1, 0, 0), infinityD}, 0, infinityD, hit)) << "parallel";
    EXPECT_FALSE(plane.intersect(0, Ray{V3d(0, 1.5, 0), V3d(1, 0, 0), infinityD}, 0, infinityD, hit)) << "in it";
    EXPECT_EQ(Plane(Transform(), true, V3d(0, 2, 0), 3).pointAt(ray, hit).ng, V3f(0, -1, 0));
}

TEST(Plane, IsInfinite) {
    const Plane plane(Transform(), false, V3d(0, 0, 1), 0);
    EXPECT_EQ(plane.kind(), GeometryKind::Unbounded);
    EXPECT_EQ(plane.area(), infinityD);
    EXPECT_FALSE(plane.sample(V2f(0.5f, 0.5f)));
    EXPECT_FALSE(plane.sample(V3d(1, 2, 3), V2f(0.5f, 0.5f)));
    EXPECT_FALSE(plane.isClosed());
    const Ray ray{V3d(1e8, -3e8, 2), V3d(0.3, 0.4, -1), infinityD};
    PrimitiveHit hit;
    ASSERT_TRUE(plane.intersect(0, ray, 0, infinityD, hit));
    const SurfacePoint point = plane.pointAt(ray, hit);
    EXPECT_EQ(plane.pdf(hit), 0);
    EXPECT_EQ(plane.pdf(ray.o, hit, point), 0);
    EXPECT_NEAR(point.p.z, 0, 1e-300);
    EXPECT_EQ(point.uv, V2f(V2d(point.p.x, point.p.y)));
}

TEST(Plane, TransformsLikeItsPoints) {
    RandomStream rng(20271);
    for (const NamedTransform& placement : placements(2, 5)) {
        const V3d normal(0.3, -1, 0.6);
        const Plane plane(placement.worldFromObject, false, normal, 0.7);
        for (int i = 0; i < 200; ++i) {
            const V3d o = randomUnit(rng) * 4, d = randomUnit(rng);
            const double s = (0.7 - normal.dot(o)) / normal.dot(d);
            PrimitiveHit hit;
            const Ray ray = placement.worldFromObject.ray(Ray{o, d, infinityD});
            ASSERT_EQ(plane.intersect(0, ray, 0, infinityD, hit), s > 0);
            if (s > 0) {
                EXPECT_NEAR(hit.s / s, 1, 1e-12 / std::abs(normal.dot(d)));
            }
        }
    }
}

} // namespace
} // namespace vitrine::test
