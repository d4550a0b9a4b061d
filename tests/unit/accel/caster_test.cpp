// What the casters promise beyond agreeing with each other: ties, shadows, segments, instances, extremes.
#include "accel/caster.h"
#include "shapes/plane.h"
#include "shapes/revolution/revolution.h"
#include "shapes/sphere.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

namespace vitrine::test {

namespace {

using MakeCaster = std::unique_ptr<Caster> (*)(CasterInput);

ShapePtr sphereAt(const V3d& center, double radius) {
    M44d m;
    m.setTranslation(center);
    return std::make_shared<Sphere>(Transform(m), false, radius, -radius, radius, 360);
}

/// A square of half side 1 at height z, facing up.
ShapePtr sheet(double z) {
    return onlyShape(patch(V3d(-1, -1, z), V3d(1, -1, z), V3d(-1, 1, z), V3d(1, 1, z)));
}

Transform translation(const V3d& t) {
    M44d m;
    m.setTranslation(t);
    return Transform(m);
}

const Ray down{V3d(0.1, 0.2, 10), V3d(0, 0, -1)};

class EveryCaster : public testing::TestWithParam<MakeCaster> {
  protected:
    static std::unique_ptr<Caster> make(CasterInput input) { return GetParam()(std::move(input)); }
    static CasterHit hitOf(const Caster& caster, const Ray& ray) {
        CasterHit hit;
        EXPECT_TRUE(caster.intersect(ray, hit));
        return hit;
    }
};

} // namespace

TEST_P(EveryCaster, NothingIsMetInAnEmptyWorld) {
    const auto caster = make({});
    CasterHit hit;
    EXPECT_FALSE(caster->intersect(down, hit));
    EXPECT_FALSE(caster->occluded(down));
    EXPECT_TRUE(caster->bounds().isEmpty());
}

TEST_P(EveryCaster, ClosestOfMeshSphereAndPlane) {
    CasterInput input;
    input.shapes = {{sheet(1), 7, true},
                    {sphereAt(V3d(0, 0, 0), 0.5), 8, true},
                    {std::make_shared<Plane>(Transform(), false, V3d(0, 0, 1), -2.), 9, true}};
    const auto caster = make(input);
    const CasterHit onSheet = hitOf(*caster, down);
    EXPECT_EQ(onSheet.id, 7u);
    EXPECT_EQ(onSheet.shape, input.shapes[0].shape.get());
    EXPECT_EQ(onSheet.instance, CasterHit::noInstance);
    EXPECT_DOUBLE_EQ(onSheet.s, 9);
    EXPECT_EQ(hitOf(*caster, Ray{V3d(0.1, 0.2, 0.9), down.d}).id, 8u);
    const CasterHit onPlane = hitOf(*caster, Ray{V3d(3, 3, 0), down.d * 4});
    EXPECT_EQ(onPlane.id, 9u);
    EXPECT_DOUBLE_EQ(onPlane.s, 0.5);
    EXPECT_EQ(caster->bounds().max.z, 1);
    EXPECT_EQ(caster->bounds().min.z, -0.5);
}

TEST_P(EveryCaster, SegmentsEndBeforeTheirEnd) {
    CasterInput input;
    input.shapes = {{sheet(1), 0, true}, {sphereAt(V3d(0, 0, -3), 1), 1, true}};
    const auto caster = make(input);
    CasterHit hit;
    for (const double scale : {1e-30, 1e-6, 1., 1e6, 1e30}) {
        Ray ray{V3d(0, 0, 10), V3d(0, 0, -scale)};
        ray.tMax = 8.999 / scale;
        EXPECT_FALSE(caster->intersect(ray, hit)) << scale;
        EXPECT_FALSE(caster->occluded(ray)) << scale;
        ray.tMax = 9.001 / scale;
        EXPECT_TRUE(caster->intersect(ray, hit)) << scale;
        EXPECT_NEAR(hit.s * scale, 9, 1e-12);
        EXPECT_TRUE(caster->occluded(ray)) << scale;
    }
    // Analytic shapes to the last bit.
    Ray ray{V3d(0, 0, -1), V3d(0, 0, -1)};
    ray.tMax = 1;
    EXPECT_FALSE(caster->intersect(ray, hit));
    ray.tMax = std::nextafter(1., 2.);
    EXPECT_TRUE(caster->intersect(ray, hit));
}

TEST_P(EveryCaster, SurfacesWithoutShadowAreSeenAllTheSame) {
    CasterInput input;
    input.shapes = {{sheet(1), 0, false},
                    {sphereAt(V3d(0, 0, 3), 1), 1, false},
                    {std::make_shared<Plane>(Transform(), false, V3d(0, 0, 1), 5.), 2, false}};
    input.groups = {{{sheet(0), 3, false}}};
    input.instances = {{0, translation(V3d(0, 0, -1))}};
    auto caster = make(input);
    EXPECT_FALSE(caster->occluded(down));
    EXPECT_EQ(hitOf(*caster, down).id, 2u);
    EXPECT_EQ(hitOf(*caster, Ray{V3d(0, 0, 4.5), down.d}).id, 1u);
    EXPECT_EQ(hitOf(*caster, Ray{V3d(0, 0, 1.5), down.d}).id, 0u);
    EXPECT_EQ(hitOf(*caster, Ray{V3d(0, 0, 0.5), down.d}).id, 3u);
    for (std::size_t k = 0; k < 3; ++k) {
        CasterInput changed = input;
        changed.shapes[k].castsShadow = true;
        EXPECT_TRUE(make(changed)->occluded(down)) << k;
    }
    input.groups[0][0].castsShadow = true;
    EXPECT_TRUE(make(input)->occluded(down));
}

TEST_P(EveryCaster, TiesOfAnalyticShapesGoToTheLowerNumber) {
    // The same sphere many times over, out of order, and once more in an instance.
    CasterInput input;
    for (const std::uint32_t id : {5u, 3u, 9u, 4u})
        input.shapes.push_back({sphereAt(V3d(0, 0, 0), 1), id, true});
    input.groups = {{{sphereAt(V3d(0, 0, 0), 1), 1, true}}};
    input.instances = {{0, Transform()}, {0, Transform()}};
    EXPECT_EQ(hitOf(*make(input), down).id, 3u);
    input.shapes.clear();
    const CasterHit hit = hitOf(*make(input), down);
    EXPECT_EQ(hit.id, 1u);
    EXPECT_EQ(hit.instance, 0u);
    // A plane that touches the sphere.
    input = {};
    input.shapes = {{sphereAt(V3d(0, 0, 0), 1), 2, true},
                    {std::make_shared<Plane>(Transform(), false, V3d(0, 0, 1), 1.), 1, true}};
    EXPECT_EQ(hitOf(*make(input), Ray{V3d(0, 0, 10), V3d(0, 0, -1)}).id, 1u);
}

TEST_P(EveryCaster, TiesBetweenMeshAndAnalyticShapeGoToTheLowerNumber) {
    for (const bool meshFirst : {false, true}) {
        CasterInput input;
        input.shapes = {{sheet(1), meshFirst ? 1u : 2u, true},
                        {std::make_shared<Plane>(Transform(), false, V3d(0, 0, 1), 1.), meshFirst ? 2u : 1u, true}};
        const auto caster = make(input);
        RandomStream random(1);
        for (int i = 0; i < 1000; ++i) {
            const V3d o(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(1.1, 9));
            const V3d target(random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9), 1);
            ASSERT_EQ(hitOf(*caster, Ray{o, target - o}).id, 1u);
        }
    }
}

