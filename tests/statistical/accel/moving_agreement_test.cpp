// What moves, in all casters.
#include "accel/moving_shape.h"
#include "shapes/box.h"
#include "shapes/plane.h"
#include "shapes/sphere.h"
#include "support/caster_agreement.h"
#include "support/meshes.h"

namespace vitrine::test {

namespace {

Motion anyMotion(RandomStream& random) {
    const auto pose = [&] {
        M44d turn, move, scale;
        turn.setAxisAngle(V3d(random.uniform(-1, 1), random.uniform(-1, 1), 1).normalized(), random.uniform(-1.5, 1.5));
        move.setTranslation(V3d(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)));
        scale.setScale(V3d(random.uniform(0.4, 1.2), random.uniform(0.4, 1.2), random.uniform(0.4, 1.2)));
        return Transform(scale * turn * move);
    };
    const Transform start = pose();
    return Motion(start, 0.1, pose(), 0.8);
}

/// \param withCaster meshes get casters inside
CasterInput movingScene(std::uint64_t seed, int shapes, bool withCaster) {
    RandomStream random(seed);
    const std::vector<ShapePtr> kinds{std::make_shared<Sphere>(Transform(), false, 1, -0.6, 0.9, 300),
                                      std::make_shared<Box>(Transform(), false, V3d(-1), V3d(1, 0.5, 0.3)),
                                      onlyShape(cubeMesh()), onlyShape(asTriangles(cubeMesh())),
                                      onlyShape(icosphere(2))};
    CasterInput input;
    for (int i = 0; i < shapes; ++i) {
        const ShapePtr& shape = kinds[std::size_t(i) % kinds.size()];
        const auto inside = withCaster ? MovingShape::casterFor(shape) : nullptr;
        input.shapes.push_back(
            {std::make_shared<MovingShape>(shape, anyMotion(random), Shutter(), inside), std::uint32_t(i), i % 3 != 2});
    }
    return input;
}

Box3d boundsOf(const CasterInput& input) {
    return makeBruteForceCaster(input)->bounds();
}

const Allowance exact{0, 0};

} // namespace

TEST(MovingAgreement, Embree) {
    const CasterInput input = movingScene(1, 40, true);
    expectCastersAgree(input, boundsOf(input), 1, 40'000, exact);
}

TEST(MovingAgreement, FlatList) {
    const CasterInput input = movingScene(2, 2, true);
    expectAgreement(*makeFlatCaster(input), input, boundsOf(input), 2, 200'000, exact);
}

TEST(MovingAgreement, CasterInsideOfAMeshAndItsFaces) {
    const CasterInput input = movingScene(3, 6, false);
    const auto caster = makeEmbreeCaster(movingScene(3, 6, true));
    expectAgreement(*caster, input, boundsOf(input), 3, 40'000, {});
}

/// In groups, beside a plane that moves, some of it in a group that moves itself.
TEST(MovingAgreement, InInstances) {
    CasterInput input;
    input.groups.push_back(movingScene(4, 5, true).shapes);
    RandomStream random(5);
    const Motion motion = anyMotion(random);
    input.shapes.push_back({std::make_shared<MovingShape>(std::make_shared<Plane>(Transform(), false, V3d(0, 1, 0), -2),
                                                          motion, Shutter()),
                            100});
    for (const CasterShape& entry : input.groups[0])
        input.shapes.push_back(
            {std::make_shared<MovingShape>(entry.shape, motion, Shutter()), 101 + entry.id, entry.castsShadow});
    for (const double x : {-4., 3.})
        input.instances.push_back({0, Transform(M44d().setTranslation(V3d(x, 1, 0)))});
    expectCastersAgree(input, boundsOf(input), 6, 40'000, exact);
}

} // namespace vitrine::test
