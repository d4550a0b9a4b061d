// Derivatives of normals next to the axis and to cusps, areas and bounds of odd profiles: against closed forms.
#include "shapes/quadrature.h"
#include "shapes/revolution/revolution.h"
#include "support/revolution_cases.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using namespace test;

/// y = x^2, v = x.
const std::vector<V2d> paraboloid{{0, 0}, {0.5, 0}, {1, 1}};
/// (1 + s^2, 1 + s^3) for s = 2t - 1.
const std::vector<V2d> cusp{{2, 0}, {2. / 3, 2}, {2. / 3, 0}, {2, 2}};

Revolution make(const std::vector<V2d>& points, double phiMax = 360, const M44d& matrix = M44d()) {
    return Revolution(Transform(matrix), false, Profile(points, int(points.size()) - 1), phiMax);
}

SurfacePoint pointAt(const Revolution& shape, double u, double v, const M44d& matrix = M44d()) {
    const double phi = u * radians(shape.phiMaxDegrees());
    const V3d beside = Transform(matrix).point(V3d(std::cos(phi), 0, std::sin(phi)));
    return shape.pointAt(Ray{beside, V3d(1, 0, 0)}, PrimitiveHit{0, u, v, 0});
}

void expectNear(const V3f& found, const V3d& expected, double tolerance, const char* what, double at) {
    EXPECT_LE((toDouble(found) - expected).length(), tolerance * (1e-300 + expected.length())) << what << " at " << at;
}

TEST(RevolutionServices, DerivativesUpToThePole) {
    const Revolution shape = make(paraboloid, 300);
    const double turn = radians(300), u = 0.15, c = std::cos(u * turn), s = std::sin(u * turn);
    for (const double x : {1e-30, 1e-12, 1e-8, 1e-5, 1e-3, 0.02, 0.3, 1.}) {
        const SurfacePoint p = pointAt(shape, u, x);
        const double root = std::sqrt(1 + 4 * x * x), cube = root * root * root;
        expectNear(p.ns, V3d(2 * x * c, -1, 2 * x * s) / root, 2e-7, "n", x);
        expectNear(p.dpdu, V3d(-s, 0, c) * (x * turn), 2e-7, "dpdu", x);
        expectNear(p.dpdv, V3d(c, 2 * x, s), 2e-7, "dpdv", x);
        expectNear(p.dndu, V3d(-s, 0, c) * (2 * x / root * turn), 2e-7, "dndu", x);
        expectNear(p.dndv, V3d(2 * c, 4 * x, 2 * s) / cube, 2e-7, "dndv", x);
    }
    const SurfacePoint pole = pointAt(shape, u, 0);
    EXPECT_EQ(pole.dpdu.length(), 0);
    EXPECT_EQ(pole.dndu.length(), 0);
    expectNear(pole.dndv, V3d(2 * c, 0, 2 * s), 2e-7, "dndv", 0);
}

TEST(RevolutionServices, DerivativesUpToTheCusp) {
    const Revolution shape = make(cusp);
    const double u = 0.15, c = std::cos(u * 2 * piD), s = std::sin(u * 2 * piD);
    const auto turned = [&](const V2d& p) { return V3d(p.x * c, p.y, p.x * s); };
    for (const double distance : {0.5, 0.05, 1e-3, 1e-5})
        for (const double sign : {-1., 1.}) {
            const double along = sign * distance;
            const SurfacePoint p = pointAt(shape, u, (along + 1) / 2);
            const double root = std::sqrt(4 + 9 * along * along), angleSpeed = 6 / (root * root);
            const V2d tangent = V2d(2, 3 * along) * (sign / root), normal(tangent.y, -tangent.x);
            // What rounding of the control points does to the direction where the speed is 4 |s|.
            const double tolerance = 1e-6 + 4e-15 / (distance * distance);
            expectNear(p.ns, turned(normal), tolerance, "n", along);
            expectNear(p.dpdv, turned(tangent) * (2 * root * distance), tolerance, "dpdv", along);
            expectNear(p.dndv, turned(tangent) * (2 * angleSpeed * sign * sign), tolerance, "dndv", along);
            expectNear(p.dndu, V3d(-s, 0, c) * (2 * piD * normal.x), 10 * tolerance, "dndu", along);
        }
    const SurfacePoint tip = pointAt(shape, u, 0.5);
    EXPECT_NEAR(std::abs(tip.ns.y), 1, 1e-3);
    EXPECT_TRUE(std::isfinite(tip.dndv.length()) && std::isfinite(tip.dpdv.length()));
}

