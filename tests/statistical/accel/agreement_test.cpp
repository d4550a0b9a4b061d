// Embree's caster equals the oracle: a million rays for each kind of shape.
#include "shapes/box.h"
#include "shapes/cylinder.h"
#include "shapes/disk.h"
#include "shapes/plane.h"
#include "shapes/revolution/revolution.h"
#include "shapes/sphere.h"
#include "support/caster_agreement.h"
#include "support/meshes.h"
#include "support/revolution_cases.h"

namespace vitrine::test {

namespace {

constexpr int million = 1'000'000;
const Allowance exact{0, 0};

CasterInput of(std::vector<ShapePtr> shapes) {
    CasterInput input;
    for (std::size_t i = 0; i < shapes.size(); ++i)
        input.shapes.push_back(CasterShape{shapes[i], std::uint32_t(i), i % 3 != 2});
    return input;
}

/// The shapes placed here and there.
template <class Make>
CasterInput several(Make make) {
    return of({make(placed(V3d(0, 0, 0), V3d(1), 0)), make(placed(V3d(2, 0.5, 0), V3d(0.7), 1)),
               make(placed(V3d(-1, 1.5, -2), V3d(0.3, 1, 0.5), 2))});
}

Box3d boundsOf(const CasterInput& input) {
    return makeBruteForceCaster(input)->bounds();
}

} // namespace

TEST(Agreement, Spheres) {
    const CasterInput input =
        several([](const Transform& t) { return std::make_shared<Sphere>(t, false, 1, -0.6, 0.9, 300); });
    expectCastersAgree(input, boundsOf(input), 1, million, exact);
}

TEST(Agreement, Disks) {
    const CasterInput input =
        several([](const Transform& t) { return std::make_shared<Disk>(t, false, 0.5, 1, 0.3, 300); });
    expectCastersAgree(input, boundsOf(input), 2, million, exact);
}

TEST(Agreement, Cylinders) {
    const CasterInput input =
        several([](const Transform& t) { return std::make_shared<Cylinder>(t, false, 1, -0.6, 0.9, 300); });
    expectCastersAgree(input, boundsOf(input), 3, million, exact);
}

TEST(Agreement, Boxes) {
    const CasterInput input =
        several([](const Transform& t) { return std::make_shared<Box>(t, false, V3d(-1, -0.5, 0), V3d(1, 0.5, 2)); });
    expectCastersAgree(input, boundsOf(input), 4, million, exact);
}

TEST(Agreement, Revolutions) {
    const auto turned = [](const ProfilePoints& profile, const Transform& t, double phiMax = 360) {
        const auto points = joined(profile);
        return std::make_shared<Revolution>(t, false, Profile(points, int(profile.front().size()) - 1), phiMax);
    };
    const CasterInput input =
        of({turned(gobletProfile(), Transform()), turned(vaseProfile(), placed(V3d(0.8, 0, 0.3), V3d(1), 0.2)),
            turned(vaseProfile(), placed(V3d(-0.5, 0.4, 0), V3d(1.5), 1), 200)});
    expectCastersAgree(input, boundsOf(input), 11, million, exact);
}

TEST(Agreement, Planes) {
    const CasterInput input =
        several([](const Transform& t) { return std::make_shared<Plane>(t, false, V3d(0, 1, 0), -1); });
    expectCastersAgree(input, Box3d(V3d(-2), V3d(2)), 5, million, exact);
}

TEST(Agreement, Triangles) {
    const CasterInput input =
        of({onlyShape(soup(6, 15, 3)), onlyShape(icosphere(0), placed(V3d(0.3, 0, 0), V3d(0.4, 0.5, 0.6), 1))});
    expectCastersAgree(input, boundsOf(input), 6, million, {});
}

TEST(Agreement, PlanarQuads) {
    const CasterInput input =
        of({onlyShape(cubeMesh()), onlyShape(cubeMesh(), placed(V3d(0.3, 0, 0.7), V3d(0.4, 0.5, 0.6), 1)),
            onlyShape(patch(V3d(-2, -1.5, -2), V3d(2, -1.5, -2), V3d(-1, -1.5, 1), V3d(1.5, -1.5, 2)))});
    expectCastersAgree(input, boundsOf(input), 7, million, {});
}

TEST(Agreement, BentPatches) {
    const CasterInput input = of({onlyShape(soup(8, 20, 4))});
    ASSERT_EQ(input.shapes.front().shape->kind(), GeometryKind::User);
    expectCastersAgree(input, boundsOf(input), 8, million, exact);
}

TEST(Agreement, Mixtures) {
    CasterInput input =
        of({onlyShape(cubeMesh(V3d(0, -2, 0), 1)),
            std::make_shared<Plane>(placed(V3d(0, -4, 0), V3d(1), 0.1), false, V3d(0, 1, 0), 0),
            std::make_shared<Sphere>(Transform(), false, 0.8, -1, 1, 360), onlyShape(icosphere(0, V3d(2, 0, 0)))});
    input.groups.push_back(
        {{onlyShape(icosphere(0)), 10, true},
         {std::make_shared<Sphere>(placed(V3d(1, 1, 0), V3d(1), 0), true, 0.5, -1, 1, 360), 11, true},
         {onlyShape(soup(9, 3, 4)), 12, false}});
    input.groups.push_back(
        {{onlyShape(cubeMesh(V3d(300, 0, 0), 0.4)), 20, true},
         {std::make_shared<Plane>(placed(V3d(0, -9, 0), V3d(1), 0.3), false, V3d(0, 1, 0), 0), 21, false}});
    input.instances = {{0, placed(V3d(-2, 0, 1), V3d(0.5), 1)},
                       {0, placed(V3d(0, 2, 1), V3d(-0.5, 0.5, 1), 2)},
                       {1, Transform(M44d(0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, -300, 1))},
                       {1, placed(V3d(-301, 1, 2), V3d(1), 0)}};
    expectCastersAgree(input, Box3d(V3d(-3), V3d(3)), 9, million, {});
}

TEST(Agreement, LargeMeshFarFromTheOrigin) {
    const V3d far(1e5, -2e4, 0.5);
    const CasterInput input =
        of({onlyShape(icosphere(3, far)), onlyShape(cubeMesh(far, 2)),
            std::make_shared<Sphere>(placed(far + V3d(1.5, 0, 0), V3d(0.3), 0), false, 1, -1, 1, 360)});
    expectCastersAgree(input, boundsOf(input), 10, million / 50, {});
}

/// The flat caster asks the very same solvers, so it is exact whatever the shapes are.
class FlatAgreement : public testing::TestWithParam<std::pair<const char*, CasterInput (*)()>> {};

TEST_P(FlatAgreement, OfEveryRay) {
    const CasterInput input = GetParam().second();
    Box3d aim = boundsOf(input);
    if (aim.isEmpty()) aim = Box3d(V3d(-2), V3d(2));
    expectAgreement(*makeFlatCaster(input), input, aim, 12, million / 5, exact);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, FlatAgreement,
    testing::Values(
        std::pair(
            "Spheres",
            +[] {
                return of({std::make_shared<Sphere>(placed(V3d(0.1, 0, 0), V3d(1, 2, 1), 1), false, 1, -0.6, 0.9, 300),
                           std::make_shared<Sphere>(placed(V3d(1, 1, 0), V3d(1), 0), false, 0.5, -0.5, 0.5, 360),
                           std::make_shared<Sphere>(placed(V3d(1, 0, 1), V3d(1), 0), false, 1, -1, 1, 360)});
            }),
        std::pair(
            "CylindersAndDisks",
            +[] {
                return of({std::make_shared<Cylinder>(placed(V3d(0, 1, 0), V3d(1, 2, 1), 1), false, 1, -0.6, 0.9, 300),
                           std::make_shared<Disk>(placed(V3d(0, 0, 0.2), V3d(1), 2), false, 0.5, 1, 0.3, 300),
                           std::make_shared<Disk>(Transform(), false, 0, 2, 0, 360)});
            }),
        std::pair(
            "BoxesAndPlanes",
            +[] {
                return of({std::make_shared<Box>(placed(V3d(0, 1, 0), V3d(1), 1), false, V3d(-1), V3d(1)),
                           std::make_shared<Plane>(placed(V3d(0, -1, 0), V3d(1), 1), false, V3d(0, 1, 0), -1),
                           std::make_shared<Box>(Transform(), false, V3d(-1, -2, 0), V3d(1, 0, 0.5))});
            }),
        std::pair(
            "OnlyPlanes",
            +[] {
                return of({std::make_shared<Plane>(Transform(), false, V3d(0, 1, 0), -1),
                           std::make_shared<Plane>(placed(V3d(0, 2, 0), V3d(1), 1), false, V3d(0, 1, 0), -1)});
            }),
        std::pair(
            "Goblet",
            +[] {
                const auto points = joined(gobletProfile());
                return of(
                    {std::make_shared<Revolution>(placed(V3d(0.2, 0, 0), V3d(1), 0.3), false,
                                                  Profile(points, int(gobletProfile().front().size()) - 1), 360)});
            }),
        std::pair(
            "Triangles", +[] { return of({onlyShape(soup(6, 16, 3))}); }),
        std::pair(
            "BentPatches", +[] { return of({onlyShape(soup(8, 12, 4))}); }),
        std::pair(
            "PlanarQuads",
            +[] {
                return of({onlyShape(cubeMesh()),
                           onlyShape(cubeMesh(), placed(V3d(0.3, 0, 0.7), V3d(0.4, 0.5, 0.6), 1)),
                           onlyShape(patch(V3d(-2, -1.5, -2), V3d(2, -1.5, -2), V3d(-1, -1.5, 1), V3d(1.5, -1.5, 2)))});
            }),
        std::pair(
            "FarFromTheOrigin",
            +[] {
                const V3d far(1e5, -2e4, 0.5);
                return of({onlyShape(cubeMesh(far, 2)),
                           std::make_shared<Sphere>(placed(far + V3d(1.5, 0, 0), V3d(0.3), 0), false, 1, -1, 1, 360)});
            })),
    [](const auto& which) { return which.param.first; });

} // namespace vitrine::test
