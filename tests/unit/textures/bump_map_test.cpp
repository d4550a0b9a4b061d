// Bump maps against the normals of surfaces that are really displaced.
#include "core/random.h"
#include "core/transform.h"
#include "shapes/cylinder.h"
#include "shapes/sphere.h"
#include "support/meshes.h"
#include "support/texture_points.h"
#include "textures/bump_map.h"
#include "textures/footprint.h"

#include <gtest/gtest.h>

#include <functional>

namespace vitrine {
namespace {

class Heights final : public FloatTexture {
  public:
    explicit Heights(std::function<double(const TexturePoint&)> height) : height_(std::move(height)) {}
    float evaluate(const TexturePoint& at) const override { return float(height_(at)); }

  private:
    std::function<double(const TexturePoint&)> height_;
};

double ripples(double u, double v) {
    return 0.03 * std::sin(9 * u + 1) * std::cos(7 * v);
}

const auto rippled = std::make_shared<Heights>([](const TexturePoint& at) { return ripples(at.uv.x, at.uv.y); });

/// The unit normal of the surface p(u, v), outwards as n, by central differences.
V3f normalOf(const std::function<V3d(double, double)>& p, const V2f& uv, const V3f& n) {
    constexpr double h = 1e-5;
    const double u = uv.x, v = uv.y;
    const V3d m = (p(u + h, v) - p(u - h, v)).cross(p(u, v + h) - p(u, v - h)).normalized();
    return toFloat(m.dot(toDouble(n)) < 0 ? -m : m);
}

/// Differences over 0.0005 of heights in single precision: 2^-24 of 0.03 over 0.0005, over the length of dp/du, which is
/// down to 1 where ripples are looked at.
constexpr float tolerance = 3e-5f;

void expectDisplaced(const Shape& shape, const std::function<V3d(double, double)>& displaced) {
    RandomStream random(1);
    const BumpMap bump(rippled);
    float most = 0;
    for (int i = 0; i < 500; ++i) {
        const auto sample = shape.sample(V2f(random.uniform(), random.uniform()));
        ASSERT_TRUE(sample);
        const Ray ray{sample->point.p + toDouble(sample->point.ng) * 0.1, -toDouble(sample->point.ng)};
        PrimitiveHit hit;
        ASSERT_TRUE(shape.intersect(0, ray, 0, 1, hit));
        const SurfacePoint point = shape.pointAt(ray, hit);
        // Next to the poles a step of u is no step, and at the seam it is another turn.
        if (point.uv.y < 0.05f || point.uv.y > 0.95f || point.uv.x > 0.99f) continue;
        const V3f expected = normalOf(displaced, point.uv, point.ng), found = bump.shade(point, textureAt(point)).n;
        EXPECT_LT((found - expected).length(), tolerance) << point.uv;
        most = std::max(most, (found - point.ns).length());
    }
    EXPECT_GT(most, 0.05f) << "there is nothing to see";
}

TEST(BumpMap, OfASphereIsTheDisplacedSphere) {
    for (const bool inside : {false, true}) {
        const Sphere sphere(Transform(), inside, 1, -1, 1, 360);
        expectDisplaced(sphere, [&](double u, double v) {
            const double phi = 2 * piD * u, theta = piD * v;
            // v runs from the lower pole or from the upper one, as the shape has it.
            const V3d n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), -std::cos(theta));
            return n * (1 + (inside ? -1 : 1) * ripples(u, v));
        });
    }
}

TEST(BumpMap, OfACylinderIsTheDisplacedCylinder) {
    const Cylinder cylinder(Transform(), false, 0.5, -1, 2, 360);
    expectDisplaced(cylinder, [](double u, double v) {
        const V3d n(std::cos(2 * piD * u), std::sin(2 * piD * u), 0);
        return n * (0.5 + ripples(u, v)) + V3d(0, 0, -1 + 3 * v);
    });
}

/// A patch of half side 1 facing up.
SurfacePoint onPatch(const V2d& p, float half = 1) {
    const double h = half;
    const ShapePtr shape = test::onlyShape(test::patch(V3d(-h, -h, 0), V3d(h, -h, 0), V3d(-h, h, 0), V3d(h, h, 0)));
    const Ray ray{V3d(p.x * h, p.y * h, h), V3d(0, 0, -1)};
    PrimitiveHit hit;
    if (!shape->intersect(0, ray, 0, infinityD, hit)) throw std::logic_error("the ray misses");
    return shape->pointAt(ray, hit);
}

