#include "core/random.h"
#include "core/sampling.h"

#include <cmath>

namespace vitrine {
namespace {

constexpr float justBelowOne = 0x1.fffffep-1f;

/// All corners, edges and the middle of the unit square.
std::vector<V2f> extremes() {
    std::vector<V2f> all;
    for (const float x : {0.f, 1e-30f, 0x1p-24f, 0.25f, 0.5f, 0.75f, justBelowOne})
        for (const float y : {0.f, 1e-30f, 0x1p-24f, 0.25f, 0.5f, 0.75f, justBelowOne})
            all.emplace_back(x, y);
    return all;
}

TEST(SampleDisk, StaysInsideAndKeepsAreas) {
    for (const V2f& u : extremes()) {
        const V2f p = sampleUniformDisk(u);
        EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y)) << u;
        EXPECT_LE(p.length(), 1 + 1e-6f) << u;
    }
    EXPECT_EQ(sampleUniformDisk(V2f(0.5f, 0.5f)), V2f(0, 0));
    // Squares about the centre become disks: as much of the samples lies within radius r as the square of r.
    constexpr int n = 400;
    for (const float radius : {0.1f, 0.5f, 0.9f}) {
        int inside = 0, right = 0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const V2f p = sampleUniformDisk(V2f((float(i) + 0.5f) / n, (float(j) + 0.5f) / n));
                inside += p.length() < radius;
                right += p.x > std::abs(p.y);
            }
        EXPECT_NEAR(inside / double(n * n), double(radius * radius), 4. / n);
        EXPECT_NEAR(right / double(n * n), 0.25, 4. / n);
    }
}

TEST(SampleHemisphere, IsCosineWeighted) {
    for (const V2f& u : extremes()) {
        const V3f w = sampleCosineHemisphere(u);
        EXPECT_NEAR(w.length(), 1, 1e-6f) << u;
        EXPECT_GE(w.z, 0) << u;
    }
    constexpr int n = 300;
    double z = 0, z2 = 0, xy = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const V3f w = sampleCosineHemisphere(V2f((float(i) + 0.5f) / n, (float(j) + 0.5f) / n));
            z += double(w.z);
            z2 += double(w.z * w.z);
            xy += double(w.x * w.y);
        }
    // Means under cos/pi: z 2/3, z^2 1/2.
    EXPECT_NEAR(z / (n * n), 2. / 3, 1e-4);
    EXPECT_NEAR(z2 / (n * n), 0.5, 1e-4);
    EXPECT_NEAR(xy / (n * n), 0, 1e-4);
}

TEST(SampleSphere, IsUniform) {
    for (const V2f& u : extremes())
        EXPECT_NEAR(sampleUniformSphere(u).length(), 1, 1e-6f) << u;
    constexpr int n = 300;
    V3d mean(0), squares(0);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const V3d w = toDouble(sampleUniformSphere(V2f((float(i) + 0.5f) / n, (float(j) + 0.5f) / n)));
            mean += w / (n * n);
            squares += w * w / (n * n);
        }
    EXPECT_NEAR(mean.length(), 0, 1e-5);
    EXPECT_NEAR((squares - V3d(1. / 3)).length(), 0, 1e-4);
}

TEST(SampleTriangle, IsUniformAndInside) {
    for (const V2f& u : extremes()) {
        const V2f b = sampleUniformTriangle(u);
        EXPECT_GE(b.x, 0) << u;
        EXPECT_GE(b.y, 0) << u;
        EXPECT_LE(b.x + b.y, 1) << u;
    }
    constexpr int n = 400;
    V3d mean(0);
    int corner = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const V2f b = sampleUniformTriangle(V2f((float(i) + 0.5f) / n, (float(j) + 0.5f) / n));
            mean += V3d(b.x, b.y, 1 - b.x - b.y) / (n * n);
            corner += b.x > 0.5f;
        }
    EXPECT_NEAR((mean - V3d(1. / 3)).length(), 0, 1e-4);
    EXPECT_NEAR(corner / double(n * n), 0.25, 4. / n); // the half-size triangle at a corner
}

TEST(PowerHeuristic, WeighsBySquares) {
    EXPECT_EQ(powerHeuristic(1, 1), 0.5f);
    EXPECT_FLOAT_EQ(powerHeuristic(3, 1), 0.9f);
    EXPECT_EQ(powerHeuristic(0, 1), 0);
    EXPECT_EQ(powerHeuristic(0, 0), 0);
    EXPECT_EQ(powerHeuristic(1, 0), 1);
    // Squares that would over- and underflow.
    EXPECT_FLOAT_EQ(powerHeuristic(1e30f, 1e30f), 0.5f);
    EXPECT_FLOAT_EQ(powerHeuristic(1e-30f, 1e-30f), 0.5f);
    EXPECT_EQ(powerHeuristic(1e30f, 1e-30f), 1);
    EXPECT_EQ(powerHeuristic(1e-30f, 1e30f), 0);
    EXPECT_EQ(powerHeuristic(infinity, 1), 1);
    RandomStream random(1);
    for (int i = 0; i < 100; ++i) {
        const float a = random.uniform(), b = random.uniform();
        EXPECT_NEAR(powerHeuristic(a, b) + powerHeuristic(b, a), 1, 1e-6f);
    }
}

