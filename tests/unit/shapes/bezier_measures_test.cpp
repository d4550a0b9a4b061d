// Arc length, its inverse, and curvature.
#include "core/random.h"
#include "shapes/quadrature.h"
#include "shapes/revolution/bezier_curve.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

const BezierCurve parabola({{0, 0}, {0.5, 0}, {1, 1}});                 // y = x^2 up to 1
const BezierCurve cusp({{1, -1}, {-1. / 3, 1}, {-1. / 3, -1}, {1, 1}}); // (s^2, s^3) for s = 2t - 1

BezierCurve randomCurve(RandomStream& random, int degree) {
    std::vector<V2d> points;
    for (int i = 0; i <= degree; ++i)
        points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1));
    return BezierCurve(points);
}

TEST(BezierLength, ClosedForms) {
    const auto expectLength = [](const BezierCurve& curve, double ta, double tb, double length) {
        const BezierCurve::Length found = curve.length(ta, tb);
        EXPECT_LE(std::abs(found.value - length), found.error);
        EXPECT_LE(found.error, 1e-12);
    };
    expectLength(BezierCurve({{0, 1}, {3, 5}}), 0, 1, 5);
    expectLength(BezierCurve({{0, 1}, {3, 5}}), 0.2, 0.4, 1);
    expectLength(parabola, 0, 1, std::sqrt(5.) / 2 + std::asinh(2.) / 4);
    const double half = (13 * std::sqrt(13.) - 8) / 27;
    expectLength(cusp, 0, 1, 2 * half);
    expectLength(cusp, 0.5, 1, half);
    expectLength(cusp, 0.25, 1, half + (std::pow(4 + 9 * 0.25, 1.5) - 8) / 27);
    // The corner of the speed between the last node of a panel and its end.
    for (const double before : {1e-2, 3e-3, 1e-3, 1e-4, 1e-6}) {
        const double s = 2 * before;
        expectLength(cusp, 0.5 - before, 1, half + (std::pow(4 + 9 * s * s, 1.5) - 8) / 27);
        expectLength(cusp, 0, 0.5 + before, half + (std::pow(4 + 9 * s * s, 1.5) - 8) / 27);
    }
    // There and back again: the speed has a corner where the curve turns, at t = 1/2.
    expectLength(BezierCurve({{0, 0}, {1, 0}, {0, 0}}), 0, 1, 1);
    expectLength(BezierCurve({{2, 2}, {2, 2}, {2, 2}}), 0, 1, 0);
}

TEST(BezierLength, ErrorIsABound) {
    RandomStream random(31);
    for (int degree = 2; degree <= 40; degree += 2) {
        const BezierCurve curve = randomCurve(random, degree);
        const auto speed = [&](double t) { return curve.evaluate(t).d1.length(); };
        const double fine = integratePanels(speed, 0, 1, 20000);
        const BezierCurve::Length length = curve.length();
        EXPECT_LE(std::abs(length.value - fine), length.error + 20 * degree * eps * fine) << degree;
        EXPECT_LE(length.error, 1e-11 * fine);
        EXPECT_NEAR(curve.length(0, 0.3).value + curve.length(0.3, 1).value, fine, 1e-11 * fine);
    }
}

TEST(BezierLength, SpeedIsExtremeWhereItStopsGrowing) {
    RandomStream random(33);
    for (int degree = 2; degree <= 20; degree += 2) {
        const BezierCurve curve = randomCurve(random, degree);
        std::size_t turns = 0;
        constexpr int steps = 20000;
        const auto speed = [&](int i) { return curve.evaluate(double(i) / steps).d1.length(); };
        for (int i = 1; i < steps; ++i)
            turns += (speed(i) > speed(i - 1)) != (speed(i + 1) > speed(i));
        const std::vector<double> extrema = curve.speedExtrema();
        EXPECT_EQ(extrema.size(), turns) << degree;
        for (const double t : extrema) {
            const CurvePoint c = curve.evaluate(t);
            EXPECT_LT(std::abs(c.d1.dot(c.d2)), 1e-12 * std::pow(degree, 4));
        }
    }
    ASSERT_EQ(cusp.speedExtrema().size(), 1u);
    EXPECT_NEAR(cusp.speedExtrema()[0], 0.5, 1e-15);
    EXPECT_TRUE(BezierCurve({{0, 1}, {3, 5}}).speedExtrema().empty());
}

