#include "core/random.h"
#include "support/texture_points.h"
#include "textures/checkerboard.h"

namespace vitrine {
namespace {

const MappingPtr uv = std::make_shared<UvMapping>();

/// The mean of the sharp pattern under a triangle in each coordinate that reaches 1.5 times the footprint, by brute force:
/// midpoints in the triangle's own strata.
template <class Sharp>
double mean(int dimensions, const double* centre, const double* footprint, const Sharp& sharp) {
    const int n = dimensions == 2 ? 2000 : 120;
    const auto place = [&](int axis, int i) {
        const double u = (i + 0.5) / n; // inverse of the triangle's distribution function on [-1, 1]
        const double e = u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 * (1 - u));
        return centre[axis] + 1.5 * footprint[axis] * e;
    };
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            if (dimensions == 2)
                sum += sharp(place(0, i), place(1, j), 0.);
            else
                for (int k = 0; k < n; ++k)
                    sum += sharp(place(0, i), place(1, j), place(2, k));
    return sum / std::pow(n, dimensions);
}

TEST(Squares, Alternate) {
    const SquaresWeight weight(uv);
    EXPECT_TRUE(weight.isFiltered());
    for (int s = -4; s < 4; ++s)
        for (int t = -4; t < 4; ++t)
            for (const float inside : {0.f, 0.4f, 0.999f})
                EXPECT_EQ(weight.evaluate(uvAt({float(s) + inside, float(t) + 0.5f})), float((s + t) & 1)) << s << t;
}

TEST(Squares, AreTheMeanUnderTheFootprint) {
    const SquaresWeight weight(uv);
    const auto sharp = [&](double s, double t, double) { return std::fmod(std::floor(s) + std::floor(t) + 1000, 2); };
    RandomStream random(11);
    for (int i = 0; i < 12; ++i) {
        const float s = float(random.uniform(-3, 3)), t = float(random.uniform(-3, 3));
        const float ds = float(std::exp(random.uniform(-4, 1))), dt = float(std::exp(random.uniform(-4, 1)));
        const double centre[] = {s, t}, footprint[] = {ds, dt};
        // A footprint's x and y count by the larger component.
        const float found = weight.evaluate(uvAt({s, t}, {ds, dt / 3}, {-ds / 2, dt}));
        // Each crossed edge puts at most one of 2000 strata on the wrong side.
        EXPECT_NEAR(found, mean(2, centre, footprint, sharp), (ds + dt + 2) * 2 / 2000) << s << " " << t << " " << ds;
    }
}

TEST(Cubes, AreTheMeanUnderTheFootprint) {
    const CubesWeight weight{TextureSpace()};
    const auto sharp = [&](double x, double y, double z) {
        return std::fmod(std::floor(x) + std::floor(y) + std::floor(z) + 1000, 2);
    };
    EXPECT_EQ(weight.evaluate(pointAt({0.5, 0.5, 0.5})), 0);
    EXPECT_EQ(weight.evaluate(pointAt({-0.5, 0.5, 0.5})), 1);
    EXPECT_EQ(weight.evaluate(pointAt({-0.5, 1.5, -2.5})), 1);
    RandomStream random(13);
    for (int i = 0; i < 6; ++i) {
        const double centre[] = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
        const float d = float(std::exp(random.uniform(-3, 0)));
        const double footprint[] = {d, d / 2, 0};
        const float found = weight.evaluate(pointAt({centre[0], centre[1], centre[2]}, {d, 0, 0}, {0, -d / 2, 0}));
        EXPECT_NEAR(found, mean(3, centre, footprint, sharp), (2 * d + 3) * 2 / 120) << d;
    }
}

/// Filtering moves the pattern about but makes none of it: over a period the mean stays 1/2.
TEST(Squares, KeepTheirMeanOverAnArea) {
    const SquaresWeight weight(uv);
    for (const float footprint : {0.f, 0.01f, 0.2f, 1.f, 7.f}) {
        const int n = 128; // one pair of squares
        double sum = 0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                sum += weight.evaluate(
                    uvAt({2 * (float(i) + 0.5f) / n, 2 * (float(j) + 0.5f) / n}, {footprint, 0}, {0, footprint}));
        EXPECT_NEAR(sum / (n * n), 0.5, 1e-6) << footprint;
    }
}

TEST(Squares, AreGreyFromAfar) {
    const SquaresWeight weight(uv);
    for (const float footprint : {100.f, 1e6f, 1e20f, 1e38f})
        EXPECT_NEAR(weight.evaluate(uvAt({0.3f, 0.3f}, {footprint, 0}, {0, footprint})), 0.5, 1e-4) << footprint;
    // Seen edge-on: grey as soon as one coordinate is.
    EXPECT_NEAR(weight.evaluate(uvAt({0.3f, 0.3f}, {1000, 0}, {0, 0.001f})), 0.5, 1e-4);
}

/// However narrow the footprint at an edge: always between the two sides, and half of each on the edge itself.
TEST(Squares, HaveNoOvershootAtEdges) {
    const SquaresWeight weight(uv);
    for (const float footprint : {1e-40f, 1e-20f, 1e-8f, 1e-4f, 0.1f, 0.33f, 0.34f, 1.f}) {
        EXPECT_EQ(weight.evaluate(uvAt({2, 0.5f}, {footprint, 0})), 0.5f) << footprint;
        for (int i = -20; i <= 20; ++i) {
            const float w = weight.evaluate(uvAt({1 + float(i) * 0.1f * footprint, 0.5f}, {footprint, 0}));
            EXPECT_GE(w, 0);
            EXPECT_LE(w, 1);
        }
    }
    // Where one formula takes over from the other (reach 1/2) they agree.
    for (const float s : {-0.2f, 0.3f, 0.97f})
        EXPECT_NEAR(weight.evaluate(uvAt({s, 0.5f}, {0.33333f, 0})), weight.evaluate(uvAt({s, 0.5f}, {0.33334f, 0})),
                    1e-4);
}

TEST(Squares, StayRegularFarOut) {
    const SquaresWeight weight(std::make_shared<PlanarMapping>(TextureSpace(), V3d(1, 0, 0), V3d(0, 1, 0), V2d(0, 0)));
    for (const double far : {1e6, -1e9, 1e12}) {
        EXPECT_EQ(weight.evaluate(pointAt({far + 0.25, 0.5, 0})), 0);
        EXPECT_EQ(weight.evaluate(pointAt({far + 1.25, 0.5, 0})), 1);
        EXPECT_NEAR(weight.evaluate(pointAt({far + 1, 0.5, 0}, {0.5f, 0, 0})), 0.5, 1e-3);
    }
}

/// The stripes of "axis": a checkerboard's other coordinate changes nothing.
TEST(Squares, AreStripesAlongAnAxis) {
    const SquaresWeight weight(std::make_shared<AxisMapping>(TextureSpace(), V3d(0, 2, 0), 0.5, 0.1));
    for (int i = -6; i < 6; ++i)
        for (const double x : {-3.2, 0., 5.7})
            EXPECT_EQ(weight.evaluate(pointAt({x, 0.1 + 0.5 * (i + 0.5), x / 2})), float(i & 1));
}

} // namespace
} // namespace vitrine
