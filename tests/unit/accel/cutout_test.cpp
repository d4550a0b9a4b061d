// Shapes with holes, one ray at a time, in every caster.
#include "accel/caster.h"
#include "shapes/sphere.h"
#include "support/meshes.h"
#include "support/spotted_cutout.h"

#include <gtest/gtest.h>

namespace vitrine::test {

namespace {

using MakeCaster = std::unique_ptr<Caster> (*)(CasterInput);

/// Only what lies above a height is there.
class Above final : public Cutout {
  public:
    explicit Above(double z) : z_(z) {}
    float opacity(const SurfacePoint& point) const override { return point.p.z > z_ ? 1.f : 0.f; }

  private:
    double z_;
};

class CutCaster : public testing::TestWithParam<MakeCaster> {};

const Ray up{V3d(0.1, 0.2, -10), V3d(0, 0, 1)};

ShapePtr sheet(double z) {
    return onlyShape(patch(V3d(-1, -1, z), V3d(1, -1, z), V3d(-1, 1, z), V3d(1, 1, z)));
}

} // namespace

TEST_P(CutCaster, TheFarSideOfABallWithoutItsNearSide) {
    CasterInput input;
    input.shapes = {{std::make_shared<Sphere>(Transform(), false, 1, -1, 1, 360), 3, true, std::make_shared<Above>(0)}};
    const auto caster = GetParam()(input);
    CasterHit hit;
    ASSERT_TRUE(caster->intersect(up, hit));
    EXPECT_NEAR(hit.s, 10 + std::sqrt(1 - 0.05), 1e-12);
    EXPECT_TRUE(caster->occluded(up));
    EXPECT_FALSE(caster->occluded(Ray{up.o, up.d, 10}));
}

TEST_P(CutCaster, WhatLiesBehindAHole) {
    CasterInput input;
    input.shapes = {{sheet(0), 1, true, std::make_shared<Above>(0.5)},
                    {sheet(1), 2, true, std::make_shared<Above>(0.5)}};
    const auto caster = GetParam()(input);
    CasterHit hit;
    ASSERT_TRUE(caster->intersect(up, hit));
    EXPECT_EQ(hit.id, 2u);
    EXPECT_TRUE(caster->occluded(up));
    EXPECT_FALSE(caster->occluded(Ray{up.o, up.d, 10.5}));
}

/// Of two sheets in one place the lower number is met where it is there, and the other where it is not.
TEST_P(CutCaster, SheetsInOnePlace) {
    const CutoutPtr spots = std::make_shared<SpottedCutout>(0.1, false);
    for (const bool lowerHasHoles : {false, true}) {
        CasterInput input;
        input.shapes = {{sheet(0), 1, true, lowerHasHoles ? spots : nullptr},
                        {sheet(0), 2, true, lowerHasHoles ? nullptr : spots}};
        const auto caster = GetParam()(input);
        int lower = 0, higher = 0;
        for (int i = 0; i < 400; ++i) {
            CasterHit hit;
            const V3d at(i % 20 * 0.1 - 0.95, i / 20 * 0.1 - 0.95, 0);
            ASSERT_TRUE(caster->intersect(Ray{at - V3d(0, 0, 3), V3d(0, 0, 1)}, hit));
            const bool isThere = spots->opacity(hit.point) > 0;
            EXPECT_EQ(hit.id, !lowerHasHoles || isThere ? 1u : 2u) << at;
            ++(hit.id == 1 ? lower : higher);
        }
        EXPECT_GE(std::min(lower, higher), lowerHasHoles ? 100 : 0);
    }
}

TEST_P(CutCaster, NaNIsAHole) {
    CasterInput input;
    input.shapes = {{sheet(0), 1, true, std::make_shared<EvenCutout>(std::numeric_limits<float>::quiet_NaN())}};
    const auto caster = GetParam()(input);
    CasterHit hit;
    EXPECT_FALSE(caster->intersect(up, hit));
    EXPECT_FALSE(caster->occluded(up));
}

INSTANTIATE_TEST_SUITE_P(Casters, CutCaster,
                         testing::Values(
                             +[](CasterInput input) { return makeEmbreeCaster(std::move(input)); },
                             +[](CasterInput input) { return makeFlatCaster(input); },
                             +[](CasterInput input) { return makeBruteForceCaster(std::move(input)); }));

} // namespace vitrine::test
