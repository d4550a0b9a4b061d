// Degree elevation and reduction, tight bounds, hodographs.
#include "core/random.h"
#include "shapes/quadrature.h"
#include "shapes/revolution/bezier_curve.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

BezierCurve randomCurve(RandomStream& random, int degree) {
    std::vector<V2d> points;
    for (int i = 0; i <= degree; ++i)
        points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1));
    return BezierCurve(points);
}

double farthest(const BezierCurve& a, const BezierCurve& b) {
    double distance = 0;
    for (int i = 0; i <= 400; ++i)
        distance = std::max(distance, (a.point(i / 400.) - b.point(i / 400.)).length());
    return distance;
}

TEST(BezierDegree, ElevationChangesNothing) {
    RandomStream random(21);
    for (const int degree : {1, 2, 3, 8, 20, 40}) {
        const BezierCurve curve = randomCurve(random, degree);
        for (const int higher : {degree, degree + 1, degree + 7, 60}) {
            const BezierCurve elevated = curve.elevated(higher);
            EXPECT_EQ(elevated.degree(), higher);
            EXPECT_LE(farthest(curve, elevated), 16 * higher * eps);
        }
    }
    EXPECT_THROW(randomCurve(random, 5).elevated(4), std::invalid_argument);
    EXPECT_THROW(randomCurve(random, 5).elevated(61), std::invalid_argument);
}

TEST(BezierDegree, ReductionUndoesElevation) {
    RandomStream random(22);
    for (const int degree : {1, 2, 3, 6, 12, 25})
        for (const int higher : {degree + 1, degree + 4, 2 * degree + 8}) {
            const BezierCurve curve = randomCurve(random, degree);
            const BezierCurve::Reduced reduced = curve.elevated(higher).reduced(degree);
            EXPECT_EQ(reduced.curve.degree(), degree);
            EXPECT_LE(farthest(curve, reduced.curve), 64 * higher * eps) << degree << " " << higher;
            EXPECT_LE(reduced.error, 64 * higher * eps);
        }
}

TEST(BezierDegree, ReductionKeepsItsBoundAndTheEnds) {
    RandomStream random(23);
    for (int degree = 2; degree <= 40; degree += 3)
        for (int lower = 1; lower < degree; lower += 1 + degree / 4) {
            const BezierCurve curve = randomCurve(random, degree);
            const BezierCurve::Reduced reduced = curve.reduced(lower);
            EXPECT_EQ(reduced.curve.first(), curve.first());
            EXPECT_EQ(reduced.curve.last(), curve.last());
            const double distance = farthest(curve, reduced.curve);
            EXPECT_LE(distance, reduced.error) << degree << " to " << lower;
            EXPECT_LE(reduced.error, 2.5 * distance) << degree << " to " << lower;
        }
    EXPECT_THROW(randomCurve(random, 5).reduced(5), std::invalid_argument);
    EXPECT_THROW(randomCurve(random, 5).reduced(0), std::invalid_argument);
}

/// Nearest in the mean square: the difference is at right angles to whatever could be added, which is t (1-t) times any
/// polynomial of degree m - 2.
TEST(BezierDegree, ReductionIsTheLeastSquaresOne) {
    RandomStream random(24);
    for (const int degree : {3, 5, 9, 16})
        for (int lower = 2; lower < degree; ++lower) {
            const BezierCurve curve = randomCurve(random, degree), reduced = curve.reduced(lower).curve;
            double size = 0; // of control points, which a lower degree throws far out
            for (const V2d& p : reduced.points())
                size = std::max(size, p.length());
            for (int axis = 0; axis < 2; ++axis)
                for (int j = 0; j <= lower - 2; ++j) {
                    const auto product = [&](double t) {
                        const double difference = curve.point(t)[axis] - reduced.point(t)[axis];
                        return difference * t * (1 - t) * std::cos(j * std::acos(2 * t - 1)); // Chebyshev: independent
                    };
                    EXPECT_NEAR(integratePanels(product, 0, 1, 32), 0, 16 * degree * eps * size)
                        << degree << " " << lower << " " << j;
                }
        }
}

TEST(BezierCurve, BoundsAreTight) {
    RandomStream random(25);
    for (int degree = 1; degree <= 40; degree += 3) {
        const BezierCurve curve = randomCurve(random, degree);
        const Imath::Box2d box = curve.bounds();
        Imath::Box2d sampled;
        for (int i = 0; i <= 20000; ++i)
            sampled.extendBy(curve.point(i / 20000.));
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_NEAR(box.min[axis], sampled.min[axis], 1e-6);
            EXPECT_NEAR(box.max[axis], sampled.max[axis], 1e-6);
            EXPECT_LE(box.min[axis], sampled.min[axis] + 4 * degree * eps);
            EXPECT_GE(box.max[axis], sampled.max[axis] - 4 * degree * eps);
        }
        const Imath::Box2d hull = curve.controlBounds();
        EXPECT_TRUE(degree == 1 || hull.size().x * hull.size().y > box.size().x * box.size().y);
    }
}

TEST(BezierCurve, HodographIsTheDerivative) {
    RandomStream random(26);
    for (const int degree : {1, 2, 3, 9, 30}) {
        const BezierCurve curve = randomCurve(random, degree), hodograph = curve.derivative();
        EXPECT_EQ(hodograph.degree(), std::max(1, degree - 1));
        for (int i = 0; i <= 20; ++i) {
            const CurvePoint c = curve.evaluate(i / 20.), d = hodograph.evaluate(i / 20.);
            EXPECT_LE((c.d1 - d.p).length(), 16 * degree * degree * eps);
            if (degree > 1) {
                EXPECT_LE((c.d2 - d.d1).length(), 64 * degree * degree * degree * eps);
            }
        }
    }
}

} // namespace
} // namespace vitrine
