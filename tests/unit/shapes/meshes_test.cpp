// Triangle meshes, planar quads and bent patches: what a hit reports, and how they are sampled.
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace vitrine::test {

namespace {

PrimitiveHit hitOf(const Shape& shape, const Ray& ray) {
    PrimitiveHit best;
    for (unsigned prim = 0; prim < shape.primitiveCount(); ++prim)
        shape.intersect(prim, ray, 0, best.s, best);
    EXPECT_TRUE(std::isfinite(best.s));
    return best;
}

SurfacePoint pointOf(const Shape& shape, const Ray& ray) {
    return shape.pointAt(ray, hitOf(shape, ray));
}

void expectNear(const V3d& a, const V3d& b, double tolerance) {
    EXPECT_LT(maxAbs(a - b), tolerance) << a << " against " << b;
}

void expectNear(const V3f& a, const V3d& b, double tolerance = 1e-6) {
    expectNear(toDouble(a), b, tolerance);
}

MeshInput rightTriangle() {
    MeshInput mesh;
    mesh.p = {V3f(0, 0, 0), V3f(2, 0, 0), V3f(0, 4, 0)};
    mesh.triangles = {0, 1, 2};
    return mesh;
}

M44d mirror() {
    M44d m;
    m[0][0] = -1;
    return m;
}

const Ray downAt(double x, double y) {
    return Ray{V3d(x, y, 5), V3d(0, 0, -1)};
}

/// Two corners of a patch high, two low.
MeshInput saddle() {
    return patch(V3d(-1, -1, 0.5), V3d(1, -1, -0.5), V3d(-1, 1, -0.5), V3d(1, 1, 0.5));
}

} // namespace

TEST(TriangleMesh, HitReportsDistanceWeightsAndGeometry) {
    const ShapePtr shape = onlyShape(rightTriangle());
    ASSERT_EQ(shape->kind(), GeometryKind::Triangles);
    const PrimitiveHit hit = hitOf(*shape, downAt(0.5, 1));
    EXPECT_DOUBLE_EQ(hit.s, 5);
    EXPECT_DOUBLE_EQ(hit.u, 0.25);
    EXPECT_DOUBLE_EQ(hit.v, 0.25);
    const SurfacePoint point = shape->pointAt(downAt(0.5, 1), hit);
    expectNear(point.p, V3d(0.5, 1, 0), 1e-15);
    expectNear(point.ng, V3d(0, 0, 1));
    // pbrt's own texture coordinates: (0,0), (1,0), (1,1).
    EXPECT_EQ(point.uv, V2f(0.5f, 0.25f));
    expectNear(point.dpdu, V3d(2, 0, 0));
    expectNear(point.dpdv, V3d(-2, 4, 0));
    EXPECT_DOUBLE_EQ(shape->area(), 4);
    EXPECT_FALSE(shape->isClosed());
}

TEST(TriangleMesh, OrientationAndMirroringTurnTheNormal) {
    const Transform mirrored(mirror());
    EXPECT_GT(pointOf(*onlyShape(rightTriangle()), downAt(0.5, 1)).ng.z, 0);
    EXPECT_LT(pointOf(*onlyShape(rightTriangle(), {}, true), downAt(0.5, 1)).ng.z, 0);
    // A mirror along x leaves what looks up looking up.
    EXPECT_GT(pointOf(*onlyShape(rightTriangle(), mirrored), downAt(-0.5, 1)).ng.z, 0);
    EXPECT_LT(pointOf(*onlyShape(rightTriangle(), mirrored, true), downAt(-0.5, 1)).ng.z, 0);
}

TEST(TriangleMesh, GivenNormalsDecideTheSide) {
    MeshInput mesh = rightTriangle();
    mesh.n = {V3f(0, 0, -1), V3f(0.6f, 0, -0.8f), V3f(0, 0.6f, -0.8f)};
    const SurfacePoint point = pointOf(*onlyShape(mesh), downAt(0.5, 1));
    EXPECT_FLOAT_EQ(point.ng.z, -1);
    const V3d mixed(0.15, 0.15, -0.9);
    expectNear(point.ns, mixed.normalized());
    EXPECT_GT(point.ns.dot(point.ng), 0);
    EXPECT_NEAR(point.dndu.dot(point.ns), 0, 1e-6);
    // ReverseOrientation turns both.
    const SurfacePoint reversed = pointOf(*onlyShape(mesh, {}, true), downAt(0.5, 1));
    EXPECT_FLOAT_EQ(reversed.ng.z, 1);
    expectNear(reversed.ns, -mixed.normalized());
}

TEST(TriangleMesh, NormalDerivativesAreThoseOfTheNormal) {
    MeshInput mesh = rightTriangle();
    mesh.n = {V3f(0, 0, 1), V3f(0.6f, 0, 0.8f), V3f(-0.3f, 0.6f, 0.8f)};
    mesh.uv = {V2f(0.1f, 0.2f), V2f(0.9f, 0.3f), V2f(0.4f, 1.2f)};
    const ShapePtr shape = onlyShape(mesh);
    const auto at = [&](double x, double y) { return pointOf(*shape, downAt(x, y)); };
    const SurfacePoint point = at(0.5, 1);
    constexpr double h = 1e-2;
    for (const V3d& step : {V3d(h, 0, 0), V3d(0, h, 0)}) {
        const SurfacePoint plus = at(0.5 + step.x, 1 + step.y), minus = at(0.5 - step.x, 1 - step.y);
        const V2f duv = (plus.uv - minus.uv) * float(0.5 / h);
        expectNear(point.dpdu * duv.x + point.dpdv * duv.y, step / h, 1e-5);
        expectNear(point.dndu * duv.x + point.dndv * duv.y, toDouble(plus.ns - minus.ns) * (0.5 / h), 1e-3);
    }
}

TEST(TriangleMesh, TangentsTurnDpdu) {
    MeshInput mesh = rightTriangle();
    mesh.s.assign(3, V3f(1, 1, 0));
    const SurfacePoint point = pointOf(*onlyShape(mesh), downAt(0.5, 1));
    expectNear(point.dpdu, V3d(std::sqrt(2.), std::sqrt(2.), 0));
}

TEST(TriangleMesh, DegenerateTextureCoordinatesStillGiveAFrame) {
    MeshInput mesh = rightTriangle();
    mesh.uv.assign(3, V2f(0.5f, 0.5f));
    const SurfacePoint point = pointOf(*onlyShape(mesh), downAt(0.5, 1));
    EXPECT_NEAR(point.dpdu.length(), 1, 1e-6);
    EXPECT_NEAR(point.dpdu.dot(point.ng), 0, 1e-6);
    EXPECT_NEAR(point.dpdu.dot(point.dpdv), 0, 1e-6);
}

TEST(TriangleMesh, FacesWithoutAreaAreLeftOut) {
    MeshInput mesh = rightTriangle();
    mesh.triangles = {0, 0, 1, 0, 1, 2, 1, 1, 1};
    EXPECT_EQ(onlyShape(mesh)->primitiveCount(), 1u);
    mesh.triangles = {0, 0, 1};
    EXPECT_TRUE(makeMeshShapes(mesh, {}, false).empty());
}

TEST(Meshes, WrongInputIsRefused) {
    const auto refused = [](auto change) {
        MeshInput mesh = rightTriangle();
        change(mesh);
        EXPECT_THROW(makeMeshShapes(mesh, {}, false), std::invalid_argument);
    };
    refused([](MeshInput& mesh) { mesh.triangles.push_back(0); });
    refused([](MeshInput& mesh) { mesh.triangles[1] = 3; });
    refused([](MeshInput& mesh) { mesh.triangles[1] = std::uint32_t(-1); });
    refused([](MeshInput& mesh) { mesh.quads = {0, 1, 2}; });
    refused([](MeshInput& mesh) { mesh.n.resize(2); });
    refused([](MeshInput& mesh) { mesh.uv.resize(4, V2f(0, 0)); });
    refused([](MeshInput& mesh) { mesh.p[1].y = infinity; });
    refused([](MeshInput& mesh) { mesh.n.assign(3, V3f(0, std::nanf(""), 1)); });
}

TEST(Meshes, ClosedOnlyIfEveryEdgeHasTwoFacesAndNormalsPointOut) {
    for (const V3d& center : {V3d(0, 0, 0), V3d(1e4, -2e4, 3e4)}) {
        EXPECT_TRUE(onlyShape(cubeMesh(center))->isClosed());
        EXPECT_TRUE(onlyShape(asTriangles(cubeMesh(center)))->isClosed());
        EXPECT_TRUE(onlyShape(icosphere(2, center))->isClosed());
        EXPECT_FALSE(onlyShape(icosphere(2, center), {}, true)->isClosed());
        EXPECT_TRUE(onlyShape(icosphere(2, center), Transform(mirror()))->isClosed());
    }
    MeshInput open = asTriangles(cubeMesh());
    open.triangles.resize(open.triangles.size() - 3);
    EXPECT_FALSE(onlyShape(open)->isClosed());
    MeshInput turned = asTriangles(cubeMesh());
    std::swap(turned.triangles[0], turned.triangles[1]);
    EXPECT_FALSE(onlyShape(turned)->isClosed());
    // Faces with vertices of their own, as seams of texture coordinates make them.
    MeshInput split, cube = asTriangles(cubeMesh());
    for (const std::uint32_t index : cube.triangles) {
        split.triangles.push_back(std::uint32_t(split.p.size()));
        split.p.push_back(cube.p[index]);
    }
    EXPECT_TRUE(onlyShape(split)->isClosed());
}

TEST(QuadMesh, PatchParametersOfAnyFlatQuad) {
    // A parallelogram, a trapezoid, a kite, a quad that is a triangle.
    const MeshInput quads[] = {patch(V3d(0, 0, 0), V3d(2, 0, 0), V3d(1, 1, 0), V3d(3, 1, 0)),
                               patch(V3d(0, 0, 0), V3d(4, 0, 0), V3d(1, 2, 0), V3d(2, 2, 0)),
                               patch(V3d(0, 0, 0), V3d(2, 0.5, 0), V3d(0.5, 2, 0), V3d(2.5, 2.25, 0)),
                               patch(V3d(0, 0, 0), V3d(2, 0, 0), V3d(0, 2, 0), V3d(0, 2, 0))};
    RandomStream random(1);
    for (const MeshInput& mesh : quads) {
        const ShapePtr shape = onlyShape(mesh);
        ASSERT_EQ(shape->kind(), GeometryKind::Quads);
        const V3d p00 = toDouble(mesh.p[0]), p10 = toDouble(mesh.p[1]), p01 = toDouble(mesh.p[2]),
                  p11 = toDouble(mesh.p[3]);
        for (int i = 0; i < 200; ++i) {
            const double u = random.uniform(0.01, 0.99), v = random.uniform(0.01, 0.99);
            const V3d p = (p00 * (1 - u) + p10 * u) * (1 - v) + (p01 * (1 - u) + p11 * u) * v;
            const SurfacePoint point = pointOf(*shape, downAt(p.x, p.y));
            expectNear(point.p, p, 1e-12);
            EXPECT_NEAR(point.uv.x, u, 1e-6);
            EXPECT_NEAR(point.uv.y, v, 1e-6);
            expectNear(point.dpdu, (p10 - p00) * (1 - v) + (p11 - p01) * v, 1e-5);
            expectNear(point.dpdv, (p01 - p00) * (1 - u) + (p11 - p10) * u, 1e-5);
            expectNear(point.ng, V3d(0, 0, 1));
        }
    }
}

TEST(QuadMesh, TextureCoordinatesChangeTheDerivatives) {
    MeshInput mesh = patch(V3d(0, 0, 0), V3d(2, 0, 0), V3d(0, 1, 0), V3d(2, 1, 0));
    mesh.uv = {V2f(0, 1), V2f(0, 0), V2f(1, 1), V2f(1, 0)}; // s = v, t = 1 - u
    const SurfacePoint point = pointOf(*onlyShape(mesh), downAt(0.5, 0.25));
    EXPECT_EQ(point.uv, V2f(0.25f, 0.75f));
    expectNear(point.dpdu, V3d(0, 1, 0));
    expectNear(point.dpdv, V3d(-2, 0, 0));
    expectNear(point.ng, V3d(0, 0, 1));
}

TEST(QuadMesh, WhatIsFlatAndConvexAndWhatIsNot) {
    const auto kindOf = [](const MeshInput& mesh) { return onlyShape(mesh)->kind(); };
    EXPECT_EQ(kindOf(saddle()), GeometryKind::User);
    // Flat but with a corner that points inwards: the patch folds over itself.
    EXPECT_EQ(kindOf(patch(V3d(0, 0, 0), V3d(2, 0, 0), V3d(0, 2, 0), V3d(0.5, 0.5, 0))), GeometryKind::User);
    // A turned rectangle stays flat as far as floats can say.
    M44d m;
    m.setAxisAngle(V3d(1, 2, 3).normalized(), 0.7);
    for (const double distance : {0., 1., 1e3, 1e5}) {
        M44d t;
        t.setTranslation(V3d(distance, -distance / 3, distance / 2));
        EXPECT_EQ(onlyShape(patch(V3d(0, 0, 0), V3d(3, 0, 0), V3d(0, 2, 0), V3d(3, 2, 0)), Transform(m * t))->kind(),
                  GeometryKind::Quads);
    }
    // Both kinds in one mesh become two shapes, triangles with them a third.
    MeshInput mixed = saddle();
    mixed.p.insert(mixed.p.end(), {V3f(5, 0, 0), V3f(6, 0, 0), V3f(5, 1, 0), V3f(6, 1, 0)});
    mixed.quads.insert(mixed.quads.end(), {4, 5, 6, 7});
    mixed.triangles = {4, 5, 6};
    const auto shapes = makeMeshShapes(mixed, {}, false);
    ASSERT_EQ(shapes.size(), 3u);
    EXPECT_EQ(shapes[0]->kind(), GeometryKind::Triangles);
    EXPECT_EQ(shapes[1]->kind(), GeometryKind::Quads);
    EXPECT_EQ(shapes[2]->kind(), GeometryKind::User);
}

TEST(BilinearPatches, HitsLieOnThePatchAndTheRay) {
    const MeshInput mesh = saddle();
    const ShapePtr shape = onlyShape(mesh);
    RandomStream random(2);
    for (int i = 0; i < 1000; ++i) {
        const Ray ray{V3d(random.uniform(-3, 3), random.uniform(-3, 3), 3),
                      V3d(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), -1)};
        PrimitiveHit hit;
        if (!shape->intersect(0, ray, 0, infinityD, hit)) continue;
        const SurfacePoint point = shape->pointAt(ray, hit);
        expectNear(point.p, ray.at(hit.s), 1e-13);
        EXPECT_NEAR(point.p.z, point.p.x * point.p.y / 2, 1e-13);
        const V3d normal = V3d(-point.p.y / 2, -point.p.x / 2, 1).normalized();
        expectNear(point.ng, normal);
        // n = (-y/2, -x/2, 1)/|.|, p = (2u - 1, 2v - 1, .)
        constexpr double h = 1e-5;
        const auto normalAt = [&](double x, double y) { return V3d(-y / 2, -x / 2, 1).normalized(); };
        expectNear(point.dndu, (normalAt(point.p.x + h, point.p.y) - normalAt(point.p.x - h, point.p.y)) / h, 1e-5);
        expectNear(point.dndv, (normalAt(point.p.x, point.p.y + h) - normalAt(point.p.x, point.p.y - h)) / h, 1e-5);
    }
}

