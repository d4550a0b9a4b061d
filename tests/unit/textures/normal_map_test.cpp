#include "core/random.h"
#include "made_image.h"
#include "support/meshes.h"
#include "support/texture_points.h"
#include "textures/bump_map.h"
#include "textures/normal_map.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

double height(double u, double v) {
    return 0.02 * (std::sin(2 * piD * (2 * u + v)) + std::cos(2 * piD * (u - 2 * v)));
}

class Heights final : public FloatTexture {
  public:
    float evaluate(const TexturePoint& at) const override { return float(height(at.uv.x, at.uv.y)); }
};

/// A square of side 2; (u, v) grow with x and y.
ShapePtr square(bool reversed = false) {
    return onlyShape(patch(V3d(-1, -1, 0), V3d(1, -1, 0), V3d(-1, 1, 0), V3d(1, 1, 0)), Transform(), reversed);
}

SurfacePoint pointOn(const Shape& shape, double x, double y) {
    const Ray ray{V3d(x, y, 1), V3d(0, 0, -1)};
    PrimitiveHit hit;
    if (!shape.intersect(0, ray, 0, infinityD, hit)) throw std::logic_error("the ray misses");
    return shape.pointAt(ray, hit);
}

/// The image of normals of the heights over the square: the upper row is at v = 1.
std::shared_ptr<const CachedImage> imageOfNormals(ImageTextureCache& cache, int size) {
    return makeImage(cache, V2i(size), 3, [&](int x, int y, int c) {
        constexpr double h = 1e-5;
        const double u = (x + 0.5) / size, v = 1 - (y + 0.5) / size;
        // dp/du and dp/dv are 2 long.
        const V3d n =
            V3d(-(height(u + h, v) - height(u - h, v)) / (4 * h), -(height(u, v + h) - height(u, v - h)) / (4 * h), 1)
                .normalized();
        return float(0.5 + 0.5 * n[c]);
    });
}

TEST(NormalMap, OfHeightsIsTheirBumpMap) {
    const auto cache = makeCache();
    const NormalMap normals(imageOfNormals(*cache, 256));
    const BumpMap bumps(std::make_shared<Heights>());
    const ShapePtr shape = square();
    RandomStream random(3);
    float most = 0;
    for (int i = 0; i < 1000; ++i) {
        const SurfacePoint point = pointOn(*shape, random.uniform(-1, 1), random.uniform(-1, 1));
        const V3f a = normals.shade(point, textureAt(point)).n, b = bumps.shade(point, textureAt(point)).n;
        // Bilinear between texels of 1/256: an eighth of its square times the third derivative (80) over the length 2 of dp/du.
        EXPECT_LT((a - b).length(), 2e-4f) << point.uv;
        most = std::max(most, (a - point.ns).length());
    }
    EXPECT_GT(most, 0.1f) << "there is nothing to see";
}

TEST(NormalMap, LiesInTheFrameOfTangentAndShadingNormal) {
    const auto cache = makeCache();
    const auto image = makeImage(*cache, V2i(4), 3, [](int, int, int c) {
        constexpr float colour[] = {0.5f + 0.3f, 0.5f, 0.5f + 0.4f}; // (0.6, 0, 0.8)
        return colour[c];
    });
    const NormalMap map(image);
    SurfacePoint point = pointOn(*square(), 0.2, 0.3);
    EXPECT_LT((map.shade(point, textureAt(point)).n - V3f(0.6f, 0, 0.8f)).length(), 1e-6f);
    point.ns = V3f(0, 0.6f, 0.8f);
    EXPECT_LT((map.shade(point, textureAt(point)).n - (V3f(0.6f, 0, 0) + point.ns * 0.8f)).length(), 1e-6f);
    // Seen from the other side of a reversed surface: x stays along dpdu.
    const SurfacePoint reversed = pointOn(*square(true), 0.2, 0.3);
    ASSERT_EQ(reversed.ng, V3f(0, 0, -1));
    EXPECT_LT((map.shade(reversed, textureAt(reversed)).n - V3f(0.6f, 0, -0.8f)).length(), 1e-6f);
}

TEST(NormalMap, NormalsBelowTheSurfaceComeBackToItsHorizon) {
    const auto cache = makeCache();
    const auto image = makeImage(*cache, V2i(1), 3, [](int, int, int c) { return c == 2 ? 0.1f : 0.8f; });
    const SurfacePoint point = pointOn(*square(), 0.2, 0.3);
    const V3f n = NormalMap(image).shade(point, textureAt(point)).n;
    EXPECT_GT(n.dot(point.ng), 0.f);
    EXPECT_LT(n.dot(point.ng), 0.01f);
    EXPECT_NEAR(n.x, n.y, 1e-6f);
    EXPECT_GT(n.x, 0.7f);
}

TEST(NormalMap, GreyInTheMiddleSaysNothing) {
    const auto cache = makeCache();
    const auto image = makeImage(*cache, V2i(1), 3, [](int, int, int) { return 0.5f; });
    const SurfacePoint point = pointOn(*square(), 0.2, 0.3);
    EXPECT_EQ(NormalMap(image).shade(point, textureAt(point)).n, point.ns);
}

} // namespace
} // namespace vitrine::test
