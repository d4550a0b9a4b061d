// The shape `Revolution`: special rays, normals, parameters, bounds, area.
#include "shapes/revolution/revolution.h"
#include "support/revolution_cases.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using namespace test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Revolution make(const std::vector<V2d>& points, int degree = 0, double phiMax = 360, bool reverse = false,
                const M44d& matrix = M44d()) {
    return Revolution(Transform(matrix), reverse, Profile(points, degree ? degree : int(points.size()) - 1), phiMax);
}

std::vector<double> crossings(const Revolution& shape, const V3d& o, const V3d& d) {
    std::vector<double> result;
    for (const PrimitiveHit& hit : shape.allHits(Ray{o, d}, -infinityD, infinityD))
        result.push_back(hit.s);
    return result;
}

/// The closest hit over all primitives, as the ray caster finds it.
std::optional<SurfacePoint> closest(const Revolution& shape, const Ray& ray, PrimitiveHit* found = nullptr) {
    PrimitiveHit best, hit;
    for (unsigned prim = 0; prim < shape.primitiveCount(); ++prim)
        if (shape.intersect(prim, ray, 0, best.s, hit)) best = hit;
    if (!(best.s < infinityD)) return std::nullopt;
    if (found) *found = best;
    return shape.pointAt(ray, best);
}

void expectCrossings(const Revolution& shape, const V3d& o, const V3d& d, const std::vector<double>& expected) {
    const std::vector<double> s = crossings(shape, o, d);
    ASSERT_EQ(s.size(), expected.size()) << o << " " << d;
    for (std::size_t i = 0; i < s.size(); ++i)
        EXPECT_NEAR(s[i], expected[i], 1e-14 * (1 + std::abs(expected[i]))) << o << " " << d;
}

const std::vector<V2d> can{{0, 0}, {1, 0}, {1, 2}, {0, 2}}; // a closed cylinder, as three lines

TEST(Revolution, ClosedCylinderFromEverySide) {
    const Revolution shape = make(can, 1);
    expectCrossings(shape, {-3, 1, 0}, {1, 0, 0}, {2, 4});          // horizontal
    expectCrossings(shape, {-3, 1, 0}, {1, 1e-9, 0}, {2, 4});       // nearly
    expectCrossings(shape, {0.5, -3, 0.25}, {0, 2, 0}, {1.5, 2.5}); // vertical, through the flat ends
    expectCrossings(shape, {0, -3, 0}, {0, 1, 0}, {3, 5});          // on the axis, through both poles
    expectCrossings(shape, {0, -3, 0}, {1e-12, 1, 0}, {3, 5});
    expectCrossings(shape, {-2, -1, 0}, {1, 1, 0}, {1, 3});  // rim to rim
    expectCrossings(shape, {-2, 1, 0}, {1, 0.5, 0}, {1, 2}); // through the upper pole from below
    expectCrossings(shape, {-3, 1, 0.6}, {1, 0, 0}, {2.2, 3.8});
    EXPECT_TRUE(crossings(shape, {-3, 1, 1.5}, {1, 0, 0}).empty());
    EXPECT_TRUE(crossings(shape, {-3, 2.5, 0}, {1, 0, 0}).empty());
    EXPECT_TRUE(crossings(shape, {1.5, -3, 0}, {0, 1, 0}).empty());
}

TEST(Revolution, RaysInTheSurfaceMeetItAnEvenNumberOfTimes) {
    const Revolution shape = make(can, 1);
    EXPECT_EQ(crossings(shape, {-3, 2, 0}, {1, 0, 0}).size() % 2, 0u); // in the plane of the top
    EXPECT_EQ(crossings(shape, {-3, 0, 0.3}, {1, 0, 0}).size() % 2, 0u);
    EXPECT_EQ(crossings(shape, {1, -3, 0}, {0, 1, 0}).size() % 2, 0u); // along the wall
    EXPECT_EQ(crossings(shape, {1, 1, -3}, {0, 0, 1}).size() % 2, 0u); // touching the wall
}

