#include "core/random.h"
#include "film/filter.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace vitrine {
namespace {

constexpr FilterKind allKinds[] = {FilterKind::Box, FilterKind::Gaussian, FilterKind::Mitchell, FilterKind::Sinc,
                                   FilterKind::Triangle};

std::vector<Filter::Settings> variety() {
    std::vector<Filter::Settings> all;
    for (FilterKind kind : allKinds) {
        Filter::Settings s = Filter::Settings::defaults(kind);
        all.push_back(s);
        s.radius = V2f(0.7f, 3.3f);
        s.sigma = 1.3f;
        s.b = 0.9f, s.c = -0.2f;
        s.tau = 1.7f;
        all.push_back(s);
        s.radius = V2f(0.013f, 25);
        s.sigma = 0.02f;
        s.tau = 0.6f;
        all.push_back(s);
    }
    return all;
}

std::string nameOf(const Filter::Settings& s) {
    return "kind " + std::to_string(int(s.kind)) + " radius " + std::to_string(s.radius.x) + " " +
           std::to_string(s.radius.y);
}

/// Integral over one axis of the filter through the other axis's middle, by the midpoint rule.
double integralOf(const Filter& filter) {
    const V2f r = filter.settings().radius;
    const int n = 20000;
    double x = 0, y = 0;
    for (int i = 0; i < n; ++i) {
        const float t = float((i + 0.5) / n * 2 - 1);
        x += double(filter(V2f(t * r.x, 0))) * 2 * r.x / n;
        y += double(filter(V2f(0, t * r.y))) * 2 * r.y / n;
    }
    return x * y / double(filter(V2f(0)));
}

TEST(Filter, IntegratesToOne) {
    for (const auto& s : variety())
        EXPECT_NEAR(integralOf(Filter(s)), 1, 1e-3) << nameOf(s);
}

TEST(Filter, DefaultsArePbrts) {
    EXPECT_EQ(Filter::Settings::defaults(FilterKind::Box).radius, V2f(0.5f));
    EXPECT_EQ(Filter::Settings::defaults(FilterKind::Gaussian).radius, V2f(1.5f));
    EXPECT_EQ(Filter::Settings::defaults(FilterKind::Mitchell).radius, V2f(2));
    EXPECT_EQ(Filter::Settings::defaults(FilterKind::Sinc).radius, V2f(4));
    EXPECT_EQ(Filter::Settings::defaults(FilterKind::Triangle).radius, V2f(2));
    EXPECT_EQ(Filter::Settings().sigma, 0.5f);
    EXPECT_EQ(Filter::Settings().tau, 3);
}

TEST(Filter, ShapesHaveKnownValues) {
    // Values relative to the middle's, worked out by hand from the definitions.
    const auto relative = [](const Filter& f, float x) { return double(f(V2f(x, 0)) / f(V2f(0))); };
    const Filter triangle(Filter::Settings::defaults(FilterKind::Triangle));
    EXPECT_NEAR(relative(triangle, 0.5f), 0.75, 1e-6);
    const Filter gaussian(Filter::Settings::defaults(FilterKind::Gaussian));
    const double edge = std::exp(-4.5);
    EXPECT_NEAR(relative(gaussian, 0.5f), (std::exp(-0.5) - edge) / (1 - edge), 1e-6);
    EXPECT_NEAR(relative(gaussian, 1.5f), 0, 1e-7);
    // Mitchell & Netravali with B = C = 1/3: k(0) = 8/9, k(1) = 1/18, k(1.5) = -5/144.
    const Filter mitchell(Filter::Settings::defaults(FilterKind::Mitchell));
    EXPECT_NEAR(relative(mitchell, 1), 1 / 16., 1e-6);
    EXPECT_NEAR(relative(mitchell, 1.5f), -5 / 128., 1e-6);
    const Filter sinc(Filter::Settings::defaults(FilterKind::Sinc));
    EXPECT_NEAR(relative(sinc, 1), 0, 1e-7);
    EXPECT_NEAR(relative(sinc, 1.5f), std::sin(1.5 * piD) / (1.5 * piD) * std::sin(piD / 2) / (piD / 2), 1e-6);
    const Filter box(Filter::Settings::defaults(FilterKind::Box));
    EXPECT_EQ(box(V2f(0.4f, -0.4f)), 1);
}

TEST(Filter, IsZeroOutsideTheRadius) {
    for (const auto& s : variety()) {
        const Filter f(s);
        EXPECT_EQ(f(V2f(s.radius.x * 1.001f, 0)), 0) << nameOf(s);
        EXPECT_EQ(f(V2f(0, -s.radius.y * 1.001f)), 0) << nameOf(s);
        EXPECT_EQ(f(V2f(std::nanf(""), 0)), 0) << nameOf(s);
    }
}

TEST(Filter, MeanWeightIsTheIntegral) {
    // Strata of the square take away nearly all noise.
    for (const auto& s : variety()) {
        const Filter f(s);
        double sum = 0;
        const int n = 512;
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                sum += double(f.sample(V2f((float(x) + 0.5f) / n, (float(y) + 0.5f) / n)).weight);
        EXPECT_NEAR(sum / (n * n), 1, 0.02) << nameOf(s);
    }
}

TEST(Filter, WeightsOfNonNegativeFiltersAreOne) {
    RandomStream random(1);
    for (FilterKind kind : {FilterKind::Box, FilterKind::Gaussian, FilterKind::Triangle}) {
        const Filter f(Filter::Settings::defaults(kind));
        for (int i = 0; i < 1000; ++i)
            EXPECT_EQ(f.sample(V2f(random.uniform(), random.uniform())).weight, 1);
    }
}

TEST(Filter, SamplesStayInsideAndCarryTheFiltersSign) {
    RandomStream random(2);
    const float last = 0x1.fffffep-1f;
    for (const auto& s : variety()) {
        const Filter f(s);
        std::vector<V2f> points = {V2f(0), V2f(last), V2f(0, last), V2f(0.5f)};
        for (int i = 0; i < 2000; ++i)
            points.push_back(V2f(random.uniform(), random.uniform()));
        int wrongSigns = 0;
        for (const V2f& u : points) {
            const auto sample = f.sample(u);
            EXPECT_LE(std::abs(sample.p.x), s.radius.x) << nameOf(s);
            EXPECT_LE(std::abs(sample.p.y), s.radius.y) << nameOf(s);
            EXPECT_TRUE(std::isfinite(sample.weight) && sample.weight != 0) << nameOf(s);
            wrongSigns += sample.weight * f(sample.p) < 0;
        }
        // A cell in which the sign changes has one sign: there are few samples there, as its mean is small.
        EXPECT_LE(wrongSigns, 20) << nameOf(s);
    }
}

TEST(Filter, PositionsGrowWithTheRandomNumbers) {
    for (const auto& s : variety()) {
        const Filter f(s);
        V2f previous(-infinity);
        for (int i = 0; i < 1024; ++i) {
            const V2f p = f.sample(V2f(float(i) / 1024)).p;
            EXPECT_TRUE(p.x >= previous.x && p.y >= previous.y) << nameOf(s) << " " << i;
            previous = p;
        }
    }
}

TEST(Filter, NonsenseIsRefused) {
    const auto refused = [](auto change) {
        Filter::Settings s;
        change(s);
        EXPECT_THROW(Filter{s}, std::invalid_argument);
    };
    const float nan = std::nanf("");
    for (float bad : {0.f, -1.f, nan, infinity, 1e9f}) {
        refused([&](auto& s) { s.radius.x = bad; });
        refused([&](auto& s) { s.radius.y = bad; });
    }
    for (float bad : {0.f, -1.f, nan, infinity, 1e9f})
        refused([&](auto& s) { s.sigma = bad; });
    for (float bad : {0.f, -1.f, nan, infinity})
        refused([&](auto& s) { s.kind = FilterKind::Sinc, s.tau = bad; });
    for (float bad : {nan, infinity, 1e9f}) {
        refused([&](auto& s) { s.kind = FilterKind::Mitchell, s.b = bad; });
        refused([&](auto& s) { s.kind = FilterKind::Mitchell, s.c = bad; });
    }
}

TEST(Filter, ParametersOfOtherKindsAreNotLookedAt) {
    Filter::Settings s = Filter::Settings::defaults(FilterKind::Box);
    s.sigma = s.tau = s.b = std::nanf("");
    EXPECT_EQ(Filter(s)(V2f(0)), 1);
}

} // namespace
} // namespace vitrine