/// By differences, whichever way the profile is drawn, mirrored, reversed, by either v: the shading normal's derivatives
/// go with the normal that is shown.
TEST(RevolutionServices, NormalDerivativesHoweverItIsDrawn) {
    std::vector<V2d> backwards = joined(gobletProfile());
    std::reverse(backwards.begin(), backwards.end());
    int insideOut = 0, flipped = 0;
    for (const auto& points : {joined(gobletProfile()), backwards})
        for (const bool mirror : {false, true})
            for (const bool reverse : {false, true})
                for (const VMap vmap : {VMap::Parameter, VMap::ArcLength}) {
                    M44d matrix;
                    matrix.rotate(V3d(0.3, 0.7, -0.4));
                    matrix.scale(V3d(mirror ? -1.5 : 1.5, 0.7, 2));
                    const Revolution shape(Transform(matrix), reverse, Profile(points, 3), 360, vmap);
                    insideOut += shape.profile().drawnInsideOut();
                    flipped += !shape.isClosed();
                    const auto at = [&](double u, double v) { return pointAt(shape, u, v, matrix); };
                    const double step = 1e-4;
                    for (const double v : {0.16, 0.31, 0.45, 0.83}) { // within segments, which are eight
                        const double u = 0.15 + v / 2;
                        const SurfacePoint c = at(u, v), up = at(u, v + step), down = at(u, v - step);
                        const double dv = shape.textureV(v + step) - shape.textureV(v - step);
                        const auto difference = [](const V3f& b, const V3f& a, double d) {
                            return (toDouble(b) - toDouble(a)) / d;
                        };
                        const V3d dndu = difference(at(u + step, v).ns, at(u - step, v).ns, 2 * step);
                        const V3d dndv = difference(up.ns, down.ns, dv);
                        EXPECT_GT(dndu.length(), 0.1);
                        EXPECT_GT(dndv.length(), 0.02) << v;
                        EXPECT_LT((toDouble(c.dndu) - dndu).length(), 2e-3 * (1 + dndu.length())) << v;
                        EXPECT_LT((toDouble(c.dndv) - dndv).length(), 2e-3 * (1 + dndv.length())) << v;
                    }
                }
    EXPECT_EQ(insideOut, 8);
    EXPECT_EQ(flipped, 8);
}

TEST(RevolutionServices, AreaWithACusp) {
    const auto integral = [](double w) { return (10. / 27 * std::pow(w, 1.5) + 2. / 45 * std::pow(w, 2.5)) / 18; };
    const double area = 4 * piD * (integral(13) - integral(4));
    EXPECT_NEAR(make(cusp).area(), area, 1e-9 * area);
    EXPECT_NEAR(make(cusp, 90).area(), area / 4, 1e-9 * area);
    // Almost a cusp: (1 + s^2, 1 + s^3 + d s).
    for (const double d : {1e-2, 1e-4, 1e-6}) {
        const std::vector<V2d> points{{2, -d}, {2. / 3, 2 - d / 3}, {2. / 3, d / 3}, {2, 2 + d}};
        const auto ring = [&](double s) { return 2 * piD * (1 + s * s) * std::hypot(2 * s, 3 * s * s + d); };
        double expected = 0, outer = 1;
        for (; outer > 1e-9; outer /= 2) // panels as narrow as the tip is near
            expected += integratePanels(ring, outer / 2, outer, 4) + integratePanels(ring, -outer, -outer / 2, 4);
        EXPECT_NEAR(make(points).area(), expected, 1e-7 * expected) << d;
    }
}

TEST(RevolutionServices, BoundsAreTight) {
    const auto expectBox = [](const Revolution& shape, const V3d& low, const V3d& high) {
        const Box3d box = shape.bounds();
        EXPECT_LE((box.min - low).length() + (box.max - high).length(), 1e-11) << box.min << box.max;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LE(box.min[axis], low[axis]);
            EXPECT_GE(box.max[axis], high[axis]);
        }
    };
    // Control points reach to 2, the curve to 1.5: x = 1 + 2 t (1-t).
    const std::vector<V2d> belly{{1, 0}, {2, 1}, {1, 2}};
    expectBox(make(belly), {-1.5, 0, -1.5}, {1.5, 2, 1.5});
    expectBox(make(belly, 90), {0, 0, 0}, {1.5, 2, 1.5});
    expectBox(make(belly, 180), {-1.5, 0, 0}, {1.5, 2, 1.5});
    expectBox(make(belly, 270), {-1.5, 0, -1.5}, {1.5, 2, 1.5});
    expectBox(make(belly, 30), {std::cos(piD / 6), 0, 0}, {1.5, 2, 0.75});
    // Turned about z by 45 degrees a disk of radius 1 reaches sqrt(1/2) up.
    M44d matrix;
    matrix.rotate(V3d(0, 0, piD / 4));
    const double half = std::sqrt(0.5);
    expectBox(make({{0.2, 0}, {1, 0}}, 360, matrix), {-half, -half, -1}, {half, half, 1});
}

} // namespace
} // namespace vitrine
