// What all analytic shapes must do alike, against the oracle in long double.
#include "support/analytic_shapes.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Calls `check` for every shape under every map of size 1 near the origin.
template <class Check>
void forAllShapes(const std::vector<AnalyticShape>& shapes, Check&& check) {
    for (const AnalyticShape& analytic : shapes)
        for (const NamedTransform& placement : placements(1, 0.5))
            for (const bool reverse : {false, true}) {
                SCOPED_TRACE(analytic.name + ", " + placement.name + (reverse ? ", reversed" : ""));
                check(analytic, placement.worldFromObject, reverse, *analytic.make(placement.worldFromObject, reverse));
            }
}

TEST(AnalyticShapes, RaysWithZeroNanOrInfiniteComponentsMeetNothing) {
    std::vector<AnalyticShape> shapes = allAnalyticShapes();
    for (const AnalyticShape& analytic : shapes)
        for (const Transform& transform :
             {Transform(), placements(1, 2)[0].worldFromObject, placements(1, 2)[2].worldFromObject}) {
            SCOPED_TRACE(analytic.name);
            const ShapePtr shape = analytic.make(transform, false);
            const V3d inside = transform.point(V3d(0.01, 0.02, 0.2)), above = transform.point(V3d(0.35, 0.3, 5));
            for (const V3d& o : {inside, above, transform.point(V3d(0, 0, 0))})
                for (const double bad : {nan, infinityD, -infinityD})
                    for (int i = 0; i < 3; ++i)
                        for (const V3d& d :
                             {V3d(0, 0, -1), V3d(0, 1, 0), V3d(1, 0, 0), V3d(0.3, 0.4, -0.6), V3d(0, 0, 0)}) {
                            Ray badOrigin{o, d, infinityD}, badDirection{o, d, infinityD},
                                zero{o, V3d(0, 0, 0), infinityD};
                            badOrigin.o[i] = bad;
                            badDirection.d[i] = bad;
                            PrimitiveHit hit;
                            for (const Ray& ray : {badOrigin, badDirection, zero}) {
                                ASSERT_FALSE(shape->intersect(0, ray, 0, infinityD, hit)) << ray.o << ray.d;
                                ASSERT_FALSE(shape->occludes(0, ray, 0, infinityD)) << ray.o << ray.d;
                            }
                        }
        }
}

/// A ray of any length of d, from near or far, towards the shape's neighbourhood; some along the object's axes.
Ray randomRay(const Transform& worldFromObject, RandomStream& rng) {
    V3d target = randomUnit(rng) * rng.uniform(0, 1.5), d = randomUnit(rng);
    const int axis = int(rng.uniform(0, 8));
    if (axis < 3) {
        d = V3d(0, 0, 0);
        d[axis] = rng.uniform() < 0.5f ? 1 : -1;
    }
    const double away = rng.uniform() < 0.3f ? rng.uniform(0, 1) : std::pow(10., rng.uniform(0, 5));
    const double length = std::pow(10., rng.uniform(-4, 4));
    return worldFromObject.ray(Ray{target - d * away, d * length, infinityD});
}

TEST(AnalyticShapes, EveryCrossingAgreesWithTheOracle) {
    RandomStream rng(20243);
    forAllShapes(allAnalyticShapes(), [&](const AnalyticShape& analytic, const Transform& transform, bool,
                                          const Shape& shape) {
        int compared = 0, crossings = 0;
        for (int i = 0; i < 4000; ++i) {
            const Ray ray = randomRay(transform, rng);
            Vec o, d;
            toObject(transform, ray, o, d);
            const LineCrossings expected = analytic.cross(o, d);
            // Rounding decides about lines that touch the surface or its edges.
            const Real doubt = 1e-14L * sqrtl(o.dot(o)) + 1e-12L;
            bool isDefinite = fabsl(expected.tangency) > doubt;
            for (const Crossing& c : expected.all)
                isDefinite = isDefinite && fabsl(c.margin) > 10 * doubt && fabsl(c.s) * sqrtl(d.dot(d)) > 10 * doubt;
            if (!isDefinite) continue;
            ++compared;
            double from = 0;
            for (const Crossing& c : expected.all) {
                if (c.margin < 0 || c.s < 0) continue;
                PrimitiveHit hit;
                ASSERT_TRUE(shape.intersect(0, ray, from, infinityD, hit)) << "missed at " << c.s;
                ASSERT_TRUE(shape.occludes(0, ray, from, infinityD));
                const SurfacePoint point = shape.pointAt(ray, hit);
                const double length = ray.d.length(), cosine = std::abs(ray.d.dot(toDouble(point.ng))) / length;
                const double rounding = 1e-14 * (ray.o - point.p).length() + 4 * point.error;
                ASSERT_NEAR(hit.s * length, double(c.s) * length, rounding / cosine);
                ASSERT_LE((point.p - ray.at(double(c.s))).length(), rounding / cosine + rounding);
                from = hit.s;
                ++crossings;
            }
            PrimitiveHit hit;
            ASSERT_FALSE(shape.intersect(0, ray, from, infinityD, hit)) << "met once more at " << hit.s;
            ASSERT_FALSE(shape.occludes(0, ray, from, infinityD));
        }
        EXPECT_GT(compared, 2500);
        EXPECT_GT(crossings, 500);
    });
}

