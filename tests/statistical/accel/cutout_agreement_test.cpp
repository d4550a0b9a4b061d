// Shapes with holes: Embree's and the flat caster find what the oracle finds, and holes let through what they should.
#include "shapes/box.h"
#include "shapes/cylinder.h"
#include "shapes/disk.h"
#include "shapes/plane.h"
#include "shapes/revolution/revolution.h"
#include "shapes/sphere.h"
#include "support/caster_agreement.h"
#include "support/meshes.h"
#include "support/revolution_cases.h"
#include "support/spotted_cutout.h"

namespace vitrine::test {

namespace {

const Allowance exact{0, 0};

/// All with holes but the last.
CasterInput withHoles(std::vector<ShapePtr> shapes, const CutoutPtr& cutout = std::make_shared<SpottedCutout>()) {
    CasterInput input;
    for (std::size_t i = 0; i < shapes.size(); ++i)
        input.shapes.push_back({shapes[i], std::uint32_t(i), i % 3 != 2, i + 1 < shapes.size() ? cutout : nullptr});
    return input;
}

Box3d aimAt(const CasterInput& input) {
    const Box3d box = makeBruteForceCaster(input)->bounds();
    return box.isEmpty() ? Box3d(V3d(-2), V3d(2)) : box;
}

CasterInput analytic() {
    const auto points = joined(gobletProfile());
    return withHoles({std::make_shared<Sphere>(placed(V3d(0.5, 0, 0), V3d(1, 0.7, 1), 1), false, 1, -0.6, 0.9, 300),
                      std::make_shared<Sphere>(placed(V3d(-1, 1, 0), V3d(1), 0), false, 0.8, -1, 1, 360),
                      std::make_shared<Disk>(placed(V3d(0, 0, 1), V3d(1), 2), false, 0.5, 1, 0.3, 300),
                      std::make_shared<Cylinder>(placed(V3d(0, 1, 0), V3d(1, 2, 1), 1), false, 1, -0.6, 0.9, 300),
                      std::make_shared<Box>(placed(V3d(0, -1, 0), V3d(1), 1), false, V3d(-1), V3d(1)),
                      std::make_shared<Revolution>(Transform(), false,
                                                   Profile(points, int(gobletProfile().front().size()) - 1), 360),
                      std::make_shared<Plane>(placed(V3d(0, -1, 0), V3d(1), 1), false, V3d(0, 1, 0), -1),
                      onlyShape(soup(8, 12, 4)),
                      std::make_shared<Sphere>(placed(V3d(1, 1, 1), V3d(1), 0), false, 0.8, -1, 1, 360)});
}

CasterInput meshes(const CutoutPtr& cutout) {
    return withHoles({onlyShape(soup(6, 15, 3)), onlyShape(cubeMesh()), onlyShape(icosphere(3, V3d(1, 0, 0))),
                      onlyShape(cubeMesh(), placed(V3d(0.3, 0, 0.7), V3d(0.4, 0.5, 0.6), 1)), onlyShape(icosphere(0))},
                     cutout);
}

} // namespace

TEST(CutoutAgreement, AnalyticShapes) {
    const CasterInput input = analytic();
    expectCastersAgree(input, aimAt(input), 21, 300'000, exact);
}

TEST(CutoutAgreement, FlatCaster) {
    const CasterInput input = analytic();
    expectAgreement(*makeFlatCaster(input), input, aimAt(input), 22, 300'000, exact);
    const CasterInput few =
        withHoles({onlyShape(cubeMesh()), onlyShape(soup(6, 15, 3)), onlyShape(cubeMesh(V3d(1, 0, 0)))});
    expectAgreement(*makeFlatCaster(few), few, aimAt(few), 23, 300'000, exact);
}

TEST(CutoutAgreement, Meshes) {
    const CasterInput cut = meshes(std::make_shared<SpottedCutout>(0.25, false));
    expectCastersAgree(cut, aimAt(cut), 24, 60'000, {});
}

TEST(CutoutAgreement, MeshesHalfThere) {
    const CasterInput half = meshes(std::make_shared<EvenCutout>(0.5f));
    expectCastersAgree(half, aimAt(half), 25, 60'000, {});
}

TEST(CutoutAgreement, Instances) {
    const CutoutPtr cutout = std::make_shared<SpottedCutout>();
    CasterInput input;
    input.groups.push_back(
        {{onlyShape(icosphere(0)), 10, true, cutout},
         {std::make_shared<Sphere>(placed(V3d(1, 1, 0), V3d(1), 0), true, 0.5, -1, 1, 360), 11, true, cutout},
         {onlyShape(icosphere(3, V3d(-1, 0, 0))), 12, true, cutout}});
    input.groups.push_back(
        {{onlyShape(cubeMesh(V3d(300, 0, 0), 0.4)), 20, true, cutout},
         {std::make_shared<Plane>(placed(V3d(0, -9, 0), V3d(1), 0.3), false, V3d(0, 1, 0), 0), 21, true, cutout}});
    input.instances = {{0, placed(V3d(-2, 0, 1), V3d(0.5), 1)},
                       {0, placed(V3d(0, 2, 1), V3d(-0.5, 0.5, 1), 2)},
                       {1, Transform(M44d(0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, -300, 1))},
                       {1, placed(V3d(-301, 1, 2), V3d(1), 0)}};
    expectCastersAgree(input, Box3d(V3d(-3), V3d(3)), 26, 30'000, {});
}

/// Of rays through a half-transparent ball half meet its front, a quarter its back, and a quarter pass; the two crossings
/// are independent, and so are two shapes in the same place.
TEST(CutoutShare, OfRaysThatPass) {
    constexpr int rays = 100'000;
    const auto ball = std::make_shared<Sphere>(Transform(), false, 1, -1, 1, 360);
    const CutoutPtr half = std::make_shared<EvenCutout>(0.5f);
    for (const int shapes : {1, 2}) {
        CasterInput input;
        for (int i = 0; i < shapes; ++i)
            input.shapes.push_back({ball, std::uint32_t(i), true, half});
        const auto caster = makeEmbreeCaster(input);
        RandomStream random(27, shapes);
        int front = 0, back = 0, shadows = 0;
        for (int i = 0; i < rays; ++i) {
            const Ray ray{V3d(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 5), V3d(0, 0, -1)};
            CasterHit hit;
            if (caster->intersect(ray, hit)) ++(hit.point.p.z > 0 ? front : back);
            shadows += caster->occluded(ray);
        }
        const double pass = std::pow(0.5, shapes);
        const auto expectShare = [&](int count, double share) {
            EXPECT_NEAR(count, rays * share, 5 * std::sqrt(rays * share * (1 - share)));
        };
        expectShare(front, 1 - pass);
        expectShare(back, pass * (1 - pass));
        EXPECT_EQ(shadows, front + back);
    }
}

} // namespace vitrine::test
