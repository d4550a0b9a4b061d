// d_r(y), and the roots on profiles whose crossings have closed forms.
#include "plot/ray_section.h"

#include <gtest/gtest.h>

namespace vitrine::plot {
namespace {

/// A cylinder of radius 1, y from -1 to 1, with a bottom and a lid.
Profile can() {
    return Profile(std::vector<V2d>{V2d(0, -1), V2d(1, -1), V2d(1, 1), V2d(0, 1)}, 1);
}

/// y = x^2, x from 0 to 2; t = x / 2.
Profile paraboloid() {
    return Profile(std::vector<V2d>{V2d(0, 0), V2d(1, 0), V2d(2, 4)}, 2);
}

TEST(RaySection, IsTheHyperbola) {
    const Ray ray{V3d(0.3, -2, 1.5), V3d(0.4, 0.7, -0.9)};
    const RaySection section(ray);
    EXPECT_FALSE(section.isHorizontal());
    EXPECT_FALSE(section.isAxial());
    for (const double s : {-3., -0.2, 0., 1., 1.3, 8.}) {
        const V3d p = ray.at(s);
        EXPECT_NEAR(section.height(s), p.y, 1e-14);
        EXPECT_NEAR(section.distance(s), std::hypot(p.x, p.z), 1e-14 * 10);
        EXPECT_NEAR(std::sqrt(section.a() * sqr(p.y - section.b()) + section.c()), std::hypot(p.x, p.z), 1e-13);
    }
    EXPECT_LE(section.closest(), section.distance(section.sAtClosest() + 1e-3));
    EXPECT_NEAR(section.closest(), section.distance(section.sAtClosest()), 1e-15);
}

TEST(RaySection, SpecialRays) {
    const RaySection level(Ray{V3d(-3, 2, 0.5), V3d(2, 0, 0)});
    EXPECT_TRUE(level.isHorizontal());
    EXPECT_EQ(level.closest(), 0.5);
    EXPECT_EQ(level.sAtClosest(), 1.5);
    const RaySection axial(Ray{V3d(0.3, 5, -0.4), V3d(0, -2, 0)});
    EXPECT_TRUE(axial.isAxial());
    EXPECT_DOUBLE_EQ(axial.distance(7), 0.5);
    const RaySection through(Ray{V3d(0.3, 5, -0.4), V3d(-0.3, 1, 0.4)});
    EXPECT_EQ(through.c(), 0);
    EXPECT_NEAR(through.b(), 6, 1e-14);
}

TEST(RaySection, StretchIsWhatTheFigureHolds) {
    const RaySection oblique(Ray{V3d(-3, -1, 0.5), V3d(1, 1, 0)});
    const auto [low, high] = oblique.stretch(0, 3, 1.3); // heights: s in [1, 4]; distances: |s - 3| <= 1.2
    EXPECT_NEAR(low, 1.8, 1e-14);
    EXPECT_NEAR(high, 4, 1e-14);
    const auto missed = oblique.stretch(0, 3, 0.4);
    EXPECT_GT(missed.first, missed.second);
    const RaySection level(Ray{V3d(-3, 2, 0.5), V3d(2, 0, 0)});
    EXPECT_NEAR(level.stretch(0, 3, 1.3).first, 0.9, 1e-14);
    EXPECT_GT(level.stretch(0, 1, 1.3).first, level.stretch(0, 1, 1.3).second);
    const auto points = oblique.points(low, high);
    EXPECT_EQ(points.front(), oblique.at(low));
    EXPECT_EQ(points.back(), oblique.at(high));
    EXPECT_EQ(std::min_element(points.begin(), points.end(), [](V2d a, V2d b) { return a.y < b.y; })->y, 0.5);
}

TEST(RaySection, RootsOfTheWholeLine) {
    // Enters the can's wall behind the origin at x = -0.8, z = 0.6, leaves it at x = 0.8.
    const auto roots = RaySection(Ray{V3d(0.4, 0.25, 0.6), V3d(0.5, 0, 0)}).roots(can(), 360);
    ASSERT_EQ(roots.size(), 2u);
    EXPECT_NEAR(roots[0].s, -2.4, 1e-12);
    EXPECT_NEAR(roots[1].s, 0.8, 1e-12);
    EXPECT_FALSE(roots[0].counts());
    EXPECT_TRUE(roots[1].counts());
    for (const RayRoot& root : roots) {
        EXPECT_EQ(root.segment, 1);
        EXPECT_NEAR(root.t, 0.625, 1e-12);
        EXPECT_NEAR(root.d, 1, 1e-12);
        EXPECT_NEAR(root.y, 0.25, 1e-12);
    }
}

TEST(RaySection, RootsInOrderWithTheirPlaces) {
    // Through the axis at y = 1: x = s - 1, y = s / 2 + 1/2, on the paraboloid where y = x^2.
    const auto roots = RaySection(Ray{V3d(-1, 0.5, 0), V3d(1, 0.5, 0)}).roots(paraboloid(), 360);
    ASSERT_EQ(roots.size(), 2u);
    const double root17 = std::sqrt(17.);
    EXPECT_NEAR(roots[0].s, (5 - root17) / 4, 1e-12);
    EXPECT_NEAR(roots[1].s, (5 + root17) / 4, 1e-12);
    EXPECT_NEAR(roots[0].d, std::abs((1 - root17) / 4), 1e-12);
    EXPECT_NEAR(roots[1].t, (1 + root17) / 8, 1e-12);
    EXPECT_NEAR(roots[1].y, sqr((1 + root17) / 4), 1e-12);
}

TEST(RaySection, TellsWhatPhimaxLeavesOut) {
    // At x = 0.8 and x = -0.8, z = -0.6: phi = 323 and 217 degrees.
    const Ray ray{V3d(3, 0, -0.6), V3d(-1, 0, 0)};
    const auto roots = RaySection(ray).roots(can(), 270);
    ASSERT_EQ(roots.size(), 2u);
    EXPECT_FALSE(roots[0].inSector);
    EXPECT_TRUE(roots[1].inSector);
    EXPECT_TRUE(RaySection(ray).roots(can(), 360)[0].inSector);
}

} // namespace
} // namespace vitrine::plot