TEST(BezierLength, ParameterAtLengthIsTheInverse) {
    RandomStream random(32);
    for (int degree = 1; degree <= 30; degree += 3) {
        const BezierCurve curve = randomCurve(random, degree);
        const double total = curve.length().value;
        for (const double part : {0.01, 0.3, 0.5, 0.77, 0.999})
            EXPECT_NEAR(curve.length(0, curve.parameterAtLength(part * total)).value, part * total, 1e-11 * total);
        EXPECT_EQ(curve.parameterAtLength(0), 0);
        EXPECT_EQ(curve.parameterAtLength(-1), 0);
        EXPECT_EQ(curve.parameterAtLength(2 * total), 1);
    }
    EXPECT_NEAR(cusp.parameterAtLength(cusp.length().value / 2), 0.5, 1e-6) << "the speed is zero there";
    EXPECT_NEAR(BezierCurve({{0, 0}, {0, 4}}).parameterAtLength(1), 0.25, eps);
}

TEST(BezierCurvature, ClosedForms) {
    for (const double x : {0., 0.1, 0.5, 1.})
        EXPECT_NEAR(parabola.curvature(x), 2 / std::pow(1 + 4 * x * x, 1.5), 1e-14);
    const BezierCurve back({{1, 1}, {0.5, 0}, {0, 0}});
    EXPECT_NEAR(back.curvature(1), -2, 1e-14) << "turns to the right";
    constexpr double k = 0.5522847498307936;
    const BezierCurve quarter({{1, 0}, {1, k}, {k, 1}, {0, 1}});
    EXPECT_NEAR(quarter.curvature(0), 2. / 3 * (1 - k) / (k * k), 1e-14);
    EXPECT_NEAR(quarter.curvature(1), 2. / 3 * (1 - k) / (k * k), 1e-14);
    for (int i = 1; i < 10; ++i)
        EXPECT_NEAR(quarter.curvature(i / 10.), 1, 0.02);
    EXPECT_EQ(BezierCurve({{0, 0}, {1, 2}}).curvature(0.3), 0);
}

TEST(BezierCurvature, CuspsAndStops) {
    // Before the cusp the curve turns left, after it too: (2s, 3s^2) x (2, 6s) = 6 s^2.
    EXPECT_EQ(cusp.curvature(0.5), infinityD);
    EXPECT_GT(cusp.curvature(0.4999), 1e3);
    EXPECT_GT(cusp.curvature(0.5001), 1e3);
    const BezierCurve mirrored({{1, 1}, {-1. / 3, -1}, {-1. / 3, 1}, {1, -1}});
    EXPECT_EQ(mirrored.curvature(0.5), -infinityD);
    // Coinciding control points at the ends: (3 t^2, ..t^3) as a cusp, seen from either side.
    const BezierCurve stopped({{0, 0}, {0, 0}, {1, 0}, {1, 1}});
    EXPECT_EQ(stopped.curvature(0), infinityD);
    EXPECT_EQ(BezierCurve({{0, 0}, {1, 0}, {1, 1}, {1, 1}}).curvature(1), infinityD);
    EXPECT_EQ(BezierCurve({{1, 1}, {1, 1}, {1, 0}, {0, 0}}).curvature(0), -infinityD);
    // (t^2, t^4): the parabola, begun at rest.
    const BezierCurve atRest({{0, 0}, {0, 0}, {1. / 6, 0}, {0.5, 0}, {1, 1}});
    EXPECT_NEAR(atRest.curvature(0), 2, 1e-12);
    EXPECT_NEAR(atRest.curvature(0.01), 2 / std::pow(1 + 4e-8, 1.5), 1e-9);
    EXPECT_NEAR(BezierCurve({{1, 1}, {0.5, 0}, {1. / 6, 0}, {0, 0}, {0, 0}}).curvature(1), -2, 1e-12);
    // (t, t^3) stands still nowhere; (t^2, t^6) does, and is straight there to the second order.
    const BezierCurve flat({{0, 0}, {0, 0}, {1. / 15, 0}, {0.2, 0}, {0.4, 0}, {2. / 3, 0}, {1, 1}});
    EXPECT_EQ(flat.curvature(0), 0);
    EXPECT_EQ(BezierCurve({{0, 0}, {1, 1}, {0, 0}}).curvature(0.5), 0) << "a line there and back";
}

} // namespace
} // namespace vitrine
