#include "core/motion.h"
#include "core/random.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

Transform translated(const V3d& by) {
    return Transform(M44d().setTranslation(by));
}
Transform scaled(const V3d& by) {
    return Transform(M44d().setScale(by));
}
Transform turned(const V3d& axis, double degrees) {
    M44d m;
    m.setAxisAngle(axis.normalized(), radians(degrees));
    return Transform(m);
}

void expectNear(const V3d& a, const V3d& b, double tolerance) {
    EXPECT_TRUE(a.equalWithAbsError(b, tolerance)) << a << " is not " << b;
}

Transform anyTransform(RandomStream& random) {
    const auto any = [&](double from, double to) {
        return V3d(random.uniform(from, to), random.uniform(from, to), random.uniform(from, to));
    };
    return scaled(any(0.3, 2)).then(turned(any(-1, 1), random.uniform(-90, 90))).then(translated(any(-5, 5)));
}

double largestDifference(const M44d& a, const M44d& b) {
    double largest = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            largest = std::max(largest, std::abs(a[i][j] - b[i][j]));
    return largest;
}

TEST(Motion, TranslatesAtConstantSpeed) {
    const Motion motion(translated(V3d(1, 2, 3)), 1, translated(V3d(5, -2, 3)), 3);
    EXPECT_TRUE(motion.moves());
    expectNear(motion.at(1.5).point(V3d(0, 0, 1)), V3d(2, 1, 4), 1e-15);
    EXPECT_EQ(motion.at(-7).matrix(), motion.at(1).matrix()) << "before the start";
    EXPECT_EQ(motion.at(9).matrix(), translated(V3d(5, -2, 3)).matrix()) << "after the end";
}

TEST(Motion, TurnsAtConstantSpeedOnTheShorterWay) {
    const V3d axis(1, 2, 2);
    const Motion motion(Transform(), 0, turned(axis, 120), 1);
    for (const double u : {0.1, 0.25, 0.5, 0.9})
        EXPECT_LT(largestDifference(motion.at(u).matrix(), turned(axis, 120 * u).matrix()), 1e-14) << u;
    const Motion back(turned(axis, 10), 0, turned(axis, 300), 1);
    EXPECT_LT(largestDifference(back.at(0.5).matrix(), turned(axis, -25).matrix()), 1e-14);
}

TEST(Motion, StretchesLinearlyAndApartFromTurning) {
    const Motion motion(scaled(V3d(1, 2, 3)), 0, scaled(V3d(3, 2, 1)).then(turned(V3d(0, 0, 1), 60)), 1);
    const Transform half = scaled(V3d(2, 2, 2)).then(turned(V3d(0, 0, 1), 30));
    EXPECT_LT(largestDifference(motion.at(0.5).matrix(), half.matrix()), 1e-14);
}

TEST(Motion, MirrorsWhereBothEndsDo) {
    const Transform mirror = scaled(V3d(-1, 1, 1));
    const Motion motion(mirror, 0, mirror.then(turned(V3d(0, 1, 0), 90)), 1);
    EXPECT_LT(largestDifference(motion.at(0.5).matrix(), mirror.then(turned(V3d(0, 1, 0), 45)).matrix()), 1e-14);
    EXPECT_THROW(Motion(mirror, 0, Transform(), 1), std::domain_error);
}

TEST(Motion, KnowsItsInverse) {
    RandomStream random(1);
    for (int i = 0; i < 200; ++i) {
        const Motion motion(anyTransform(random), 0, anyTransform(random), 1);
        const Motion since = motion.sinceStart();
        for (const double time : {0., 0.3, 0.77, 1.}) {
            for (const Motion* each : {&motion, &since}) {
                const Transform pose = each->at(time);
                EXPECT_LT(largestDifference(pose.matrix() * pose.inverse().matrix(), M44d()), 1e-13);
            }
            const Transform both = motion.start().then(since.at(time));
            EXPECT_LT(largestDifference(both.matrix(), motion.at(time).matrix()), 1e-13);
        }
        // Near the ends it comes near the poses given.
        EXPECT_LT(largestDifference(motion.at(1e-12).matrix(), motion.at(0).matrix()), 1e-10);
        EXPECT_LT(largestDifference(motion.at(1 - 1e-12).matrix(), motion.at(1).matrix()), 1e-10);
    }
}

TEST(Motion, SweptBoxHoldsAllPointsAndIsNotMuchLarger) {
    RandomStream random(2);
    const Box3d box(V3d(-1, -0.5, 0.2), V3d(0.3, 2, 1));
    for (int i = 0; i < 300; ++i) {
        Motion motion(anyTransform(random), 0.2, anyTransform(random), 0.9);
        if (i % 2) motion = motion.sinceStart();
        const Shutter times{random.uniform(-0.2, 0.6), random.uniform(0.6, 1.3)};
        const Box3d swept = motion.sweep(box, times);
        Box3d found;
        for (int k = 0; k <= 400; ++k) {
            const Transform pose = motion.at(times.at(k / 400.));
            for (int corner = 0; corner < 8; ++corner)
                found.extendBy(pose.point(V3d(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                                              corner & 4 ? box.max.z : box.min.z)));
        }
        for (int k = 0; k < 3; ++k) {
            EXPECT_LE(swept.min[k], found.min[k]);
            EXPECT_GE(swept.max[k], found.max[k]);
            EXPECT_LE(swept.size()[k], 1.05 * found.size()[k] + 0.05 * maxAbs(found.size()));
        }
    }
    const Motion straight(Transform(), 0, translated(V3d(3, 0, -1)), 1);
    const Box3d swept = straight.sweep(box, {0, 0.5});
    expectNear(swept.min, V3d(-1, -0.5, -0.3), 1e-11);
    expectNear(swept.max, V3d(1.8, 2, 1), 1e-11);
}

} // namespace
} // namespace vitrine
