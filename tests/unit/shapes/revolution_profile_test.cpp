// Bezier curves and profiles: evaluation, splitting, what is refused, closedness and orientation.
#include "shapes/revolution/profile.h"
#include "support/revolution_cases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

using namespace test;
using ::testing::HasSubstr;

constexpr double eps = std::numeric_limits<double>::epsilon();

std::vector<V2d> randomPoints(RandomStream& random, int degree) {
    std::vector<V2d> points;
    for (int i = 0; i <= degree; ++i)
        points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1));
    return points;
}

/// De Casteljau in long double.
V2d reference(const std::vector<V2d>& points, long double t) {
    std::vector<std::pair<long double, long double>> c;
    for (const V2d& p : points)
        c.emplace_back(p.x, p.y);
    for (; c.size() > 1; c.pop_back())
        for (std::size_t i = 0; i + 1 < c.size(); ++i)
            c[i] = {(1 - t) * c[i].first + t * c[i + 1].first, (1 - t) * c[i].second + t * c[i + 1].second};
    return V2d(double(c[0].first), double(c[0].second));
}

std::vector<V2d> differences(const std::vector<V2d>& points) {
    std::vector<V2d> d;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        d.push_back((points[i + 1] - points[i]) * double(points.size() - 1));
    return d;
}

