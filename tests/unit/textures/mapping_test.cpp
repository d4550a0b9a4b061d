#include "core/random.h"
#include "support/texture_points.h"
#include "textures/mapping.h"

namespace vitrine {
namespace {

const TextureSpace world;

/// A turn about z by 90 degrees (x -> y), then twice as large, then shifted.
TextureSpace movedSpace() {
    return TextureSpace(Transform(M44d(0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 10, 20, 30, 1)));
}

void expectNear(const V2d& found, const V2d& expected, double tolerance = 1e-12) {
    EXPECT_NEAR(found.x, expected.x, tolerance);
    EXPECT_NEAR(found.y, expected.y, tolerance);
}

TEST(UvMapping, ScalesAndShifts) {
    const TexturePoint at = uvAt({0.25f, 0.5f}, {0.1f, 0.2f}, {0, -0.4f});
    const PlanePoint plain = UvMapping().map(at);
    expectNear(plain.st, {0.25, 0.5});
    expectNear(plain.dstdx, V2d(at.duvdx));
    const PlanePoint scaled = UvMapping({4, -2}, {1, 0.125}).map(at);
    expectNear(scaled.st, {2, -0.875});
    expectNear(scaled.dstdx, {0.4, -0.4}, 1e-7);
    expectNear(scaled.dstdy, {0, 0.8}, 1e-7);
    const PlanePoint flat = UvMapping({0, 0}).map(at);
    expectNear(flat.st, {0, 0});
    expectNear(flat.dstdx, {0, 0});
}

TEST(SphericalMapping, HasItsAngles) {
    const SphericalMapping mapping(world);
    const auto st = [&](double x, double y, double z) { return mapping.map(pointAt({x, y, z})).st; };
    expectNear(st(3, 0, 0), {0.5, 0});
    expectNear(st(0, 2, 0), {0.5, 0.25});
    expectNear(st(-1, 0, 0), {0.5, 0.5});
    expectNear(st(0, -1, 0), {0.5, 0.75});
    expectNear(st(1, 0, 1), {0.25, 0});
    expectNear(st(0, 1, -1), {0.75, 0.25});
}

TEST(SphericalMapping, IsDefinedAtThePolesTheSeamAndTheCentre) {
    const SphericalMapping mapping(world);
    expectNear(mapping.map(pointAt({0, 0, 1})).st, {0, 0});
    expectNear(mapping.map(pointAt({0, 0, -1})).st, {1, 0});
    expectNear(mapping.map(pointAt({0, 0, 0})).st, {0, 0});
    const double justBelow = mapping.map(pointAt({1, -1e-300, 0})).st.y;
    EXPECT_LT(justBelow, 1);
    EXPECT_GT(justBelow, 1 - 1e-15);
    // A footprint over a pole sees all angles around it.
    const PlanePoint pole = mapping.map(pointAt({0, 0, 2}, {0.02f, 0, 0}, {0, 0.02f, 0}));
    EXPECT_EQ(pole.dstdx.y, 1);
    EXPECT_EQ(pole.dstdy.y, 1);
    EXPECT_NEAR(pole.dstdx.x, 0.01 / piD, 1e-9);
    const PlanePoint centre = mapping.map(pointAt({0, 0, 0}, {0.02f, 0, 0}));
    EXPECT_TRUE(std::isfinite(centre.dstdx.x) && std::isfinite(centre.dstdx.y));
    // Without a footprint nothing is filtered, there neither.
    for (const double z : {0., 2.})
        expectNear(mapping.map(pointAt({0, 0, z})).dstdx, {0, 0}, 0);
}

TEST(CylindricalMapping, HasItsAngleAndHeight) {
    const CylindricalMapping mapping(world);
    const auto st = [&](double x, double y, double z) { return mapping.map(pointAt({x, y, z})).st; };
    expectNear(st(3, 0, 5), {0.5, 5});
    expectNear(st(0, 2, -4), {0.75, -4});
    expectNear(st(0, -2, 0), {0.25, 0});
    expectNear(st(-1, 1e-300, 0), {1, 0});
    expectNear(st(-1, -1e-300, 0), {0, 0});
    expectNear(st(0, 0, 7), {0.5, 7});
    const PlanePoint axis = mapping.map(pointAt({0, 0, 7}, {0.5f, 0, 0.25f}, {0, 0, 0.125f}));
    expectNear(axis.dstdx, {1, 0.25}, 0);
    expectNear(axis.dstdy, {0, 0.125}, 0);
}

TEST(PlanarMapping, ProjectsAndShifts) {
    const PlanarMapping mapping(world, {1, 0, 0}, {0, -2, 0.5}, {0.25, 4});
    const PlanePoint point = mapping.map(pointAt({3, 1, 8}, {1, 0, 0}, {0, 1, 1}));
    expectNear(point.st, {3.25, 6});
    expectNear(point.dstdx, {1, 0});
    expectNear(point.dstdy, {0, -1.5});
}

TEST(PlanarMapping, KeepsItsPrecisionFarOut) {
    const PlanarMapping mapping(world, {1, 0, 0}, {0, 1, 0}, {0, 0});
    EXPECT_EQ(mapping.map(pointAt({1e9 + 0.125, 0, 0})).st.x, 1e9 + 0.125);
}

TEST(AxisMapping, MeasuresAlongTheAxisInPeriods) {
    const AxisMapping mapping(world, {0, 30, 40}, 2, 0.5);
    const PlanePoint point = mapping.map(pointAt({100, 6, 8}, {1, 0, 0}, {0, 0, 1}));
    expectNear(point.st, {(10 - 0.5) / 2, 0.5});
    expectNear(point.dstdx, {0, 0});
    expectNear(point.dstdy, {0.4, 0});
    const AxisMapping reversed(world, {0, 30, 40}, -2, 0.5);
    expectNear(reversed.map(pointAt({100, 6, 8})).st, {-(10 - 0.5) / 2, 0.5});
    EXPECT_THROW(AxisMapping(world, {0, 0, 0}, 1, 0), std::invalid_argument);
    EXPECT_THROW(AxisMapping(world, {0, 1, 0}, 0, 0), std::invalid_argument);
}

TEST(TextureSpace, IsTheOneItsTransformationMakes) {
    const SpacePoint point = movedSpace().map(pointAt({10, 22, 36}, {0, 2, 0}, {-2, 0, 0}));
    EXPECT_EQ(point.p, V3d(1, 0, 3));
    EXPECT_EQ(point.dpdx, V3d(1, 0, 0));
    EXPECT_EQ(point.dpdy, V3d(0, 1, 0));
    expectNear(SphericalMapping(movedSpace()).map(pointAt({8, 20, 30})).st, {0.5, 0.25});
    expectNear(CylindricalMapping(movedSpace()).map(pointAt({10, 22, 36})).st, {0.5, 3});
    expectNear(AxisMapping(movedSpace(), {1, 0, 0}, 1, 0).map(pointAt({0, 22, 0})).st, {1, 0.5});
}

TEST(TextureSpace, MayMirror) {
    const TextureSpace mirrored(Transform(M44d(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)));
    expectNear(SphericalMapping(mirrored).map(pointAt({3, 0, 0})).st, {0.5, 0.5});
    expectNear(PlanarMapping(mirrored, {1, 0, 0}, {0, 1, 0}, {0, 0}).map(pointAt({3, 4, 0}, {1, 0, 0})).dstdx, {-1, 0});
}

/// What the footprint becomes must be the derivative of where points go. Central differences over 2e-5 of coordinates
/// near 1, away from axis and seam, are good to some 1e-9; the float footprint to 1e-7 of itself.
TEST(Mapping, FootprintsAreDerivatives) {
    const MappingPtr mappings[] = {
        std::make_shared<SphericalMapping>(movedSpace()), std::make_shared<CylindricalMapping>(movedSpace()),
        std::make_shared<PlanarMapping>(movedSpace(), V3d(1, 2, 3), V3d(0, -1, 4), V2d(1, 2)),
        std::make_shared<AxisMapping>(movedSpace(), V3d(1, 2, 3), 0.5, 3)};
    RandomStream random(17);
    for (int i = 0; i < 200; ++i) {
        const double phi = random.uniform(0.1, 1.9 * piD);
        if (std::abs(phi - piD) < 0.1) continue; // the seams, of either mapping
        const double radius = random.uniform(0.5, 2), height = random.uniform(-2, 2);
        const Transform worldFromTexture(M44d(0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 10, 20, 30, 1));
        const V3d p = worldFromTexture.point({radius * std::cos(phi), radius * std::sin(phi), height});
        const V3f dx(float(random.uniform(-1, 1)), float(random.uniform(-1, 1)), float(random.uniform(-1, 1)));
        for (const auto& mapping : mappings) {
            const double h = 1e-5;
            const V2d after = mapping->map(pointAt(p + toDouble(dx) * h)).st;
            const V2d before = mapping->map(pointAt(p - toDouble(dx) * h)).st;
            const PlanePoint point = mapping->map(pointAt(p, dx, dx * 2.f));
            expectNear(point.dstdx, (after - before) / (2 * h), 1e-6);
            expectNear(point.dstdy, point.dstdx * 2., 1e-6);
        }
    }
}

TEST(Mapping, IsFiniteEverywhere) {
    const MappingPtr mappings[] = {std::make_shared<UvMapping>(V2d(1e30, -1e30)),
                                   std::make_shared<SphericalMapping>(world),
                                   std::make_shared<CylindricalMapping>(world),
                                   std::make_shared<PlanarMapping>(world, V3d(1e30, 0, 0), V3d(0, 0, 0), V2d(0, 0)),
                                   std::make_shared<AxisMapping>(world, V3d(1e-30, 0, 0), 1e-30, 1e30)};
    const double extremes[] = {0., -0., 1e-310, -1e-30, 1, -1e30};
    for (const auto& mapping : mappings)
        for (const double x : extremes)
            for (const double y : extremes)
                for (const double z : extremes)
                    for (const float d : {0.f, 1e-40f, 1e30f}) {
                        TexturePoint at = pointAt({x, y, z}, V3f(d, 0, -d), V3f(0, d, 0));
                        at.uv = V2f(float(x), float(y));
                        at.duvdx = at.duvdy = V2f(d, -d);
                        const PlanePoint point = mapping->map(at);
                        for (const V2d& v : {point.st, point.dstdx, point.dstdy})
                            ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.y))
                                << x << " " << y << " " << z << " " << d;
                    }
}

} // namespace
} // namespace vitrine