TEST_P(EveryCaster, TiesBetweenSmallMeshesGoToTheLowerNumber) {
    // Faces in the plane z = 1 of several shapes: quads, triangles, of different size, some seen from below.
    MeshInput triangle;
    triangle.p = {V3f(-3, -1, 1), V3f(3, -1, 1), V3f(0, 4, 1)};
    triangle.triangles = {0, 2, 1};
    const ShapePtr shapes[] = {sheet(1), onlyShape(cubeMesh(V3d(0.2, 0.1, 0), 1)), onlyShape(triangle),
                               onlyShape(patch(V3d(-3, -2, 1), V3d(2, -3, 1), V3d(-2, 3, 1), V3d(3, 2, 1)))};
    RandomStream random(2);
    for (std::uint32_t first = 0; first < std::size(shapes); ++first) {
        CasterInput input;
        for (std::uint32_t i = 0; i < std::size(shapes); ++i)
            input.shapes.push_back({shapes[i], (i + first) % std::uint32_t(std::size(shapes)), true});
        const auto caster = make(input);
        for (int i = 0; i < 1000; ++i) {
            const V3d o(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(1.1, 9));
            const V3d target(random.uniform(-0.7, 0.7), random.uniform(-0.8, 0.9), 1);
            ASSERT_EQ(hitOf(*caster, Ray{o, target - o}).id, 0u) << first;
        }
    }
}