TEST(Revolution, NearlyHorizontalRaysSeeAFlatRim) {
    const Revolution shape = make({{0.2, 1}, {0.5, 1}, {0.7, 1}, {1, 1}}); // an annulus as a cubic
    for (const double slope : {1e-1, 1e-3, 1e-6, 1e-9}) {
        // Falls through y = 1 at x = -0.6, then at 0 (the hole).
        // What rounding of y does to s on the way down is eps / slope.
        const double y = 1 + 2.4 * slope;
        const std::vector<double> s = crossings(shape, {-3, y, 0}, {1, -slope, 0});
        ASSERT_EQ(s.size(), 1u) << slope;
        EXPECT_NEAR(s[0], (y - 1) / slope, 1e-14 + 1e-15 / slope);
        EXPECT_TRUE(crossings(shape, {-3, 1 + 3 * slope, 0}, {1, -slope, 0}).empty()) << slope;
    }
    EXPECT_TRUE(crossings(shape, {-3, 1, 0}, {1, 0, 0}).empty()) << "a ray in the annulus's plane";
}

TEST(Revolution, ConeApexFromAllDirections) {
    const Revolution shape = make({{1, 0}, {0, 1}});
    expectCrossings(shape, {0, 3, 0}, {0, -1, 0}, {2});
    expectCrossings(shape, {0, 3, 0}, {1e-9, -1, 0}, {2 + 2e-9});
    expectCrossings(shape, {0.25, 3, 0}, {0, -1, 0}, {2.25});
    EXPECT_EQ(crossings(shape, {-3, 1, 0}, {1, 0, 0}).size() % 2, 0u);
    expectCrossings(shape, {-3, 0.75, 0}, {1, 0, 0}, {2.75, 3.25});
    expectCrossings(shape, {-3, 1 - 1e-9, 0}, {1, 0, 0}, {3 - 1e-9, 3 + 1e-9});
}

TEST(Revolution, UnusableRaysMeetNothing) {
    const Revolution shape = make(joined(gobletProfile()), 3);
    for (const V3d& d : {V3d(0, 0, 0), V3d(nan, 0, 1), V3d(infinityD, 0, 0), V3d(0, -infinityD, 1)})
        EXPECT_TRUE(crossings(shape, {-3, 0.9, 0}, d).empty());
    for (const V3d& o : {V3d(nan, 0, 0), V3d(0, infinityD, 0), V3d(1e300, 0, 0)})
        EXPECT_TRUE(crossings(shape, o, {1, 0, 0}).empty());
    EXPECT_EQ(crossings(shape, {-3, 0.9, 0}, {1e-140, 0, 0}).size(), 4u);
    EXPECT_EQ(crossings(shape, {-3, 0.9, 0}, {1e140, 0, 0}).size(), 4u);
}

TEST(Revolution, TheIntervalIsOpen) {
    const Revolution shape = make(can, 1);
    const Ray ray{{-3, 1, 0}, {1, 0, 0}};
    PrimitiveHit hit;
    unsigned found = 0;
    for (unsigned prim = 0; prim < shape.primitiveCount(); ++prim) {
        EXPECT_FALSE(shape.intersect(prim, ray, 2, 4, hit));
        EXPECT_FALSE(shape.occludes(prim, ray, 2, 4));
        EXPECT_EQ(shape.occludes(prim, ray, 1.9, 4), shape.intersect(prim, ray, 1.9, 4, hit));
        found += shape.occludes(prim, ray, 0, 2.5);
    }
    EXPECT_EQ(found, 1u);
}

TEST(Revolution, PhiMaxCutsTheTurnAndScalesU) {
    const Revolution half = make(can, 1, 180); // z >= 0
    EXPECT_EQ(crossings(half, {0.1, 1, -3}, {0, 0, 1}).size(), 1u);
    EXPECT_EQ(crossings(half, {-3, 1, 0.1}, {1, 0, 0}).size(), 2u);
    EXPECT_FALSE(half.isClosed());
    PrimitiveHit hit;
    const Ray ray{{0, 1, 3}, {0, 0, -1}};
    ASSERT_TRUE(closest(half, ray, &hit));
    EXPECT_NEAR(hit.u, 0.5, 1e-12);
    EXPECT_NEAR(half.area(), make(can, 1).area() / 2, 1e-12);
    EXPECT_THROW(make(can, 1, 0), std::invalid_argument);
    EXPECT_THROW(make(can, 1, nan), std::invalid_argument);
}

TEST(Revolution, ParametersFollowTheProfile) {
    const Revolution shape = make(can, 1);
    PrimitiveHit hit;
    const auto point = closest(shape, Ray{{0, 0.5, 3}, {0, 0, -1}}, &hit);
    ASSERT_TRUE(point);
    EXPECT_NEAR(hit.u, 0.25, 1e-12);
    EXPECT_NEAR(hit.v, (1 + 0.25) / 3, 1e-12);
    EXPECT_NEAR((point->p - V3d(0, 0.5, 1)).length(), 0, 1e-14);
}

