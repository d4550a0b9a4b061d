#include "support/analytic_shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Transform scaling(double x, double y, double z) {
    M44d m;
    m.setScale(V3d(x, y, z));
    return Transform(m);
}

std::string complaint(double radius, double zMin, double zMax, double phiMax, const Transform& t = Transform()) {
    try {
        Sphere sphere(t, false, radius, zMin, zMax, phiMax);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "none";
}

TEST(Sphere, RefusesNonsense) {
    EXPECT_EQ(complaint(0, -1, 1, 360), "\"radius\" is 0, must be positive");
    EXPECT_EQ(complaint(-2, -1, 1, 360), "\"radius\" is -2, must be positive");
    EXPECT_EQ(complaint(nan, -1, 1, 360), "\"radius\" is nan, must be finite");
    EXPECT_EQ(complaint(infinityD, -1, 1, 360), "\"radius\" is inf, must be finite");
    EXPECT_EQ(complaint(1, 0.5, -0.5, 360), "\"zmin\" is 0.5, must be less than \"zmax\", which is -0.5");
    EXPECT_EQ(complaint(1, nan, 1, 360), "\"zmin\" is nan, must be finite");
    EXPECT_EQ(complaint(1, 2, 3, 360), "nothing of the sphere lies between \"zmin\" 2 and \"zmax\" 3: \"radius\" is 1");
    EXPECT_EQ(complaint(1, -1, 1, 0), "\"phimax\" is 0, must be positive");
    EXPECT_EQ(complaint(1, -1, 1, nan), "\"phimax\" is nan, must be finite");
    EXPECT_EQ(complaint(1, -1, 1, 360, scaling(1e-200, 1e-200, 1e-200)), "the transformation cannot be inverted");
    EXPECT_EQ(complaint(1, -5, 5, 400), "none");
}

TEST(Sphere, HitsWhereTheRayMeetsIt) {
    const Sphere sphere(Transform(), false, 2, -2, 2, 360);
    const Ray ray{V3d(0, -5, 0), V3d(0, 2, 0), infinityD};
    PrimitiveHit hit;
    ASSERT_TRUE(sphere.intersect(0, ray, 0, infinityD, hit));
    EXPECT_DOUBLE_EQ(hit.s, 1.5);
    const SurfacePoint point = sphere.pointAt(ray, hit);
    EXPECT_EQ(point.p, V3d(0, -2, 0));
    EXPECT_EQ(point.ng, V3f(0, -1, 0));
    EXPECT_FLOAT_EQ(point.uv.x, 0.75f);
    EXPECT_FLOAT_EQ(point.uv.y, 0.5f);
    EXPECT_NEAR((point.dpdu - V3f(4 * pi, 0, 0)).length(), 0, 1e-5);
    EXPECT_NEAR((point.dpdv - V3f(0, 0, 2 * pi)).length(), 0, 1e-5);
    EXPECT_NEAR((point.dndu - V3f(2 * pi, 0, 0)).length(), 0, 1e-5);
    EXPECT_NEAR((point.dndv - V3f(0, 0, pi)).length(), 0, 1e-5);
    ASSERT_TRUE(sphere.intersect(0, ray, hit.s, infinityD, hit));
    EXPECT_DOUBLE_EQ(hit.s, 3.5);
    EXPECT_FALSE(sphere.intersect(0, ray, hit.s, infinityD, hit));
}

TEST(Sphere, PolesHaveFiniteGeometry) {
    for (const Transform& transform : {Transform(), scaling(1, 2, 3)})
        for (const double z : {-5., 5.}) {
            const Sphere sphere(transform, false, 1, -1, 1, 360);
            const Ray ray{V3d(0, 0, z), V3d(0, 0, -z), infinityD};
            PrimitiveHit hit;
            ASSERT_TRUE(sphere.intersect(0, ray, 0, infinityD, hit));
            const SurfacePoint point = sphere.pointAt(ray, hit);
            EXPECT_FLOAT_EQ(point.uv.y, z < 0 ? 0.f : 1.f);
            EXPECT_EQ(point.dpdu, V3f(0, 0, 0));
            EXPECT_TRUE(isFinite(toDouble(point.dpdv)) && isFinite(toDouble(point.dndv)));
            EXPECT_GT(point.dpdv.length(), 1);
        }
}

TEST(Sphere, TangentRaysAreDecidedToRounding) {
    RandomStream rng(20251);
    for (const NamedTransform& placement : placements(1, 3)) {
        if (placement.name == "uneven") continue;
        const Transform& transform = placement.worldFromObject;
        const Sphere sphere(transform, false, 1, -1, 1, 360);
        for (int i = 0; i < 1000; ++i) {
            const V3d n = randomUnit(rng), d = n.cross(randomUnit(rng)).normalized();
            const double away = std::pow(10., rng.uniform(-2, 4));
            // The line's place is known to the rounding of its far start.
            const double doubt = 1e-13 + 1e-15 * away;
            PrimitiveHit hit;
            const Ray outside = transform.ray(Ray{n * (1 + doubt) - d * away, d, infinityD});
            EXPECT_FALSE(sphere.intersect(0, outside, 0, infinityD, hit));
            const Ray inside = transform.ray(Ray{n * (1 - doubt) - d * away, d, infinityD});
            ASSERT_TRUE(sphere.intersect(0, inside, 0, infinityD, hit));
            EXPECT_NEAR(hit.s, away, 2 * std::sqrt(2 * doubt) + 1e-12 * away);
        }
    }
}

TEST(Sphere, FarRaysMeetItAtTheRightPlace) {
    RandomStream rng(20252);
    const Sphere sphere(Transform(), false, 1e-3, -1e-3, 1e-3, 360);
    for (int i = 0; i < 1000; ++i) {
        const V3d target = randomUnit(rng) * 1e-3;
        V3d d = randomUnit(rng);
        if (d.dot(target) > 0) d = -d;
        if (d.dot(target) > -1e-4) continue;
        const Ray ray{target - d * 1e6, d, infinityD};
        PrimitiveHit hit;
        ASSERT_TRUE(sphere.intersect(0, ray, 0, infinityD, hit));
        const SurfacePoint point = sphere.pointAt(ray, hit);
        EXPECT_NEAR(point.p.length(), 1e-3, 1e-18);
        EXPECT_NEAR((point.p - target).length(), 0, 1e-8); // 1e6 * 2^-53 over a cosine of 0.1
    }
}

TEST(Sphere, ClippingShowsTheInside) {
    // A bowl, seen from above: the ray passes the opening and meets the inside of the far wall.
    const Sphere bowl(Transform(), false, 1, -2, 0, 360);
    const Ray down{V3d(0.5, 0, 4), V3d(0, 0, -1), infinityD};
    PrimitiveHit hit;
    ASSERT_TRUE(bowl.intersect(0, down, 0, infinityD, hit));
    EXPECT_NEAR(hit.s, 4 + std::sqrt(0.75), 1e-15);
    EXPECT_FALSE(bowl.isClosed());
    const Sphere wedge(Transform(), false, 1, -1, 1, 90);
    EXPECT_TRUE(wedge.occludes(0, Ray{V3d(2, 2, 0), V3d(-1, -1, 0), infinityD}, 0, infinityD));
    EXPECT_FALSE(wedge.occludes(0, Ray{V3d(2, 2, 0), V3d(-1, -1, 0), infinityD}, 1.5, infinityD));
}

TEST(Sphere, AreasInClosedForm) {
    const auto area = [](const Transform& t) { return Sphere(t, false, 1, -1, 1, 360).area(); };
    EXPECT_NEAR(area(scaling(2, 2, 2)), 16 * piD, 1e-12);
    EXPECT_NEAR(Sphere(scaling(2, 2, -2), false, 1, 0, 0.5, 90).area(), 4 * piD / 4, 1e-12);
    // Spheroids (Zwillinger 2018, "CRC standard mathematical tables", 4.17.3).
    for (const double c : {1.5, 10., 300.}) {
        const double e = std::sqrt(1 - 1 / (c * c));
        EXPECT_NEAR(area(scaling(1, 1, c)) / (2 * piD * (1 + c / e * std::asin(e))), 1, 1e-7) << c;
        EXPECT_NEAR(area(scaling(1, c, 1)) / (2 * piD * (1 + c / e * std::asin(e))), 1, 1e-7) << c;
        EXPECT_NEAR(area(scaling(c, c, 1)) / (2 * piD * (c * c + std::atanh(e) / e)), 1, 1e-7) << c;
    }
    const Transform scaled = scaling(1, 1, 3), rotated(tiltedRotation());
    EXPECT_NEAR(area(scaled.then(rotated)), area(scaled), 1e-8);
}

TEST(Sphere, ConeSamplesLieInSightWithTheDensityOfTheCone) {
    RandomStream rng(20253);
    for (const NamedTransform& placement : placements(1, 3)) {
        if (placement.name == "uneven") continue;
        const Sphere sphere(placement.worldFromObject, false, 1, -1, 1, 360);
        const V3d center = placement.worldFromObject.point(V3d(0, 0, 0));
        for (const double away : {1e-8, 1e-6, 1e-2, 1., 1e3, 1e7})
            for (int i = 0; i < 300; ++i) {
                const V3d from = center + randomUnit(rng) * (1 + away);
                const auto drawn = sphere.sample(from, V2f(rng.uniform(), rng.uniform()));
                ASSERT_TRUE(drawn);
                const SurfacePoint& point = drawn->point;
                const double distance2 = (from - center).length2();
                // The exact formula cancels from afar, where the first order does instead.
                const double solidAngle =
                    away < 1e3 ? 2 * piD * (1 - std::sqrt((distance2 - 1) / distance2)) : piD / distance2;
                EXPECT_NEAR(drawn->pdf * solidAngle, 1, 1e-5);
                EXPECT_FLOAT_EQ(drawn->pdf, sphere.pdf(from, PrimitiveHit{}, point));
                // On the side that faces `from`, as far as the rounding of a grazing direction can say.
                const V3d n = (point.p - center).normalized();
                EXPECT_GE(n.dot((from - point.p).normalized()), -1e-7);
                EXPECT_NEAR((point.p - center).length(), 1, 1e-14);
            }
    }
}

TEST(Sphere, FromItsOwnSurfaceIsSampledByAreaAndTheFarSideNeverByTheCone) {
    const Sphere sphere(Transform(), false, 2, -2, 2, 360);
    RandomStream rng(20261);
    for (int i = 0; i < 1000; ++i) {
        // A point of the surface may be rounded to either side; both must see the whole sphere.
        const V3d from = randomUnit(rng) * (2 * (1 + rng.uniform(-1, 1) * 1e-15));
        const V2f u(rng.uniform(), rng.uniform());
        const auto drawn = sphere.sample(from, u);
        ASSERT_TRUE(drawn);
        EXPECT_EQ(drawn->point.p, sphere.sample(u)->point.p);
        EXPECT_FLOAT_EQ(drawn->pdf, sphere.pdf(from, PrimitiveHit{}, drawn->point));
    }
    const V3d outside(0, 0, 5);
    SurfacePoint far;
    far.p = V3d(0, 0, -2);
    EXPECT_EQ(sphere.pdf(outside, PrimitiveHit{}, far), 0);
    far.p = V3d(0, 0, 2);
    EXPECT_GT(sphere.pdf(outside, PrimitiveHit{}, far), 0);
}

TEST(Sphere, SamplingFromInsideIsByArea) {
    const Sphere sphere(Transform(), false, 2, -2, 2, 360);
    const V3d from(0.5, 0, 0);
    const auto drawn = sphere.sample(from, V2f(0.3f, 0.7f));
    ASSERT_TRUE(drawn);
    const V3d d = drawn->point.p - from;
    const double cosine = std::abs(d.normalized().dot(toDouble(drawn->point.ng)));
    EXPECT_NEAR(drawn->pdf, d.length2() / cosine / (16 * piD), 1e-6);
    EXPECT_FLOAT_EQ(sphere.pdf(from, PrimitiveHit{}, drawn->point), drawn->pdf);
}

TEST(Sphere, ARotationInSinglePrecisionCountsAsRound) {
    M44d m = tiltedRotation();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            m[i][j] = double(float(m[i][j]));
    const Sphere sphere(Transform(m), false, 1, -1, 1, 360);
    // Only the round sphere is sampled by its cone, with one density for all points.
    const V3d from(0, 0, 3);
    const float first = sphere.sample(from, V2f(0.1f, 0.2f))->pdf, second = sphere.sample(from, V2f(0.8f, 0.6f))->pdf;
    EXPECT_EQ(first, second);
}

} // namespace
} // namespace vitrine::test
