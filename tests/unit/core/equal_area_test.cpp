#include "core/equal_area.h"
#include "core/random.h"

namespace vitrine {
namespace {

template <class T>
class EqualArea : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(EqualArea, Scalars);

TYPED_TEST(EqualArea, KnownPoints) {
    using T = TypeParam;
    using V2 = Imath::Vec2<T>;
    using V3 = Imath::Vec3<T>;
    const T tolerance = 4 * std::numeric_limits<T>::epsilon();
    const auto expectDirection = [&](V2 p, V3 expected) {
        EXPECT_TRUE(equalAreaSquareToSphere(p).equalWithAbsError(expected, tolerance))
            << p << " -> " << equalAreaSquareToSphere(p) << ", not " << expected;
    };
    expectDirection(V2(T(0.5), T(0.5)), V3(0, 0, 1));
    expectDirection(V2(1, T(0.5)), V3(1, 0, 0));
    expectDirection(V2(0, T(0.5)), V3(-1, 0, 0));
    expectDirection(V2(T(0.5), 1), V3(0, 1, 0));
    expectDirection(V2(T(0.5), 0), V3(0, -1, 0));
    for (T x : {T(0), T(1)})
        for (T y : {T(0), T(1)})
            expectDirection(V2(x, y), V3(0, 0, -1));
}

TYPED_TEST(EqualArea, RoundTrips) {
    using T = TypeParam;
    RandomStream random(1, sizeof(T));
    for (int i = 0; i < 10000; ++i) {
        const Imath::Vec2<T> p(T(random.uniformDouble()), T(random.uniformDouble()));
        const auto d = equalAreaSquareToSphere(p);
        EXPECT_NEAR(d.length(), 1, 8 * std::numeric_limits<T>::epsilon());
        const auto back = equalAreaSphereToSquare(d);
        EXPECT_TRUE(back.equalWithAbsError(p, 16 * std::numeric_limits<T>::epsilon())) << p << " -> " << back;
    }
}

TYPED_TEST(EqualArea, PolesAndAxesStayInTheSquare) {
    using T = TypeParam;
    using V3 = Imath::Vec3<T>;
    for (T sign : {T(1), T(-1)})
        for (const V3& d : {V3(sign, 0, 0), V3(0, sign, 0), V3(0, 0, sign)}) {
            const auto p = equalAreaSphereToSquare(d);
            EXPECT_TRUE(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1) << d << " -> " << p;
            EXPECT_TRUE(equalAreaSquareToSphere(p).equalWithAbsError(d, 4 * std::numeric_limits<T>::epsilon()));
        }
}

TEST(EqualAreaMap, AreaRatioIsConstant) {
    RandomStream random(2);
    const double h = 1e-5;
    for (int i = 0; i < 2000; ++i) {
        // Keep each stencil within one octant of the octahedron: the map has creases on the lines between them.
        const V2d p(random.uniform(0.01, 0.99), random.uniform(0.01, 0.99));
        const double u = std::abs(2 * p.x - 1), v = std::abs(2 * p.y - 1);
        if (u < 0.01 || v < 0.01 || std::abs(u + v - 1) < 0.01) continue;
        const V3d du = equalAreaSquareToSphere(V2d(p.x + h, p.y)) - equalAreaSquareToSphere(V2d(p.x - h, p.y));
        const V3d dv = equalAreaSquareToSphere(V2d(p.x, p.y + h)) - equalAreaSquareToSphere(V2d(p.x, p.y - h));
        EXPECT_NEAR(du.cross(dv).length() / (4 * h * h), 4 * piD, 1e-4) << p;
    }
}

TEST(EqualAreaMap, WrapIsContinuousOnTheSphere) {
    const double eps = 1e-9;
    for (double t : {0.1, 0.37, 0.5, 0.82})
        for (const auto& [in, out] :
             {std::pair{V2d(eps, t), V2d(-eps, t)}, std::pair{V2d(1 - eps, t), V2d(1 + eps, t)},
              std::pair{V2d(t, eps), V2d(t, -eps)}, std::pair{V2d(t, 1 - eps), V2d(t, 1 + eps)}}) {
            const V3d a = equalAreaSquareToSphere(in), b = equalAreaSquareToSphere(wrapEqualAreaSquare(out));
            EXPECT_LT((a - b).length(), 1e-3) << in << " against " << out;
        }
    EXPECT_EQ(wrapEqualAreaSquare(V2d(0.25, 0.75)), V2d(0.25, 0.75));
}

} // namespace
} // namespace vitrine