TEST(Revolution, NormalsOfASolidPointOutHoweverItWasDrawn) {
    std::vector<V2d> points = joined(gobletProfile());
    for (const bool reversed : {false, true}) {
        if (reversed) std::reverse(points.begin(), points.end());
        const Revolution shape = make(points, 3);
        EXPECT_TRUE(shape.isClosed());
        RandomStream random(5);
        for (int i = 0; i < 300; ++i) {
            const V3d target(random.uniform(-0.4, 0.4), random.uniform(0, 1.3), random.uniform(-0.4, 0.4));
            const Ray ray{{3, random.uniform(-1, 3), 1}, target - V3d(3, 1, 1)};
            const std::vector<PrimitiveHit> hits = shape.allHits(ray, -infinityD, infinityD);
            for (std::size_t k = 0; k < hits.size(); ++k) {
                const double along = toDouble(shape.pointAt(ray, hits[k]).ng).dot(ray.d);
                EXPECT_EQ(along < 0, k % 2 == 0) << "crossing " << k << " of " << hits.size();
            }
        }
    }
}

TEST(Revolution, OpenProfilesHaveTheNormalOfTheirDirection) {
    const auto normalAt = [](const Revolution& shape) { return closest(shape, Ray{{3, 1, 0}, {-1, 0, 0}})->ng; };
    EXPECT_GT(normalAt(make({{1, 0}, {1, 2}})).x, 0.99f); // upwards: (y', -x') points away from the axis
    EXPECT_LT(normalAt(make({{1, 2}, {1, 0}})).x, -0.99f);
    EXPECT_LT(normalAt(make({{1, 0}, {1, 2}}, 1, 360, true)).x, -0.99f);
    EXPECT_LT(normalAt(make(can, 1, 360, true)).x, -0.99f);
    EXPECT_FALSE(make(can, 1, 360, true).isClosed()) << "its normals point into the solid";
    // A solid that is mirrored stays a solid.
    M44d mirror;
    mirror[2][2] = -1;
    EXPECT_GT(normalAt(make({{1, 0}, {1, 2}}, 1, 360, false, mirror)).x, 0.99f);
    EXPECT_LT(normalAt(make({{1, 0}, {1, 2}}, 1, 360, true, mirror)).x, -0.99f);
}

TEST(Revolution, PolesAndCuspsHaveANormal) {
    const Revolution shape = make({{0, 0}, {0, 0}, {1, 0.5}, {1, 1}, {0, 1}, {0, 1}});
    const auto top = closest(shape, Ray{{0, 3, 0}, {0, -1, 0}});
    const auto bottom = closest(shape, Ray{{0, -3, 0}, {0, 1, 0}});
    ASSERT_TRUE(top && bottom);
    EXPECT_NEAR(top->ng.length(), 1, 1e-6);
    EXPECT_NEAR(bottom->ng.length(), 1, 1e-6);
    EXPECT_GT(top->ng.y, 0.9f);
    EXPECT_LT(bottom->ng.y, 0);
    EXPECT_TRUE(std::isfinite(top->dndv.length()));
}

TEST(Revolution, DerivativesAreThoseOfThePoints) {
    M44d matrix;
    matrix.rotate(V3d(0.3, 0.7, -0.4));
    matrix.scale(V3d(1.5, 0.7, 2));
    matrix.translate(V3d(3, -1, 2));
    const Revolution shape = make(joined(vaseProfile()), 8, 300, false, matrix);
    const auto at = [&](double u, double v) {
        const double phi = u * radians(300);
        const Ray ray{Transform(matrix).point(V3d(std::cos(phi), 0, std::sin(phi))), V3d(1, 0, 0)};
        return shape.pointAt(ray, PrimitiveHit{0, u, v, 0});
    };
    constexpr double step = 1e-3;
    for (const double u : {0.1, 0.6})
        for (const double v : {0.15, 0.5, 0.83}) {
            const SurfacePoint c = at(u, v);
            const auto expectNear = [](const V3f& d, const V3d& difference) {
                EXPECT_LT((toDouble(d) - difference / (2 * step)).length(), 2e-3 * (1 + d.length()));
            };
            expectNear(c.dpdu, at(u + step, v).p - at(u - step, v).p);
            expectNear(c.dpdv, at(u, v + step).p - at(u, v - step).p);
            expectNear(c.dndu, toDouble(at(u + step, v).ns) - toDouble(at(u - step, v).ns));
            expectNear(c.dndv, toDouble(at(u, v + step).ns) - toDouble(at(u, v - step).ns));
            EXPECT_NEAR(c.ng.dot(c.dpdu.normalized()), 0, 1e-6);
            EXPECT_NEAR(c.ng.dot(c.dpdv.normalized()), 0, 1e-6);
            EXPECT_EQ(c.uv, V2f(float(u), float(v)));
        }
}

