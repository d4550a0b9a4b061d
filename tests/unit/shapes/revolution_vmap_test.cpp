// "vmap" "arclength": v by the length of the profile.
#include "shapes/quadrature.h"
#include "shapes/revolution/revolution.h"
#include "support/revolution_cases.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using namespace test;

/// Length of the whole profile up to v, by the curves' own adaptive quadrature.
double lengthUpTo(const Profile& profile, double v) {
    const double position = v * double(profile.segments().size());
    double sum = 0;
    for (std::size_t i = 0; i < profile.segments().size() && double(i) < position; ++i)
        sum += profile.segments()[i].length(0, std::min(1., position - double(i))).value;
    return sum;
}

/// (s^2 + 1, s^3 + 1) for s = 2t - 1, then a stop (coinciding control points) and a stretch along the same line.
const std::vector<V2d> cuspAndStop{{2, 0}, {2. / 3, 2}, {2. / 3, 0}, {2, 2}, {2, 2}, {2.5, 3}, {2.5, 3}};

TEST(ArcLengthMap, IsTheLengthToTheStatedAccuracy) {
    for (int i = 0; i < 24; ++i) {
        RandomStream random(41, i);
        const int degree = i == 0 ? 3 : i == 1 ? 8 : i == 2 ? 3 : 1 + i % 20;
        const Profile profile(i == 0   ? joined(gobletProfile())
                              : i == 1 ? joined(vaseProfile())
                              : i == 2 ? cuspAndStop
                                       : joined(randomProfile(random, degree)),
                              degree);
        const ArcLengthMap map(profile);
        const double total = lengthUpTo(profile, 1);
        EXPECT_NEAR(map.total(), total, 1e-8 * total);
        EXPECT_EQ(map.fraction(0), 0);
        EXPECT_NEAR(map.fraction(1), 1, 1e-15);
        double last = 0;
        for (int k = 0; k <= 60; ++k) {
            const double v = std::min(1., (k + 0.3 * random.uniformDouble()) / 60), fraction = map.fraction(v);
            EXPECT_NEAR(fraction, lengthUpTo(profile, v) / total, 1e-8) << degree << " at " << v;
            EXPECT_GE(fraction, last - 1e-8);
            last = fraction;
        }
        EXPECT_LT(map.memoryBytes(), 400000u) << degree;
    }
}

struct Pair {
    Revolution byParameter, byLength;

    Pair(const std::vector<V2d>& points, int degree, double phiMax, const M44d& matrix)
        : byParameter(Transform(matrix), false, Profile(points, degree), phiMax),
          byLength(Transform(matrix), false, Profile(points, degree), phiMax, VMap::ArcLength) {}
};

SurfacePoint pointAt(const Revolution& shape, const M44d& matrix, double u, double v) {
    const double phi = u * radians(shape.phiMaxDegrees());
    const Ray ray{Transform(matrix).point(V3d(std::cos(phi), 0, std::sin(phi))), V3d(1, 0, 0)};
    return shape.pointAt(ray, PrimitiveHit{0, u, v, 0});
}

/// Differences by the texture's own (u, v), found from those of the profile's parameter.
TEST(RevolutionVMap, DerivativesAreByTheNewCoordinates) {
    M44d matrix;
    matrix.rotate(V3d(0.3, 0.7, -0.4));
    matrix.scale(V3d(1.5, 0.7, 2));
    for (const bool goblet : {true, false}) {
        const Pair shapes(joined(goblet ? gobletProfile() : vaseProfile()), goblet ? 3 : 8, 300, matrix);
        const Revolution& shape = shapes.byLength;
        const auto at = [&](double u, double v) { return pointAt(shape, matrix, u, v); };
        for (const double u : {0.1, 0.6})
            for (const double v : {0.16, 0.31, 0.55, 0.83}) {
                const double step = 1e-4;
                const SurfacePoint c = at(u, v), above = at(u, v + step), below = at(u, v - step);
                const SurfacePoint right = at(u + step, v), left = at(u - step, v);
                const double dv = shape.textureV(v + step) - shape.textureV(v - step), du = 2 * step;
                EXPECT_FLOAT_EQ(c.uv.y, float(shape.textureV(v)));
                EXPECT_FLOAT_EQ(c.uv.x, float(u));
                const auto expectNear = [](const V3f& d, const V3d& difference) {
                    EXPECT_LT((toDouble(d) - difference).length(), 2e-3 * (1 + d.length()));
                };
                expectNear(c.dpdv, (above.p - below.p) / dv);
                expectNear(c.dpdu, (right.p - left.p) / du);
                expectNear(c.dndv, (toDouble(above.ns) - toDouble(below.ns)) / dv);
                expectNear(c.dndu, (toDouble(right.ns) - toDouble(left.ns)) / du);
            }
    }
}

TEST(RevolutionVMap, SpeedIsTheSameEverywhere) {
    const Pair shapes(cuspAndStop, 3, 360, M44d());
    const double total = lengthUpTo(shapes.byLength.profile(), 1);
    for (const double v : {0., 0.1, 0.25, 0.4999, 0.5, 0.75, 1.}) { // 0.25: the cusp; 0.5 and 1: stops
        const SurfacePoint c = pointAt(shapes.byLength, M44d(), 0.2, v);
        EXPECT_NEAR(c.dpdv.length(), total, 1e-6 * total) << v;
        EXPECT_TRUE(std::isfinite(c.dndv.length())) << v;
    }
}

/// Only the texture coordinate and what is derived by it differ.
TEST(RevolutionVMap, LeavesHitsAndSamplesAlone) {
    const Pair shapes(joined(gobletProfile()), 3, 360, M44d());
    RandomStream random(42);
    int hits = 0;
    for (int i = 0; i < 500; ++i) {
        const V2f u(random.uniform(), random.uniform());
        const ShapeSample a = *shapes.byParameter.sample(u), b = *shapes.byLength.sample(u);
        EXPECT_EQ(a.point.p, b.point.p);
        EXPECT_EQ(a.point.ng, b.point.ng);
        EXPECT_EQ(a.pdf, b.pdf);
        EXPECT_NEAR(b.point.uv.y, shapes.byLength.textureV(double(a.point.uv.y)), 1e-6) << "uv are floats";
        const Ray ray{V3d(2, 1.5, 1), a.point.p - V3d(2, 1.5, 1)};
        PrimitiveHit hitA, hitB;
        for (unsigned prim = 0; prim < shapes.byLength.primitiveCount(); ++prim) {
            const bool found = shapes.byParameter.intersect(prim, ray, 0, infinityD, hitA);
            ASSERT_EQ(found, shapes.byLength.intersect(prim, ray, 0, infinityD, hitB));
            if (!found) continue;
            ++hits;
            EXPECT_EQ(hitA.s, hitB.s);
            EXPECT_EQ(shapes.byParameter.pdf(hitA), shapes.byLength.pdf(hitB));
            EXPECT_EQ(shapes.byParameter.pointAt(ray, hitA).ns, shapes.byLength.pointAt(ray, hitB).ns);
        }
    }
    EXPECT_GT(hits, 400);
    EXPECT_EQ(shapes.byParameter.area(), shapes.byLength.area());
}

} // namespace
} // namespace vitrine