TEST_P(EveryCaster, TiesBetweenEqualMeshesGoToTheLowerNumber) {
    M44d m;
    m.setAxisAngle(V3d(1, 2, 3).normalized(), 1.);
    CasterInput input;
    for (const std::uint32_t id : {5u, 2u, 8u})
        input.shapes.push_back({onlyShape(cubeMesh(), Transform(m)), id, true});
    const auto caster = make(input);
    RandomStream random(3);
    for (int i = 0; i < 1000; ++i)
        ASSERT_EQ(
            hitOf(*caster, Ray{V3d(0, 0, 0), toDouble(sampleUniformSphere(V2f(float(i) / 1000, random.uniform())))}).id,
            2u);
}

TEST_P(EveryCaster, InstancesCarryPointsAndNormals) {
    CasterInput input;
    input.groups = {{{sphereAt(V3d(1, 0, 0), 0.5), 0, true}, {sheet(-1), 1, true}}};
    M44d mirrored;
    mirrored.setScale(V3d(-2, 2, 2));
    input.instances = {{0, translation(V3d(10, 0, 0))}, {0, Transform(mirrored)}};
    const auto caster = make(input);
    const CasterHit first = hitOf(*caster, Ray{V3d(11, 0, 10), V3d(0, 0, -1)});
    EXPECT_EQ(first.instance, 0u);
    EXPECT_NEAR(first.s, 9.5, 1e-12);
    EXPECT_LT(maxAbs(first.point.p - V3d(11, 0, 0.5)), 1e-12);
    EXPECT_NEAR(first.point.ng.z, 1, 1e-6);
    // Mirrored, the outside stays the outside.
    const CasterHit second = hitOf(*caster, Ray{V3d(-2, 0, 10), V3d(0, 0, -1)});
    EXPECT_EQ(second.instance, 1u);
    EXPECT_LT(maxAbs(second.point.p - V3d(-2, 0, 1)), 1e-12);
    EXPECT_NEAR(second.point.ng.z, 1, 1e-6);
    EXPECT_NEAR(second.point.dpdu.dot(second.point.ng), 0, 1e-5);
    const CasterHit third = hitOf(*caster, Ray{V3d(1, 1, 10), V3d(0, 0, -1)});
    EXPECT_EQ(third.id, 1u);
    EXPECT_LT(maxAbs(third.point.p - V3d(1, 1, -2)), 1e-12);
    EXPECT_NEAR(third.point.ng.z, 1, 1e-6);
    EXPECT_NEAR(third.point.dpdu.x, -4, 1e-5);
    EXPECT_LT(maxAbs(caster->bounds().max - V3d(11.5, 2, 1)), 1e-6);
    EXPECT_LT(maxAbs(caster->bounds().min - V3d(-3, -2, -2)), 1e-6);
}

TEST_P(EveryCaster, OriginsFarAway) {
    CasterInput input;
    input.shapes = {{sheet(1), 0, true}, {sphereAt(V3d(0, 0, 3), 0.25), 1, true}};
    const auto caster = make(input);
    CasterHit hit;
    for (const double far : {1e3, 1e6, 1e9, 1e12}) {
        for (const double aside : {0., 0.5}) {
            const Ray ray{V3d(aside, 0, far), V3d(0, 0, -1)};
            ASSERT_TRUE(caster->intersect(ray, hit)) << far;
            EXPECT_EQ(hit.id, aside == 0 ? 1u : 0u) << far;
            EXPECT_TRUE(caster->occluded(ray));
            EXPECT_FALSE(caster->intersect(Ray{ray.o, -ray.d}, hit));
            EXPECT_FALSE(caster->occluded(Ray{ray.o, ray.d, far / 2}));
        }
        EXPECT_FALSE(caster->intersect(Ray{V3d(1.5, 0, far), V3d(0, 0, -1)}, hit)) << far;
    }
}

TEST_P(EveryCaster, ShapesOfAnySize) {
    // Embree's floats end at 1.8e18; shapes beyond are no less there.
    for (const double size : {1e-20, 1e-6, 1., 1e10, 1e17, 1e19, 1e30, 1e100}) {
        CasterInput input;
        input.shapes = {{sphereAt(V3d(0, 0, 0), size), 0, true}};
        const auto caster = make(input);
        const Ray ray{V3d(0, 0, 3 * size), V3d(0, 0, -1)};
        EXPECT_NEAR(hitOf(*caster, ray).s / size, 2, 1e-12) << size;
        EXPECT_TRUE(caster->occluded(ray));
        EXPECT_NEAR(hitOf(*caster, Ray{V3d(0, 0, 0), V3d(0, 1, 0)}).s / size, 1, 1e-12) << size;
    }
    for (const double size : {1e-15, 1e-6, 1., 1e10, 1e17, 1e19, 1e30}) {
        CasterInput input;
        input.shapes = {{onlyShape(icosphere(1, V3d(0, 0, 0), size)), 0, true}};
        const auto caster = make(input);
        EXPECT_NEAR(hitOf(*caster, Ray{V3d(0, 0, 0), V3d(0.1, 0.9, 0.2)}).s / size, 1, 0.2) << size;
    }
}

