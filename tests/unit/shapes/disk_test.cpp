#include "support/analytic_shapes.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

std::string complaint(double height, double radius, double innerRadius, double phiMax) {
    try {
        Disk disk(Transform(), false, height, radius, innerRadius, phiMax);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "none";
}

TEST(Disk, RefusesNonsense) {
    EXPECT_EQ(complaint(infinityD, 1, 0, 360), "\"height\" is inf, must be finite");
    EXPECT_EQ(complaint(0, 0, 0, 360), "\"radius\" is 0, must be positive");
    EXPECT_EQ(complaint(0, 1, -0.5, 360), "\"innerradius\" is -0.5, is negative");
    EXPECT_EQ(complaint(0, 1, 1, 360), "\"innerradius\" is 1, must be less than \"radius\", which is 1");
    EXPECT_EQ(complaint(0, 1, 0, -5), "\"phimax\" is -5, must be positive");
    EXPECT_EQ(complaint(0, 1, 0, 720), "none");
}

TEST(Disk, HitsRingBetweenItsRadii) {
    const Disk disk(Transform(), false, 1, 2, 0.5, 360);
    PrimitiveHit hit;
    const auto from = [](double x, double y) { return Ray{V3d(x, y, 5), V3d(0, 0, -2), infinityD}; };
    const Ray ray = from(0, 1.25);
    ASSERT_TRUE(disk.intersect(0, ray, 0, infinityD, hit));
    EXPECT_DOUBLE_EQ(hit.s, 2);
    const SurfacePoint point = disk.pointAt(ray, hit);
    EXPECT_EQ(point.p, V3d(0, 1.25, 1));
    EXPECT_EQ(point.ng, V3f(0, 0, 1));
    EXPECT_FLOAT_EQ(point.uv.x, 0.25f);
    EXPECT_FLOAT_EQ(point.uv.y, 0.5f);
    EXPECT_NEAR((point.dpdu - V3f(-2.5f * pi, 0, 0)).length(), 0, 1e-5);
    EXPECT_NEAR((point.dpdv - V3f(0, -1.5f, 0)).length(), 0, 1e-6);
    EXPECT_FALSE(disk.intersect(0, from(0.3, 0.3), 0, infinityD, hit));
    EXPECT_FALSE(disk.intersect(0, from(1.5, 1.5), 0, infinityD, hit));
    EXPECT_FALSE(disk.intersect(0, Ray{V3d(-3, 0, 1), V3d(1, 0, 0), infinityD}, 0, infinityD, hit)) << "in its plane";
}

TEST(Disk, CentreHasFiniteGeometry) {
    const Disk disk(Transform(), false, 0, 1, 0, 360);
    const Ray ray{V3d(0, 0, 1), V3d(0, 0, -1), infinityD};
    PrimitiveHit hit;
    ASSERT_TRUE(disk.intersect(0, ray, 0, infinityD, hit));
    const SurfacePoint point = disk.pointAt(ray, hit);
    EXPECT_EQ(point.dpdu, V3f(0, 0, 0));
    EXPECT_FLOAT_EQ(point.dpdv.length(), 1);
    EXPECT_FLOAT_EQ(point.uv.y, 1);
}

TEST(Disk, GrazingRaysFromAfarCount) {
    const Disk disk(Transform(), false, 0, 1, 0, 360);
    PrimitiveHit hit;
    const Ray ray{V3d(-1e3, 0, 1e-6), V3d(1, 0, -1e-9), infinityD};
    ASSERT_TRUE(disk.intersect(0, ray, 0, infinityD, hit));
    EXPECT_NEAR(hit.s, 1e3, 1e-9);
}

TEST(Disk, AreaUnderAnyTransform) {
    M44d m;
    m.setScale(V3d(2, 3, 7));
    EXPECT_NEAR(Disk(Transform(m), false, 0, 1, 0, 360).area(), 6 * piD, 1e-12);
    EXPECT_NEAR(Disk(Transform(m * tiltedRotation()), false, 0, 2, 1, 90).area(), 6 * piD * 3 / 4, 1e-12);
}

} // namespace
} // namespace vitrine::test