TEST(AnalyticShapes, IntervalEndsAreExclusive) {
    forAllShapes(allAnalyticShapes(), [&](const AnalyticShape&, const Transform& transform, bool, const Shape& shape) {
        const Ray ray = transform.ray(Ray{V3d(0.41, 0.43, 7), V3d(0.001, -0.002, -1), infinityD});
        PrimitiveHit hit, other;
        if (!shape.intersect(0, ray, 0, infinityD, hit)) return;
        EXPECT_FALSE(shape.intersect(0, ray, 0, hit.s, other));
        EXPECT_FALSE(shape.occludes(0, ray, 0, hit.s));
        const double before = std::nextafter(hit.s, 0.), after = std::nextafter(hit.s, infinityD);
        EXPECT_TRUE(shape.intersect(0, ray, before, after, other));
        if (shape.intersect(0, ray, hit.s, infinityD, other)) {
            EXPECT_GT(other.s, hit.s + 1e-3);
        }
    });
}

TEST(AnalyticShapes, NormalsAreUnitAndFlipOnReversalAndMirroring) {
    RandomStream rng(20244);
    forAllShapes(boundedAnalyticShapes(), [&](const AnalyticShape& analytic, const Transform& transform, bool reverse,
                                              const Shape& shape) {
        const bool flips = reverse != (analytic.mirrorsInsideOut && transform.swapsHandedness());
        for (int i = 0; i < 200; ++i) {
            const auto drawn = shape.sample(V2f(rng.uniform(), rng.uniform()));
            ASSERT_TRUE(drawn);
            const SurfacePoint& point = drawn->point;
            EXPECT_NEAR(point.ng.length(), 1, 1e-6f);
            EXPECT_EQ(point.ns, point.ng);
            // A step outwards raises the oracle's distance.
            Vec p, unused;
            toObject(transform, Ray{point.p + toDouble(point.ng) * (flips ? -1e-3 : 1e-3), V3d(), 0}, p, unused);
            EXPECT_GT(analytic.distance(p), 1e-5L);
        }
        EXPECT_EQ(shape.isClosed(), analytic.isConvexSolid && !flips);
    });
}

/// Two points a short way apart, by rays from a point that sees both.
TEST(AnalyticShapes, DerivativesAreThoseOfNeighbouringHits) {
    RandomStream rng(20245);
    forAllShapes(allAnalyticShapes(), [&](const AnalyticShape&, const Transform& transform, bool, const Shape& shape) {
        int compared = 0;
        for (int i = 0; i < 2000; ++i) {
            const V3d d = randomUnit(rng);
            const Ray ray = transform.ray(Ray{randomUnit(rng) - d * 4, d, infinityD});
            Ray near = ray;
            near.d += transform.vector(randomUnit(rng) * 2e-5);
            PrimitiveHit hit, nearHit;
            if (!shape.intersect(0, ray, 0, infinityD, hit) || !shape.intersect(0, near, 0, infinityD, nearHit))
                continue;
            const SurfacePoint a = shape.pointAt(ray, hit), b = shape.pointAt(near, nearHit);
            const V3d dp = b.p - a.p;
            // Poles and seams, glancing rays, and edges of the box have no such neighbour.
            const double du = double(b.uv.x) - a.uv.x, dv = double(b.uv.y) - a.uv.y;
            if (dp.length() > 1e-3 || std::abs(du) > 5e-3 || std::abs(dv) > 5e-3 || a.ng.dot(b.ng) < 0.9f) continue;
            ++compared;
            const V3d dpdu = toDouble(a.dpdu), dpdv = toDouble(a.dpdv);
            const double uvRounding = 2e-7 * (dpdu.length() + dpdv.length());
            EXPECT_LE((dp - dpdu * du - dpdv * dv).length(), 0.03 * dp.length() + uvRounding);
            const V3d dn = toDouble(b.ns) - toDouble(a.ns), dndu = toDouble(a.dndu), dndv = toDouble(a.dndv);
            const double normalRounding = 2e-7 * (1 + dndu.length() + dndv.length());
            EXPECT_LE((dn - dndu * du - dndv * dv).length(), 0.03 * (dn.length() + dp.length()) + normalRounding);
        }
        EXPECT_GT(compared, 200);
    });
}

