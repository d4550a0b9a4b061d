#include "support/analytic_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vitrine::test {
namespace {

std::string complaint(double radius, double zMin, double zMax, double phiMax) {
    try {
        Cylinder cylinder(Transform(), false, radius, zMin, zMax, phiMax);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "none";
}

TEST(Cylinder, RefusesNonsense) {
    EXPECT_EQ(complaint(-1, -1, 1, 360), "\"radius\" is -1, must be positive");
    EXPECT_EQ(complaint(1, 1, 1, 360), "\"zmin\" is 1, must be less than \"zmax\", which is 1");
    EXPECT_EQ(complaint(1, -infinityD, 1, 360), "\"zmin\" is -inf, must be finite");
    EXPECT_EQ(complaint(1, -1, 1, 0), "\"phimax\" is 0, must be positive");
    EXPECT_EQ(complaint(1, -1, 1, 360), "none");
}

TEST(Cylinder, HitsOutsideAndInside) {
    const Cylinder cylinder(Transform(), false, 2, 0, 4, 360);
    const Ray ray{V3d(0, 5, 1), V3d(0, -2, 0), infinityD};
    PrimitiveHit hit;
    ASSERT_TRUE(cylinder.intersect(0, ray, 0, infinityD, hit));
    EXPECT_DOUBLE_EQ(hit.s, 1.5);
    const SurfacePoint point = cylinder.pointAt(ray, hit);
    EXPECT_EQ(point.p, V3d(0, 2, 1));
    EXPECT_EQ(point.ng, V3f(0, 1, 0));
    EXPECT_FLOAT_EQ(point.uv.x, 0.25f);
    EXPECT_FLOAT_EQ(point.uv.y, 0.25f);
    EXPECT_NEAR((point.dpdu - V3f(-4 * pi, 0, 0)).length(), 0, 1e-5);
    EXPECT_EQ(point.dpdv, V3f(0, 0, 4));
    EXPECT_NEAR((point.dndu - V3f(-2 * pi, 0, 0)).length(), 0, 1e-5);
    EXPECT_EQ(point.dndv, V3f(0, 0, 0));
    ASSERT_TRUE(cylinder.intersect(0, ray, hit.s, infinityD, hit));
    EXPECT_DOUBLE_EQ(hit.s, 3.5);
}

TEST(Cylinder, IsOpenAtTheEnds) {
    const Cylinder cylinder(Transform(), false, 1, -1, 1, 360);
    PrimitiveHit hit;
    for (const double x : {0., 0.5, 1., 2.}) {
        const Ray along{V3d(x, 0, -5), V3d(0, 0, 1), infinityD};
        EXPECT_FALSE(cylinder.intersect(0, along, 0, infinityD, hit)) << x;
    }
    // In through the open end, out through the wall.
    ASSERT_TRUE(cylinder.intersect(0, Ray{V3d(0, 0, 3), V3d(0.4, 0, -1), infinityD}, 0, infinityD, hit));
    EXPECT_DOUBLE_EQ(hit.s, 2.5);
    EXPECT_FALSE(cylinder.isClosed());
}

TEST(Cylinder, TangentRaysAreDecidedToRounding) {
    RandomStream rng(20261);
    const Cylinder cylinder(Transform(), false, 1, -1, 1, 360);
    for (int i = 0; i < 1000; ++i) {
        const double phi = rng.uniform(0, 2 * piD), away = std::pow(10., rng.uniform(-2, 4));
        const V3d n(std::cos(phi), std::sin(phi), 0), d(-n.y, n.x, 0);
        const double doubt = 1e-14 + 1e-15 * away;
        PrimitiveHit hit;
        EXPECT_FALSE(cylinder.intersect(0, Ray{n * (1 + doubt) - d * away, d, infinityD}, 0, infinityD, hit));
        EXPECT_TRUE(cylinder.intersect(0, Ray{n * (1 - doubt) - d * away, d, infinityD}, 0, infinityD, hit));
    }
}

TEST(Cylinder, AreasInClosedForm) {
    EXPECT_NEAR(Cylinder(Transform(), false, 2, -1, 3, 90).area(), 2 * 4 * piD / 2, 1e-12);
    for (const double b : {1.5, 20., 1000.}) {
        M44d m;
        m.setScale(V3d(1, b, 5));
        const double perimeter = 4 * b * std::comp_ellint_2(std::sqrt(1 - 1 / (b * b)));
        EXPECT_NEAR(Cylinder(Transform(m * tiltedRotation()), false, 1, -1, 1, 360).area() / (10 * perimeter), 1, 1e-9);
    }
}

} // namespace
} // namespace vitrine::test
