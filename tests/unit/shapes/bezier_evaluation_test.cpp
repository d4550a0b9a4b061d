// Both ways to evaluate a Bezier curve against de Casteljau in a hundred digits; bench/bezier_error makes the full table.
#include "core/random.h"
#include "shapes/revolution/bezier_curve.h"
#include "support/exact_bezier.h"
#include "support/revolution_cases.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using namespace test;

constexpr double eps = std::numeric_limits<double>::epsilon();

std::vector<V2d> wildPoints(RandomStream& random, int degree) {
    std::vector<V2d> points;
    for (int i = 0; i <= degree; ++i)
        points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1));
    return points;
}

struct Errors {
    double p, d1, d2;
};

Errors errorsOf(const CurvePoint& c, const std::vector<V2d>& points, double t) {
    return {error(c.p, exactPoint(exactHodograph(points, 0), t)), error(c.d1, exactPoint(exactHodograph(points, 1), t)),
            error(c.d2, exactPoint(exactHodograph(points, 2), t))};
}

void expectWithin(const Errors& errors, const CurvePointError& bound, int degree, double t) {
    EXPECT_LE(errors.p, bound.p) << degree << " " << t;
    EXPECT_LE(errors.d1, bound.d1) << degree << " " << t;
    EXPECT_LE(errors.d2, bound.d2) << degree << " " << t;
}

/// c n eps of the control points, with c = 4 at most: (2n + 2) eps.
TEST(BezierEvaluation, BernsteinErrsByAtMostItsBound) {
    for (const int degree : {1, 2, 3, 4, 5, 7, 10, 14, 20, 30, 45, 60}) {
        RandomStream random(11, degree);
        for (int i = 0; i < 3; ++i) {
            const std::vector<V2d> points = wildPoints(random, degree);
            const BernsteinForm form(points);
            const double size = largest(exactHodograph(points, 0));
            EXPECT_DOUBLE_EQ(form.error().p, (2 * degree + 2) * eps * size);
            for (const double t : {0., 1e-9, 0.5, 1 - 1e-9, 1., random.uniformDouble(), random.uniformDouble()}) {
                const Errors errors = errorsOf(form.evaluate(t), points, t);
                expectWithin(errors, form.error(), degree, t);
                EXPECT_EQ(form.point(t), form.evaluate(t).p);
            }
        }
    }
}

TEST(BezierEvaluation, PowerBasisErrsByAtMostItsBound) {
    double worstAboutEnd = 0;
    for (const int degree : {1, 2, 3, 4, 5, 7, 10, 14, 20, 30}) {
        RandomStream random(12, degree);
        for (int i = 0; i < 3; ++i) {
            const std::vector<V2d> points = wildPoints(random, degree);
            const PowerForm aboutMiddle(points), aboutEnd(points, 0);
            for (const double t : {0., 0.1, 0.5, 1., random.uniformDouble(), random.uniformDouble()}) {
                expectWithin(errorsOf(aboutMiddle.evaluate(t), points, t), aboutMiddle.error(), degree, t);
                const Errors errors = errorsOf(aboutEnd.evaluate(t), points, t);
                expectWithin(errors, aboutEnd.error(), degree, t);
                worstAboutEnd = std::max(worstAboutEnd, errors.p);
            }
        }
    }
    EXPECT_GT(worstAboutEnd, 1e-6) << "why the middle, and why not for every curve";
}

/// Whatever is picked keeps the bound of the stable form.
TEST(BezierEvaluation, TheCurvePicksWhatIsAccurate) {
    int powers = 0, others = 0;
    for (int degree = 1; degree <= 24; ++degree) {
        RandomStream random(13, degree);
        for (int i = 0; i < 4; ++i) {
            const std::vector<V2d> points =
                i == 0 ? joined({randomProfile(random, degree)[0]}) : wildPoints(random, degree);
            const BezierCurve curve(points);
            ++(curve.usesPowerBasis() ? powers : others);
            for (const double t : {0., 0.01, 0.3, 0.99, 1., random.uniformDouble()}) {
                const Errors errors = errorsOf(curve.evaluate(t), points, t);
                EXPECT_LE(errors.p, curve.pointError()) << degree << " " << t;
                const CurvePointError stable = BernsteinForm(points).error();
                EXPECT_LE(errors.d1, 4 * stable.d1) << degree << " " << t;
                EXPECT_LE(errors.d2, 4 * stable.d2) << degree << " " << t;
                EXPECT_EQ(curve.point(t), curve.evaluate(t).p);
            }
            EXPECT_EQ(curve.point(0), points.front());
            EXPECT_EQ(curve.point(1), points.back());
        }
    }
    EXPECT_GE(powers, 12) << "any cubic";
    EXPECT_GE(others, 24) << "nothing wild of a high degree";
    for (const std::vector<V2d>& segment : gobletProfile())
        EXPECT_TRUE(BezierCurve(segment).usesPowerBasis());
    RandomStream random(14);
    EXPECT_FALSE(BezierCurve(wildPoints(random, 12)).usesPowerBasis());
}

/// The radius next to a pole: what densities are divided by.
TEST(BezierEvaluation, VanishingCoordinatesKeepTheirDigits) {
    const std::vector<V2d> points{{0, 1}, {0.4, 1}, {0.5, 0.4}, {0.3, 0.1}};
    const BezierCurve curve(points);
    EXPECT_TRUE(curve.usesPowerBasis());
    for (const double t : {1e-3, 1e-7, 1e-12, 1e-100}) {
        const double x = double(exactPoint(exactHodograph(points, 0), t).x);
        EXPECT_NEAR(curve.point(t).x, x, 16 * eps * x);
    }
}

} // namespace
} // namespace vitrine
