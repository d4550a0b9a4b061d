#include "accel/moving_shape.h"
#include "core/random.h"
#include "shapes/quad_mesh.h"
#include "shapes/sphere.h"
#include "support/analytic_shapes.h"
#include "support/meshes.h"

namespace vitrine {
namespace {

Transform pose(const V3d& axis, double degrees, const V3d& scale, const V3d& translation) {
    M44d turn;
    turn.setAxisAngle(axis.normalized(), radians(degrees));
    return Transform(M44d().setScale(scale) * turn * M44d().setTranslation(translation));
}

Motion stretchingMotion() {
    return Motion(pose(V3d(1, 0, 0), 10, V3d(1, 1.5, 0.7), V3d(0, 0, 0)), 0,
                  pose(V3d(0, 1, 1), 80, V3d(0.8, 0.9, 1.2), V3d(1, -2, 0.5)), 1);
}

/// The shape as if it stood where it is at the ray's time.
TEST(MovingShape, IsWhereItStandsAtTheRaysTime) {
    const Motion motion = stretchingMotion();
    const auto moving = std::make_shared<MovingShape>(std::make_shared<Sphere>(motion.start(), false, 1, -1, 1, 360),
                                                      motion.sinceStart(), Shutter());
    RandomStream random(1);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        Ray ray{test::randomUnit(random) * 5, V3d(0), infinityD, random.uniformDouble()};
        const Sphere still(motion.at(ray.time), false, 1, -1, 1, 360);
        ray.d = motion.at(ray.time).point(test::randomUnit(random) * random.uniform(0, 1.2)) - ray.o;
        PrimitiveHit a, b;
        const bool met = moving->intersect(0, ray, 0, infinityD, a);
        ASSERT_EQ(met, still.intersect(0, ray, 0, infinityD, b));
        if (!met) continue;
        ++hits;
        // Near the rim rounding moves a crossing by its square root.
        EXPECT_NEAR(a.s, b.s, 1e-7);
        EXPECT_TRUE(moving->bounds(0).intersects(ray.at(a.s)));
        const SurfacePoint p = moving->pointAt(ray, a), q = still.pointAt(ray, b);
        EXPECT_TRUE(p.p.equalWithAbsError(q.p, 1e-6));
        EXPECT_TRUE(p.ng.equalWithAbsError(q.ng, 1e-5f));
        EXPECT_TRUE(p.ns.equalWithAbsError(q.ns, 1e-5f));
        EXPECT_TRUE(p.dpdu.equalWithAbsError(q.dpdu, 2e-5f));
        // A ray that leaves does not meet the surface that it leaves.
        const V3f out = p.ng;
        EXPECT_FALSE(
            moving->intersect(0, Ray{offsetOrigin(p, out), toDouble(out), infinityD, ray.time}, 0, infinityD, a));
    }
    EXPECT_GT(hits, 1000);
}

/// Density per solid angle and per area against the same shape made where it stands.
TEST(MovingShape, SamplesWithTheDensityThatItTells) {
    const Motion motion = stretchingMotion();
    const ShapePtr quad = test::onlyShape(test::patch(V3d(-1, 0, 0), V3d(1, 0, 0), V3d(-1, 1.5, 0), V3d(1, 1.5, 0)));
    const MovingShape moving(quad, motion, Shutter());
    RandomStream random(2);
    for (int i = 0; i < 200; ++i) {
        const double time = random.uniformDouble();
        const V3d from = test::randomUnit(random) * 6;
        const V2f u(random.uniform(), random.uniform());
        const Transform at = motion.at(time);
        const V3d across = at.vector(V3d(2, 0, 0)).cross(at.vector(V3d(0, 1.5, 0)));
        const auto byArea = moving.sampleAt(time, u);
        ASSERT_TRUE(byArea);
        EXPECT_NEAR(byArea->pdf * across.length(), 1, 1e-5);
        EXPECT_NEAR(toDouble(byArea->point.ng).dot(across.normalized()), 1, 1e-5);

        const auto seen = moving.sampleAt(time, from, u);
        ASSERT_TRUE(seen);
        const V3d way = seen->point.p - from;
        Ray ray{from, way, infinityD, time};
        PrimitiveHit hit;
        ASSERT_TRUE(moving.intersect(0, ray, 0, infinityD, hit));
        EXPECT_NEAR(hit.s, 1, 1e-6);
        EXPECT_NEAR(moving.pdfAt(time, from, hit, moving.pointAt(ray, hit)) / seen->pdf, 1, 1e-3);
    }
}

/// The integral of one over the density is the solid angle of what is sampled, however the pose stretches.
TEST(MovingShape, SolidAngleByItsSamples) {
    const Motion motion = stretchingMotion();
    const ShapePtr quad = test::onlyShape(test::patch(V3d(-1, 0, 0), V3d(1, 0, 0), V3d(-1, 1.5, 0), V3d(1, 1.5, 0)));
    const MovingShape moving(quad, motion, Shutter());
    const V3d from(0.3, 0.4, 4);
    for (const double time : {0., 0.4, 1.}) {
        const Transform at = motion.at(time);
        const V3d across = at.vector(V3d(2, 0, 0)).cross(at.vector(V3d(0, 1.5, 0)));
        double bySamples = 0, byArea = 0;
        const int n = 200;
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < n; ++k) {
                const V2f u((float(i) + 0.5f) / n, (float(k) + 0.5f) / n);
                bySamples += 1 / double(moving.sampleAt(time, from, u)->pdf) / (n * n);
                const V3d way = at.point(V3d(-1 + 2 * double(u.x), 1.5 * double(u.y), 0)) - from;
                byArea += std::abs(way.dot(across)) / std::pow(way.length(), 3) / (n * n);
            }
        EXPECT_NEAR(bySamples / byArea, 1, 1e-3) << time;
    }
}

} // namespace
} // namespace vitrine