TEST(AnalyticShapes, ParametersNameThePoint) {
    RandomStream rng(20246);
    forAllShapes(
        allAnalyticShapes(), [&](const AnalyticShape& analytic, const Transform& transform, bool, const Shape& shape) {
            if (!analytic.pointOf) return;
            int compared = 0;
            for (int i = 0; i < 500; ++i) {
                PrimitiveHit hit;
                const V3d o = randomUnit(rng) * 3;
                const Ray ray = transform.ray(Ray{o, randomUnit(rng) - o, infinityD});
                if (!shape.intersect(0, ray, 0, infinityD, hit)) continue;
                const SurfacePoint point = shape.pointAt(ray, hit);
                const double reach = 1 + point.p.length();
                EXPECT_LE((point.p - transform.point(analytic.pointOf(point.uv.x, point.uv.y))).length(), 3e-6 * reach);
                ++compared;
            }
            EXPECT_GT(compared, 50);
        });
}

TEST(AnalyticShapes, BoundsHoldTheShapeAndAreTight) {
    RandomStream rng(20247);
    forAllShapes(
        boundedAnalyticShapes(), [&](const AnalyticShape& analytic, const Transform&, bool, const Shape& shape) {
            const Box3d bounds = shape.bounds();
            Box3d seen;
            for (int i = 0; i < 20000; ++i) {
                const SurfacePoint point = shape.sample(V2f(rng.uniform(), rng.uniform()))->point;
                seen.extendBy(point.p);
                for (int axis = 0; axis < 3; ++axis) {
                    ASSERT_GE(point.p[axis], bounds.min[axis] - point.error);
                    ASSERT_LE(point.p[axis], bounds.max[axis] + point.error);
                }
            }
            if (analytic.name.find("partial") != std::string::npos || analytic.name.find("sector") != std::string::npos)
                return;
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_GE(seen.size()[axis], 0.9 * bounds.size()[axis]);
        });
}

TEST(AnalyticShapes, SamplesAreHitAndClaimTheirDensity) {
    RandomStream rng(20248);
    forAllShapes(boundedAnalyticShapes(), [&](const AnalyticShape&, const Transform&, bool, const Shape& shape) {
        for (int i = 0; i < 500; ++i) {
            const auto drawn = shape.sample(V2f(rng.uniform(), rng.uniform()));
            ASSERT_TRUE(drawn);
            const SurfacePoint& point = drawn->point;
            const V3d n = toDouble(point.ng);
            const Ray ray{point.p + n * 1e-6, -n, infinityD};
            PrimitiveHit hit;
            ASSERT_TRUE(shape.intersect(0, ray, 0, infinityD, hit));
            EXPECT_NEAR(hit.s, 1e-6, 4 * point.error);
            EXPECT_NEAR(shape.pdf(hit), drawn->pdf, 1e-4f * drawn->pdf);
            const SurfacePoint again = shape.pointAt(ray, hit);
            // At the seam u may be 0 or 1.
            if (point.uv.x > 1e-3f && point.uv.x < 0.999f) {
                EXPECT_LE((again.uv - point.uv).length(), 1e-4f);
            }
            EXPECT_GE(point.uv.x, 0);
            EXPECT_LE(point.uv.x, 1);
            EXPECT_GE(point.uv.y, 0);
            EXPECT_LE(point.uv.y, 1);
        }
    });
}

} // namespace
} // namespace vitrine::test