TEST(BilinearPatches, BothCrossingsAreFound) {
    // The line y = -x at height 0.2 under the saddle's ridge crosses it at x = +-sqrt(0.4).
    const ShapePtr shape = onlyShape(saddle());
    const Ray ray{V3d(-2, 2, -0.2), V3d(1, -1, 0)};
    PrimitiveHit hit;
    ASSERT_TRUE(shape->intersect(0, ray, 0, infinityD, hit));
    EXPECT_NEAR(hit.s, 2 - std::sqrt(0.4), 1e-12);
    ASSERT_TRUE(shape->intersect(0, ray, hit.s + 1e-9, infinityD, hit));
    EXPECT_NEAR(hit.s, 2 + std::sqrt(0.4), 1e-12);
    EXPECT_FALSE(shape->intersect(0, ray, hit.s + 1e-9, infinityD, hit));
}

TEST(BilinearPatches, Area) {
    // z = xy/2 over [-1,1]^2: the integral of sqrt(1 + (x^2 + y^2)/4), by the midpoint rule.
    double sum = 0;
    constexpr int n = 400;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            sum += std::sqrt(1 + (sqr((2 * i + 1.) / n - 1) + sqr((2 * j + 1.) / n - 1)) / 4);
    EXPECT_NEAR(onlyShape(saddle())->area(), sum * 4 / n / n, 1e-5);
}

TEST(Meshes, NonsenseRaysMeetNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const ShapePtr& shape : {onlyShape(rightTriangle()), onlyShape(cubeMesh()), onlyShape(saddle())})
        for (unsigned prim = 0; prim < shape->primitiveCount(); ++prim)
            for (const double bad : {nan, infinityD, -infinityD})
                for (int k = 0; k < 3; ++k) {
                    Ray direction = downAt(0.2, 0.3), origin = direction;
                    direction.d[k] = bad;
                    origin.o[k] = bad;
                    PrimitiveHit hit;
                    EXPECT_FALSE(shape->intersect(prim, direction, 0, infinityD, hit)) << prim << bad << k;
                    EXPECT_FALSE(shape->intersect(prim, origin, 0, infinityD, hit)) << prim << bad << k;
                    EXPECT_FALSE(shape->intersect(prim, Ray{V3d(0.2, 0.3, 5), V3d(0, 0, 0)}, 0, infinityD, hit));
                }
}

} // namespace vitrine::test