TEST(Revolution, AreasInClosedForm) {
    EXPECT_NEAR(make({{1, 0}, {1, 2}}).area(), 4 * piD, 1e-9);             // cylinder
    EXPECT_NEAR(make({{1, 0}, {0, 1}}).area(), piD * std::sqrt(2.), 1e-9); // cone
    EXPECT_NEAR(make({{0.5, 1}, {1, 1}}).area(), piD * 0.75, 1e-9);        // annulus
    EXPECT_NEAR(make({{0.5, 1}, {0.6, 1}, {0.9, 1}, {1, 1}}).area(), piD * 0.75, 1e-9);
    EXPECT_NEAR(make(can, 1).area(), 6 * piD, 1e-9);
    // Paraboloid y = x^2 up to x = 1.
    EXPECT_NEAR(make({{0, 0}, {0.5, 0}, {1, 1}}).area(), piD / 6 * (5 * std::sqrt(5.) - 1), 1e-9);
    M44d larger;
    larger.scale(V3d(3));
    EXPECT_NEAR(make(can, 1, 360, false, larger).area(), 54 * piD, 1e-8);
    // A cylinder squeezed to an ellipse: perimeter by Ramanujan's second series is exact to 1e-10 here.
    M44d squeeze;
    squeeze.scale(V3d(1, 1, 0.8));
    const double a = 1, b = 0.8, x = sqr((a - b) / (a + b));
    const double perimeter = piD * (a + b) * (1 + 3 * x / (10 + std::sqrt(4 - 3 * x)));
    EXPECT_NEAR(make({{1, 0}, {1, 2}}, 1, 360, false, squeeze).area(), 2 * perimeter, 1e-8);
    EXPECT_THROW(make({{0, 0}, {0, 1}}), std::invalid_argument) << "no area";
}

TEST(Revolution, BoundsHoldEveryPoint) {
    RandomStream random(6);
    M44d matrix;
    matrix.rotate(V3d(0.5, -0.2, 0.9));
    matrix.translate(V3d(1e3, 2, -7));
    for (const double phiMax : {360., 200., 70.}) {
        const Revolution shape = make(joined(gobletProfile()), 3, phiMax, false, matrix);
        const Box3d box = shape.bounds();
        V3d low(infinityD), high(-infinityD);
        for (int i = 0; i < 4000; ++i) {
            const auto drawn = shape.sample(V2f(random.uniform(), random.uniform()));
            ASSERT_TRUE(drawn);
            EXPECT_TRUE(box.intersects(drawn->point.p));
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], drawn->point.p[axis]);
                high[axis] = std::max(high[axis], drawn->point.p[axis]);
            }
        }
        if (phiMax == 360) {
            EXPECT_LT((box.min - low).length() + (box.max - high).length(), 0.1) << "tight for a full turn";
        }
    }
}

/// Next to the closest approach the branches of the hyperbola bend sharply: a step that looks like the last may not be.
TEST(Revolution, NearlyHorizontalRayThatAllButTouchesIsMetExactly) {
    const std::vector<V2d> profile{{0.32072562123020149, 0.045378254765203963},
                                   {0, 0.71181637172692813},
                                   {0.29999999999999999, 0.12243975810903707},
                                   {0.32072562123020149, 0.045378254765203963}};
    const Ray ray{V3d(-0.27641405832668969, 0.085993848404613771, 0.13990212996916174),
                  V3d(-0.22451915904748923, -0.00030886091944547559, -0.97446962591223985)};
    const auto hits = make(profile, 1).allHits(ray, 1e-6, 0.09);
    ASSERT_EQ(hits.size(), 1u);
    const V3d p = ray.at(hits[0].s);
    const double t = 3 * hits[0].v;
    EXPECT_NEAR(p.y, lerp(t, profile[0].y, profile[1].y), 1e-15);
    EXPECT_NEAR(std::hypot(p.x, p.z), lerp(t, profile[0].x, profile[1].x), 1e-15);
}