std::string refusal(const std::vector<V2d>& points, int degree) {
    try {
        Profile(points, degree);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(BezierCurve, EvaluationIsBackwardStableForEveryDegree) {
    RandomStream random(1);
    for (int degree = 1; degree <= BezierCurve::maxDegree; ++degree) {
        const std::vector<V2d> points = randomPoints(random, degree);
        const BezierCurve curve(points);
        const double bound = 8 * degree * eps;
        for (int i = 0; i <= 40; ++i) {
            const double t = i / 40.;
            const CurvePoint c = curve.evaluate(t);
            EXPECT_LE((c.p - reference(points, t)).length(), bound) << degree << " " << t;
            EXPECT_LE((c.d1 - reference(differences(points), t)).length(), bound * 4 * degree) << degree << " " << t;
            if (degree > 1) {
                const V2d second = reference(differences(differences(points)), t);
                EXPECT_LE((c.d2 - second).length(), bound * 16 * degree * degree) << degree << " " << t;
            }
        }
        EXPECT_EQ(curve.point(0), points.front());
        EXPECT_EQ(curve.point(1), points.back());
    }
}

TEST(BezierCurve, PartsLieOnTheCurveAndShareTheirEnds) {
    RandomStream random(2);
    for (int degree = 1; degree <= 60; degree += 7) {
        const BezierCurve curve(randomPoints(random, degree));
        const double ta = random.uniform(0, 0.5), tb = random.uniform(0.5, 1);
        const BezierCurve part = curve.part(ta, tb);
        const auto [left, right] = curve.split(ta);
        EXPECT_EQ(left.last(), right.first());
        for (int i = 0; i <= 10; ++i)
            EXPECT_LE((part.point(i / 10.) - curve.point(lerp(i / 10., ta, tb))).length(), 64 * degree * eps);
    }
}

TEST(BezierCurve, FindsEveryExtremum) {
    RandomStream random(3);
    for (int degree = 2; degree <= 30; degree += 4) {
        const BezierCurve curve(randomPoints(random, degree));
        for (int axis = 0; axis < 2; ++axis) {
            std::size_t turns = 0;
            constexpr int steps = 5000;
            for (int i = 1; i < steps; ++i) {
                const double a = curve.point((i - 1.) / steps)[axis], b = curve.point(double(i) / steps)[axis];
                const double c = curve.point((i + 1.) / steps)[axis];
                turns += (b > a) != (c > b);
            }
            const std::vector<double> extrema = curve.extrema(axis);
            EXPECT_EQ(extrema.size(), turns) << degree;
            for (const double t : extrema)
                EXPECT_LT(std::abs(curve.evaluate(t).d1[axis]), 1e-12 * degree * degree);
        }
    }
}

TEST(BezierCurve, AreaUnderACubicQuarterCircle) {
    constexpr double k = 0.5522847498307936;
    const BezierCurve quarter({{1, 0}, {1, k}, {k, 1}, {0, 1}});
    // Green's theorem by the trapezoid rule.
    double sum = 0;
    constexpr int steps = 200000;
    for (int i = 0; i < steps; ++i) {
        const V2d a = quarter.point(double(i) / steps), b = quarter.point((i + 1.) / steps);
        sum += (a.x + b.x) / 2 * (b.y - a.y);
    }
    EXPECT_NEAR(quarter.areaUnder(), sum, 1e-10);
}

TEST(Profile, RefusesWhatIsNoProfile) {
    EXPECT_THAT(refusal({{1, 0}, {1, 1}, {1, 2}}, 0), HasSubstr("1 to 60, not 0"));
    EXPECT_THAT(refusal({{1, 0}, {1, 1}, {1, 2}}, 61), HasSubstr("1 to 60, not 61"));
    EXPECT_THAT(refusal({{1, 0}, {1, 1}, {1, 2}, {1, 3}}, 2), HasSubstr("needs 1 + 2 k control points"));
    EXPECT_THAT(refusal({{1, 0}}, 1), HasSubstr("not 1"));
    EXPECT_THAT(refusal({{1, 0}, {NAN, 1}}, 1), HasSubstr("not finite"));
    EXPECT_THROW(Profile(std::vector<BezierCurve>{}), std::invalid_argument);
    EXPECT_THROW(Profile({BezierCurve({{1, 0}, {1, 1}}), BezierCurve({{2, 1}, {1, 1}})}), std::invalid_argument);
}

TEST(Profile, RefusesANegativeRadiusAndSaysWhere) {
    // x(t) of the second segment is 1 - 6 t + 6 t^2: least at 1/2, where it is -1/2.
    const std::string message = refusal({{1, 0}, {1, .5}, {1, 1}, {-2, 1.5}, {1, 2}}, 2);
    EXPECT_THAT(message, HasSubstr("segment 1"));
    EXPECT_THAT(message, HasSubstr("-0.5"));
    EXPECT_THAT(message, HasSubstr("t = 0.5"));
    EXPECT_THAT(refusal({{-1, 0}, {1, 1}}, 1), HasSubstr("t = 0"));
}

TEST(Profile, AcceptsNegativeControlPointsOfANonNegativeRadius) {
    EXPECT_EQ(refusal({{1, 0}, {-0.9, 0.5}, {1, 1}}, 2), "");
    EXPECT_EQ(refusal({{1, 0}, {-1, 0.5}, {1, 1}}, 2), ""); // touches the axis
    EXPECT_NE(refusal({{1, 0}, {-1.0001, 0.5}, {1, 1}}, 2), "");
}

TEST(Profile, IsClosedWhenItBoundsASolid) {
    const auto closed = [](const std::vector<V2d>& points, int degree) { return Profile(points, degree).isClosed(); };
    EXPECT_TRUE(closed({{0, -1}, {1, 0}, {0, 1}}, 1));
    EXPECT_TRUE(closed({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 3));
    EXPECT_TRUE(closed({{1, 0}, {2, 0}, {2, 1}, {1, 0}}, 1)); // a ring
    EXPECT_FALSE(closed({{0, 0}, {1, 0}, {1, 1}}, 1));        // a bowl without thickness
    EXPECT_FALSE(closed({{1, 0}, {1, 1}}, 1));
    EXPECT_FALSE(closed({{1, 0}, {2, 0}, {2, 1}, {1, 0.001}}, 1));
    EXPECT_TRUE(Profile(joined(gobletProfile()), 3).isClosed());
    EXPECT_FALSE(Profile(joined(vaseProfile()), 8).isClosed());
}

TEST(Profile, KnowsWhenASolidIsDrawnInsideOut) {
    std::vector<V2d> goblet = joined(gobletProfile());
    const Profile drawn(goblet, 3);
    std::reverse(goblet.begin(), goblet.end());
    EXPECT_NE(drawn.drawnInsideOut(), Profile(goblet, 3).drawnInsideOut());
    EXPECT_FALSE(Profile(std::vector<V2d>{{0, -1}, {1, 0}, {0, 1}}, 1).drawnInsideOut());
    EXPECT_TRUE(Profile(std::vector<V2d>{{0, 1}, {1, 0}, {0, -1}}, 1).drawnInsideOut());
    EXPECT_FALSE(Profile(std::vector<V2d>{{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0}}, 1).drawnInsideOut());
}

TEST(Profile, PartsAreMonotoneAndJoin) {
    for (int degree = 1; degree <= 60; ++degree) {
        RandomStream random(4, degree);
        const ProfilePoints points = randomProfile(random, degree);
        const Profile profile(joined(points), degree);
        const std::vector<ProfilePart>& parts = profile.parts();
        EXPECT_EQ(parts.front().v0, 0);
        EXPECT_EQ(parts.back().v1, 1);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (i > 0) {
                EXPECT_EQ(parts[i - 1].curve.last(), parts[i].curve.first());
                EXPECT_EQ(parts[i - 1].v1, parts[i].v0);
            }
            const V2d &a = parts[i].curve.first(), &b = parts[i].curve.last();
            EXPECT_EQ(profile.partAt((parts[i].v0 + parts[i].v1) / 2), i);
            for (int k = 0; k <= 20; ++k) {
                const V2d p = parts[i].curve.point(k / 20.);
                EXPECT_LE((p - profile.evaluate(lerp(k / 20., parts[i].v0, parts[i].v1)).p).length(), 1e-13 * degree);
                for (int axis = 0; axis < 2; ++axis) {
                    EXPECT_GE(p[axis], std::min(a[axis], b[axis]) - 1e-14 * degree);
                    EXPECT_LE(p[axis], std::max(a[axis], b[axis]) + 1e-14 * degree);
                }
            }
        }
    }
}

} // namespace
} // namespace vitrine
