// Given normals of any length: only directions and ratios count.
#include "shapes/mesh.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

/// The shading normal in the middle of a triangle whose corners have the normals (0,0,1), (1,0,1), (0,1,1) times `length`.
V3f middleNormal(float length) {
    MeshInput mesh;
    mesh.p = {V3f(0, 0, 0), V3f(1, 0, 0), V3f(0, 1, 0)};
    mesh.n = {V3f(0, 0, 1) * length, V3f(1, 0, 1) * length, V3f(0, 1, 1) * length};
    mesh.triangles = {0, 1, 2};
    const auto shapes = makeMeshShapes(std::move(mesh), Transform(), false);
    const Ray ray{V3d(1. / 3, 1. / 3, 1), V3d(0, 0, -1), infinityD};
    PrimitiveHit hit;
    EXPECT_TRUE(shapes.at(0)->intersect(0, ray, 0, infinityD, hit));
    return shapes.at(0)->pointAt(ray, hit).ns;
}

TEST(MeshNormals, OfAnyLength) {
    const V3f expected = V3f(1 / 3.f, 1 / 3.f, 1).normalized();
    for (const float length : {1.f, 1e-30f, 1e-20f, 1e10f, 1e20f, 3e38f}) {
        const V3f n = middleNormal(length);
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(n[k], expected[k], 1e-6) << length;
    }
}

} // namespace
} // namespace vitrine
