// Rays that leave a surface: none meets it again where it was, none slips through.
#include "support/analytic_shapes.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

/// A unit direction on a random side of the surface; half of them graze it.
V3f randomDirection(const V3f& ng, RandomStream& rng) {
    V3d w = randomUnit(rng);
    if (rng.uniform() < 0.5f) {
        const V3d n = toDouble(ng);
        const double slope = std::pow(10., rng.uniform(-9, -1));
        w = (w - n * n.dot(w)).normalized() + n * (rng.uniform() < 0.5f ? slope : -slope);
    }
    return toFloat(w.normalized());
}

/// A ray from outside that meets the shape, and the meeting; the point and direction by chance.
bool randomHit(const Shape& shape, double size, RandomStream& rng, SurfacePoint& point) {
    const auto target = shape.sample(V2f(rng.uniform(), rng.uniform()));
    Ray ray;
    ray.d = -randomUnit(rng);
    ray.o = target->point.p - ray.d * (size * std::pow(10., rng.uniform(-1, 3)));
    PrimitiveHit hit;
    if (!shape.intersect(0, ray, 0, infinityD, hit)) return false;
    point = shape.pointAt(ray, hit);
    return true;
}

class Reintersection {
  public:
    Reintersection(const AnalyticShape& analytic, const NamedTransform& placement, double size)
        : analytic_(analytic), worldFromObject_(placement.worldFromObject), size_(size),
          shape_(analytic.make(placement.worldFromObject, false)) {}

    void run(int rays, RandomStream& rng) {
        for (int i = 0; i < rays; ++i) {
            SurfacePoint point;
            if (!randomHit(*shape_, size_, rng, point)) continue;
            ++hits;
            checkOnSurface(point);
            const V3f w = randomDirection(point.ng, rng);
            if (w.dot(point.ng) != 0) checkLeaving(point, w);
        }
    }

    int hits = 0, exits = 0;

  private:
    void checkOnSurface(const SurfacePoint& point) {
        // World distance from the surface: object distance over the length that the object normal takes on.
        Vec p, unused;
        toObject(worldFromObject_, Ray{point.p, V3d(0, 0, 1), infinityD}, p, unused);
        const V3d n = worldFromObject_.inverse().normal(toDouble(point.ng));
        const Real scale = worldFromObject_.normal(n / n.length()).length();
        EXPECT_LE(fabsl(analytic_.distance(p)) / scale, point.error);
        // A thousand times below what single precision would be off by.
        EXPECT_LT(point.error, 1e-10 * (size_ + maxAbs(point.p)));
    }

    void checkLeaving(const SurfacePoint& point, const V3f& w) {
        const Ray ray{offsetOrigin(point, w), toDouble(w), infinityD};
        const bool insideOut = analytic_.mirrorsInsideOut && worldFromObject_.swapsHandedness();
        const bool outwards = (w.dot(point.ng) > 0) != insideOut;
        PrimitiveHit hit;
        const bool met = shape_->intersect(0, ray, 0, infinityD, hit);
        EXPECT_EQ(met, shape_->occludes(0, ray, 0, infinityD));
        if (outwards || analytic_.isFlat)
            EXPECT_FALSE(met) << "a ray that leaves meets the shape again at " << hit.s << ", cosine "
                              << w.dot(point.ng);
        else
            checkExit(point, ray, w, met, hit);
    }

    /// The way through the inside, as it must be: from the start to the last crossing of the whole surface.
    void checkExit(const SurfacePoint& point, const Ray& ray, const V3f& w, bool met, const PrimitiveHit& hit) {
        Vec o, d;
        toObject(worldFromObject_, ray, o, d);
        const LineCrossings expected = analytic_.cross(o, d);
        const double cosine = std::abs(double(w.dot(point.ng)));
        Crossing exit{-1, 1};
        for (const Crossing& c : expected.all)
            if (c.margin > 0 || !analytic_.isConvexSolid) exit = c;
        // Single-precision normals may be on the wrong side of these: the way along the surface has no definite end.
        const bool isDefinite = cosine > 1e-6 && exit.s > 0;
        EXPECT_TRUE(met || !analytic_.isConvexSolid) << "a ray leaks out; cosine " << cosine;
        if (!isDefinite || fabsl(exit.margin) < 1e-6L) return;
        ASSERT_EQ(met, exit.margin > 0) << "exit at " << exit.s << ", margin " << exit.margin << ", cosine " << cosine;
        if (!met) return;
        ++exits;
        const SurfacePoint far = shape_->pointAt(ray, hit);
        const double exitCosine = std::abs(double(w.dot(far.ng)));
        EXPECT_NEAR(hit.s, double(exit.s), 4 * (point.error + far.error) / exitCosine) << "cosine " << cosine;
        PrimitiveHit second;
        EXPECT_FALSE(shape_->intersect(0, ray, hit.s, infinityD, second));
    }

    const AnalyticShape& analytic_;
    Transform worldFromObject_;
    double size_;
    ShapePtr shape_;
};

TEST(Reintersection, NoSelfHitsAndNoLeaksAtAnyScaleAndPlace) {
    RandomStream rng(20241);
    for (const AnalyticShape& analytic : boundedAnalyticShapes())
        for (const double scale : {1e-3, 1., 1e3})
            for (const double distance : {0., 1e-3, 1., 1e3, 1e5})
                for (const NamedTransform& placement : placements(scale, distance)) {
                    SCOPED_TRACE(analytic.name + ", " + placement.name + ", scale " + std::to_string(scale) +
                                 ", distance " + std::to_string(distance));
                    Reintersection test(analytic, placement, scale);
                    test.run(6000, rng);
                    EXPECT_GT(test.hits, 4000);
                    EXPECT_GT(test.exits, analytic.isConvexSolid ? 1200 : -1);
                    if (testing::Test::HasFailure()) return;
                }
}

TEST(Reintersection, PlaneIsNeverMetFromItself) {
    RandomStream rng(20242);
    const AnalyticShape plane = allAnalyticShapes().back();
    for (const double scale : {1e-3, 1., 1e3})
        for (const double distance : {0., 1e-3, 1., 1e3, 1e5})
            for (const NamedTransform& placement : placements(scale, distance)) {
                SCOPED_TRACE(placement.name);
                const ShapePtr shape = plane.make(placement.worldFromObject, false);
                for (int i = 0; i < 1500; ++i) {
                    const Ray ray{randomUnit(rng) * std::pow(10., rng.uniform(-3, 5)), randomUnit(rng), infinityD};
                    PrimitiveHit hit;
                    if (!shape->intersect(0, ray, 0, infinityD, hit)) continue;
                    const SurfacePoint point = shape->pointAt(ray, hit);
                    const V3f w = randomDirection(point.ng, rng);
                    if (w.dot(point.ng) == 0) continue;
                    const Ray next{offsetOrigin(point, w), toDouble(w), infinityD};
                    ASSERT_FALSE(shape->intersect(0, next, 0, infinityD, hit)) << "cosine " << w.dot(point.ng);
                }
            }
}

TEST(Reintersection, RaysThatReturnToThePlaneMeetIt) {
    const Plane plane(Transform(), false, V3d(0, 0, 1), 0);
    PrimitiveHit hit;
    // Above the tolerance of the start even the flattest way down counts.
    EXPECT_TRUE(plane.intersect(0, Ray{V3d(0, 0, 1e-6), V3d(1, 0, -1e-9), infinityD}, 0, infinityD, hit));
    EXPECT_NEAR(hit.s, 1e3, 1e-9);
}

} // namespace
} // namespace vitrine::test
