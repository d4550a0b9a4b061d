#include "core/random.h"
#include "core/transform.h"

#include <stdexcept>

namespace vitrine {
namespace {

/// Rotation about z, then unequal scales, a shear and a move: nothing special about it.
M44d generalMatrix() {
    M44d rotation, scale, shear, move;
    rotation.setAxisAngle(V3d(1, 2, 3).normalized(), 0.7);
    scale.setScale(V3d(2, 0.5, 3));
    shear[1][0] = 0.4;
    move.setTranslation(V3d(10, -20, 30));
    return rotation * scale * shear * move;
}

V3d randomVector(RandomStream& random) {
    return V3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
}

TEST(Transform, UsesRowVectors) {
    const Transform t(M44d(1, 2, 3, 0, 4, 5, 7, 0, 7, 8, 10, 0, 100, 200, 300, 1));
    EXPECT_EQ(t.point(V3d(0)), V3d(100, 200, 300));
    EXPECT_EQ(t.vector(V3d(1, 0, 0)), V3d(1, 2, 3));
    EXPECT_EQ(t.point(V3d(1, 1, 1)), V3d(112, 215, 320));
    const Ray ray = t.ray(Ray{V3d(0), V3d(0, 1, 0), 5});
    EXPECT_EQ(ray.o, V3d(100, 200, 300));
    EXPECT_EQ(ray.d, V3d(4, 5, 7));
    EXPECT_EQ(ray.tMax, 5);
}

TEST(Transform, InverseUndoes) {
    const Transform t(generalMatrix()), back = t.inverse();
    RandomStream random(1);
    for (int i = 0; i < 100; ++i) {
        const V3d p = randomVector(random);
        EXPECT_LT((back.point(t.point(p)) - p).length(), 1e-13);
        EXPECT_LT((t.point(back.point(p)) - p).length(), 1e-13);
        EXPECT_LT((back.vector(t.vector(p)) - p).length(), 1e-13);
    }
    EXPECT_EQ(back.inverse().matrix(), t.matrix());
}

TEST(Transform, NormalsStayPerpendicularToTangents) {
    const Transform t(generalMatrix());
    RandomStream random(2);
    for (int i = 0; i < 100; ++i) {
        const V3d tangent = randomVector(random), n = randomVector(random).cross(tangent);
        EXPECT_NEAR(t.normal(n).normalized().dot(t.vector(tangent).normalized()), 0, 1e-14);
    }
}

TEST(Transform, NormalsKeepTheirSideOfTheSurface) {
    M44d mirror = generalMatrix();
    mirror = M44d(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1) * mirror;
    for (const M44d& m : {generalMatrix(), mirror}) {
        const Transform t(m);
        RandomStream random(3);
        for (int i = 0; i < 100; ++i) {
            // A vector on the normal's side is carried to the side of the carried normal.
            const V3d n = randomVector(random), v = randomVector(random);
            EXPECT_EQ(n.dot(v) > 0, t.normal(n).dot(t.vector(v)) > 0);
        }
    }
}

TEST(Transform, ThenAppliesTheSecondAfterwards) {
    M44d scale, move;
    scale.setScale(2.);
    move.setTranslation(V3d(1, 0, 0));
    const Transform both = Transform(scale).then(Transform(move));
    EXPECT_EQ(both.point(V3d(1, 1, 1)), V3d(3, 2, 2));
    EXPECT_EQ(both.inverse().point(V3d(3, 2, 2)), V3d(1, 1, 1));
}

TEST(Transform, KnowsIdentityAndHandedness) {
    EXPECT_TRUE(Transform().isIdentity());
    EXPECT_FALSE(Transform(generalMatrix()).isIdentity());
    EXPECT_FALSE(Transform().swapsHandedness());
    EXPECT_FALSE(Transform(generalMatrix()).swapsHandedness());
    M44d mirror;
    mirror.setScale(V3d(1, -1, 1));
    EXPECT_TRUE(Transform(mirror).swapsHandedness());
    EXPECT_TRUE(Transform(generalMatrix() * mirror).swapsHandedness());
}

TEST(Transform, BoxHoldsAllThatWasInside) {
    const Transform t(generalMatrix());
    const Box3d box(V3d(-1, 0, 2), V3d(3, 5, 2)), image = t.box(box);
    RandomStream random(4);
    for (int i = 0; i < 1000; ++i)
        EXPECT_TRUE(image.intersects(t.point(V3d(random.uniform(-1, 3), random.uniform(0, 5), 2))));
    EXPECT_TRUE(t.box(Box3d()).isEmpty());
    EXPECT_EQ(Transform().box(box), box);
}

TEST(Transform, RefusesWhatHasNoInverse) {
    M44d flat, infinite, nan, tiny;
    flat.setScale(V3d(1, 0, 1));
    infinite[3][0] = infinityD;
    nan[1][1] = NAN;
    tiny.setScale(V3d(1, 1e-320, 1)); // its inverse overflows
    for (const M44d& m : {flat, infinite, nan, tiny, M44d(0.)})
        EXPECT_THROW(Transform{m}, std::domain_error);
    M44d large, small;
    large.setScale(1e100);
    small.setScale(1e-100);
    EXPECT_NO_THROW(Transform{large});
    EXPECT_NO_THROW(Transform{small});
}

} // namespace
} // namespace vitrine