const char* const kinds[] = {"Embree", "BruteForce", "Quickest"};
INSTANTIATE_TEST_SUITE_P(Kinds, EveryCaster, testing::Values(&makeEmbreeCaster, &makeBruteForceCaster, &makeCaster),
                         [](const auto& which) { return kinds[which.index]; });

TEST(FlatCaster, RefusesWhatIsTooMuch) {
    CasterInput input;
    for (std::uint32_t id = 0; id < maxFlatPrimitives; ++id)
        input.shapes.push_back({sphereAt(V3d(3. * id, 0, 0), 1), id, true});
    EXPECT_NO_THROW(makeFlatCaster(input));
    input.shapes.push_back({sphereAt(V3d(0, 3, 0), 1), maxFlatPrimitives, true});
    EXPECT_THROW(makeFlatCaster(input), std::invalid_argument);
    input.shapes.resize(1);
    input.groups = {{{sheet(0), 1, true}}};
    input.instances = {{0, Transform()}};
    EXPECT_THROW(makeFlatCaster(input), std::invalid_argument);
}

TEST(FlatCaster, TakesEveryLane) {
    // Each of the most spheres there may be, alone in the way of its own ray.
    for (std::uint32_t count = 1; count <= maxFlatPrimitives; ++count) {
        CasterInput input;
        for (std::uint32_t id = 0; id < count; ++id)
            input.shapes.push_back({sphereAt(V3d(3. * id, 0, 0), 1), id, id % 2 == 0});
        const auto caster = makeFlatCaster(input);
        for (std::uint32_t id = 0; id < count; ++id) {
            CasterHit hit;
            const Ray ray{V3d(3. * id + 0.1, 0.2, 10), V3d(0, 0, -1)};
            ASSERT_TRUE(caster->intersect(ray, hit)) << id;
            EXPECT_EQ(hit.id, id);
            EXPECT_EQ(caster->occluded(ray), id % 2 == 0) << id;
            EXPECT_FALSE(caster->intersect(Ray{ray.o + V3d(1.4, 0, 0), ray.d}, hit)) << id;
        }
    }
}

TEST(EmbreeCaster, CountsItsMemory) {
    CasterInput input;
    input.shapes = {{onlyShape(icosphere(5)), 0, true}};
    const auto caster = makeEmbreeCaster(input);
    const std::size_t triangles = input.shapes[0].shape->primitiveCount();
    EXPECT_GT(caster->memoryBytes(), 20 * triangles);
    EXPECT_LT(caster->memoryBytes(), 400 * triangles);
}

TEST(Caster, CountsTheMemoryOfItsShapes) {
    std::vector<V2d> points;
    for (int i = 0; i <= 300; ++i)
        points.emplace_back(1 + 0.1 * (i % 7), 0.01 * i);
    const auto turned = std::make_shared<Revolution>(Transform(), false, Profile(points, 1));
    const std::size_t ofTurned = turned->memoryBytes(), besides = ofTurned / 2;
    ASSERT_GT(ofTurned, 100'000u);
    CasterInput input;
    input.shapes = {{turned, 0, true}};
    for (const MakeCaster make : {makeCaster, makeEmbreeCaster, makeBruteForceCaster}) {
        EXPECT_GT(make(input)->memoryBytes(), ofTurned);
        EXPECT_LT(make(input)->memoryBytes(), ofTurned + besides);
    }
    // That of a group once, however often it is placed.
    input.groups = {input.shapes};
    for (int i = 1; i <= 5; ++i)
        input.instances.push_back({0, translation(V3d(4. * i, 0, 0))});
    for (const MakeCaster make : {makeEmbreeCaster, makeBruteForceCaster}) {
        EXPECT_GT(make(input)->memoryBytes(), 2 * ofTurned);
        EXPECT_LT(make(input)->memoryBytes(), 2 * ofTurned + besides);
    }
}

} // namespace vitrine::test