TEST(PiecewiseConstant1D, HasTheGivenDensity) {
    const std::vector<float> weights = {1, 3, 0, 4};
    const PiecewiseConstant1D d(weights);
    EXPECT_EQ(d.size(), 4);
    EXPECT_DOUBLE_EQ(d.integral(), 2);
    const float expected[] = {0.5f, 1.5f, 0, 2};
    for (int i = 0; i < 4; ++i) {
        EXPECT_FLOAT_EQ(d.pdf((float(i) + 0.5f) / 4), expected[i]);
        EXPECT_FLOAT_EQ(d.probability(i), expected[i] / 4);
    }
    EXPECT_FLOAT_EQ(d.pdf(0), 0.5f);
    EXPECT_FLOAT_EQ(d.pdf(1), 2);
    // The distribution function is inverted: u at the joints and half way between.
    EXPECT_FLOAT_EQ(d.sample(0.0625f).x, 0.125f);
    EXPECT_FLOAT_EQ(d.sample(0.125f).x, 0.25f);
    EXPECT_FLOAT_EQ(d.sample(0.3125f).x, 0.375f);
    EXPECT_FLOAT_EQ(d.sample(0.5f).x, 0.75f); // past the empty bin
    EXPECT_FLOAT_EQ(d.sample(0.75f).x, 0.875f);
}

TEST(PiecewiseConstant1D, NeverSamplesWhatIsZero) {
    const std::vector<std::vector<float>> cases = {
        {0, 1}, {1, 0}, {0, 0, 1, 0, 0}, {0, 1e-30f, 0}, {1e-20f, 0, 1, 0}, {0, 1, 0, 1e20f, 0}};
    for (const auto& weights : cases) {
        const PiecewiseConstant1D d(weights);
        for (int k = 0; k <= 1000; ++k) {
            const float u = k == 1000 ? justBelowOne : float(k) / 1000;
            const auto s = d.sample(u);
            ASSERT_GT(weights[std::size_t(s.bin)], 0) << "u = " << u;
            ASSERT_GT(s.pdf, 0);
            ASSERT_GE(s.x, 0);
            ASSERT_LT(s.x, 1);
        }
    }
}

TEST(PiecewiseConstant1D, OfZerosIsUniform) {
    const PiecewiseConstant1D d(std::vector<float>(5, 0.f));
    EXPECT_EQ(d.integral(), 0);
    for (const float u : {0.f, 0.3f, justBelowOne}) {
        EXPECT_NEAR(d.sample(u).x, u, 1e-6f);
        EXPECT_FLOAT_EQ(d.sample(u).pdf, 1);
        EXPECT_FLOAT_EQ(d.pdf(u), 1);
    }
}

/// Bin edges that float cannot hold: the sampled x must lie where pdf() sees the density it was drawn with.
TEST(PiecewiseConstant1D, SampleAndDensityAgreeOnTheBin) {
    for (const int n : {1, 2, 3, 7, 49, 1000, 16384, 30011}) {
        std::vector<float> weights;
        for (int i = 0; i < n; ++i)
            weights.push_back(i % 2 ? 1e6f : 1.f);
        const PiecewiseConstant1D d(weights);
        const auto check = [&](float u) {
            const auto s = d.sample(u);
            ASSERT_EQ(d.pdf(s.x), s.pdf) << n << " bins, u = " << u << ", x = " << s.x;
            ASSERT_LT(s.x, 1);
        };
        check(0);
        check(justBelowOne);
        double cumulative = 0, total = 0;
        for (float w : weights)
            total += double(w);
        for (float w : weights) {
            // On both sides of every joint.
            cumulative += double(w) / total;
            const float u = std::min(float(cumulative), justBelowOne);
            check(u);
            check(std::nextafter(u, 0.f));
            check(std::min(std::nextafter(u, 1.f), justBelowOne));
        }
    }
}

TEST(PiecewiseConstant1D, RefusesWhatIsNoDensity) {
    for (const std::vector<float>& weights : {std::vector<float>{}, {1, -1}, {1, NAN}, {1, infinity}})
        EXPECT_THROW(PiecewiseConstant1D{weights}, std::invalid_argument);
}

TEST(PiecewiseConstant2D, HasTheGivenDensity) {
    const std::vector<float> weights = {1, 2, 3, 0, 0, 6}; // 3 wide, 2 high
    const PiecewiseConstant2D d(weights, 3, 2);
    EXPECT_DOUBLE_EQ(d.integral(), 2);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            EXPECT_FLOAT_EQ(d.pdf(V2f((float(x) + 0.5f) / 3, (float(y) + 0.5f) / 2)),
                            weights[std::size_t(3 * y + x)] / 2);
    int counts[6] = {};
    constexpr int n = 240;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const auto s = d.sample(V2f((float(i) + 0.5f) / n, (float(j) + 0.5f) / n));
            EXPECT_FLOAT_EQ(s.pdf, d.pdf(s.p));
            ++counts[3 * int(s.p.y * 2) + int(s.p.x * 3)];
        }
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(counts[i], double(weights[i]) / 12 * n * n, 2 * n) << i;
}

TEST(PiecewiseConstant2D, AtTheCornersOfTheSquare) {
    const std::vector<float> weights = {0, 0, 0, 0, 5, 0, 0, 0, 0};
    const PiecewiseConstant2D middle(weights, 3, 3);
    const PiecewiseConstant2D zero(std::vector<float>(9, 0.f), 3, 3);
    for (const V2f& u : extremes()) {
        const auto s = middle.sample(u);
        EXPECT_FLOAT_EQ(s.pdf, 9) << u;
        EXPECT_FLOAT_EQ(middle.pdf(s.p), 9) << u;
        EXPECT_NEAR((zero.sample(u).p - u).length(), 0, 1e-6f);
        EXPECT_FLOAT_EQ(zero.sample(u).pdf, 1);
    }
    EXPECT_THROW(PiecewiseConstant2D(weights, 3, 2), std::invalid_argument);
    EXPECT_THROW(PiecewiseConstant2D({}, 0, 0), std::invalid_argument);
}

} // namespace
} // namespace vitrine