TEST(BumpMap, OfASolidTextureTakesStepsInSpace) {
    const BumpMap bump(std::make_shared<Heights>([](const TexturePoint& at) { return 0.5 * at.p.x - 0.25 * at.p.y; }));
    const SurfacePoint point = onPatch(V2d(0.3, -0.2));
    const V3f expected = V3f(-0.5f, 0.25f, 1).normalized();
    EXPECT_LT((bump.shade(point, textureAt(point)).n - expected).length(), 1e-4f);
}

TEST(BumpMap, StepsAreAsLongAsWhatAPixelSees) {
    // Between steps of 0.001 and of 0.1 this tells the difference: a saw that falls back each 0.01 of u.
    const BumpMap bump(std::make_shared<Heights>([](const TexturePoint& at) {
        const double u = at.uv.x / 0.01;
        return 0.001 * (u - std::floor(u));
    }));
    const SurfacePoint point = onPatch(V2d(0.004 - 0.5, 0));
    TexturePoint at = textureAt(point);
    EXPECT_GT(bump.shade(point, at).n.dot(V3f(-1, 0, 0)), 0.03f);
    spreadOver(point, V3f(0, 0, 1), 0.4f, at); // steps of 0.1, ten teeth
    EXPECT_LT(bump.shade(point, at).n.dot(V3f(-1, 0, 0)), 0.005f);
}

TEST(BumpMap, LevelHeightsChangeNoBit) {
    const BumpMap bump(std::make_shared<Heights>([](const TexturePoint&) { return 0.7; }));
    SurfacePoint point = onPatch(V2d(0.3, -0.2));
    point.ns = V3f(0.1f, 0.2f, 1).normalized();
    EXPECT_EQ(bump.shade(point, textureAt(point)).n, point.ns);
    EXPECT_EQ(bump.shade(point, textureAt(point)).tangent, point.dpdu);
}

TEST(BumpMap, NormalsStayOutside) {
    RandomStream random(2);
    for (int i = 0; i < 1000; ++i) {
        SurfacePoint point = onPatch(V2d(random.uniform(-1, 1), random.uniform(-1, 1)));
        const double a = random.uniform(-100, 100), b = random.uniform(-100, 100);
        const BumpMap bump(
            std::make_shared<Heights>([&](const TexturePoint& at) { return a * at.uv.x + b * at.uv.y; }));
        point.ns = V3f(float(random.uniform(-3, 3)), float(random.uniform(-3, 3)), 1).normalized();
        const V3f n = bump.shade(point, textureAt(point)).n;
        EXPECT_GT(n.dot(point.ng), 0.f);
        EXPECT_NEAR(n.length(), 1, 1e-6);
    }
}

TEST(BumpMap, OfHugeAndFarSurfaces) {
    const BumpMap bump(std::make_shared<Heights>([](const TexturePoint& at) { return 1e12 * at.uv.x; }));
    const SurfacePoint huge = onPatch(V2d(0.1, 0.2), 1e14f);
    EXPECT_LT((bump.shade(huge, textureAt(huge)).n - V3f(-0.005f, 0, 1).normalized()).length(), 1e-4f);
    // Parameters so large that 0.0005 is lost in them: the slope is still that of the texture.
    SurfacePoint far = onPatch(V2d(0.1, 0.2));
    far.uv = V2f(30000.5f, -70000);
    const BumpMap slope(std::make_shared<Heights>([](const TexturePoint& at) { return at.uv.x - 30000; }));
    EXPECT_LT((slope.shade(far, textureAt(far)).n - V3f(-0.5f, 0, 1).normalized()).length(), 1e-4f);
}

TEST(BumpMap, WhereNothingCanBeSaidTheNormalStays) {
    SurfacePoint point = onPatch(V2d(0.1, 0.2));
    const BumpMap bad(std::make_shared<Heights>(
        [](const TexturePoint& at) { return at.uv.x > 0.55f ? std::numeric_limits<double>::quiet_NaN() : 0.; }));
    point.uv = V2f(0.5498f, 0.6f);
    EXPECT_EQ(bad.shade(point, textureAt(point)).n, point.ns);
    point.dpdu = point.dpdv = V3f(0, 0, 0);
    EXPECT_EQ(BumpMap(rippled).shade(point, textureAt(point)).n, point.ns);
}

} // namespace
} // namespace vitrine