/// The ray goes through the pole at s = 1, where rounding of its height makes two roots that hide the part's true ones.
TEST(Revolution, RaysThroughAPoleMissNothingBesideIt) {
    const std::vector<V2d> profile{{0.92743960669910774, 0.24046463273325025},
                                   {0.043823462572836314, 0.31488917806970845},
                                   {0.34719696475145834, 0.25300262472875457},
                                   {0.043962553138525373, 0.5271305203177532},
                                   {0.50937299968449878, 0.37333209824359875},
                                   {0.62824061826681055, 0.34382526071345199},
                                   {0.16001550921229235, 0.37452698080859392},
                                   {0.29125560703034792, 0.47659989919609297},
                                   {0.96251771655566154, 0.57110176079050035},
                                   {0.85894601687022243, 0.49003968152879201},
                                   {0.29806806980187184, 0.70209712621023235},
                                   {0.091984051562289726, 0.62053281991310161},
                                   {0, 0.64818987051449906}};
    const V3d o(-0.93901118277696771, 0.73050618090819985, 0), d(0.93901118277696771, -0.082316310393700798, 0);
    expectCrossings(make(profile), o, d, {1.0876519564699549, 1.3519950711369522}); // by exact integers
}

/// Stepping from hit to hit.
std::vector<double> walked(const Revolution& shape, const Ray& ray) {
    std::vector<double> met;
    for (double s = -infinityD; s < infinityD;) {
        PrimitiveHit best, hit;
        for (unsigned prim = 0; prim < shape.primitiveCount(); ++prim)
            if (shape.intersect(prim, ray, s, best.s, hit)) best = hit;
        s = best.s;
        if (s < infinityD) met.push_back(s);
    }
    return met;
}

/// Touches: the later crossing in the profile, or on the hyperbola's forward half, is the nearer by a rounding; of a ray that
/// is all but horizontal by a rounding divided by its slope.
TEST(Revolution, SteppingFromHitToHitMeetsBothCrossingsOfATouch) {
    const Revolution goblet = make(joined(gobletProfile()), 3);
    for (const Ray& ray : {Ray{{-2.1904671606002726, 1.1606747273901137, -2.2759817068699171},
                               {0.59875316245398003, 0.012512714677923503, 0.80083586484544178}},
                           Ray{{-0.81709932942860741, 0.22356849576430923, 0.25375804662094859},
                               {0.93688822061859445, -7.7377928727837827e-07, -0.34962903492920205}},
                           Ray{{0.10771642709077182, 0.55943561154782107, -0.25048950632596373},
                               {0.11697664462405684, 1.1039488533316268e-07, 0.99313466590009081}}}) {
        const std::vector<double> all = crossings(goblet, ray.o, ray.d);
        ASSERT_EQ(all.size(), 2u);
        ASSERT_LT(all[0], all[1]);
        EXPECT_EQ(walked(goblet, ray), all);
    }
}

/// Where the ray is closest to the axis, a root's length along the ray is very sensitive to its parameter.
TEST(Revolution, HitsAtTheClosestApproachLieOnTheSurface) {
    const ProfilePoints profile = gobletProfile();
    const Revolution goblet = make(joined(profile), 3);
    for (const Ray& ray : {Ray{{-0.083282546007757169, 0.28934090610471158, -0.61406894714385984},
                               {0.20922344482487662, -1.0305553186695577e-07, 0.97786785924050146}},
                           Ray{{-6.0773842502909643e-05, 0.29967467920301211, 0.047010686781545921},
                               {-0.99999916437830627, -4.203259559811181e-07, -0.0012927654514255091}}}) {
        const auto hits = goblet.allHits(ray, -infinityD, infinityD);
        ASSERT_FALSE(hits.empty());
        for (const PrimitiveHit& hit : hits) {
            const double place = hit.v * double(profile.size());
            const std::size_t segment = std::min(std::size_t(place), profile.size() - 1);
            const V3d p = ray.at(hit.s);
            EXPECT_LT(
                distanceFromCurve(SlowCurve(profile[segment]), place - double(segment), std::hypot(p.x, p.z), p.y),
                64 * 3 * std::numeric_limits<double>::epsilon() * 1.32);
        }
    }
}

TEST(Revolution, PiecesFarApartHaveBoxesOfTheirOwn) {
    const Revolution goblet = make(joined(gobletProfile()), 3);
    EXPECT_LT(goblet.memoryBytes(), 100000u);
    const Revolution reel = make({{0, 0}, {1, 0}, {1, 0.1}, {0.1, 0.1}, {0.1, 9.9}, {1, 9.9}, {1, 10}, {0, 10}}, 1);
    EXPECT_GT(reel.primitiveCount(), 1u) << "two flanges and a core";
}

} // namespace
} // namespace vitrine
