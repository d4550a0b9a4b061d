// What the filters' samples add up to.
#include "core/random.h"
#include "film/filter.h"
#include "support/chi_squared.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

constexpr FilterKind allKinds[] = {FilterKind::Box, FilterKind::Gaussian, FilterKind::Mitchell, FilterKind::Sinc,
                                   FilterKind::Triangle};

/// z of the difference between the mean of `f` over weighted samples and its integral under the filter.
template <class F>
double zOfFilteredMean(const Filter& filter, std::uint64_t seed, double expected, const F& f) {
    RandomStream random(seed);
    const int n = 400000;
    double sum = 0, squares = 0;
    for (int i = 0; i < n; ++i) {
        const auto s = filter.sample(V2f(random.uniform(), random.uniform()));
        const double value = double(s.weight) * f(s.p);
        sum += value;
        squares += value * value;
    }
    const double mean = sum / n, error = std::sqrt(std::max(1e-30, (squares / n - mean * mean) / n));
    return (mean - expected) / error;
}

TEST(FilterStatistics, FilteredMeansAreUnbiased) {
    const double threshold = test::sidakThreshold(0.001, 5 * 3);
    for (FilterKind kind : allKinds) {
        const auto settings = Filter::Settings::defaults(kind);
        const Filter filter(settings);
        const double r = settings.radius.x;
        // Wide, slowly varying functions: cells of 1/16 pixel are a fraction of a standard error for them.
        const auto functions = {+[](const V2f&) { return 1.; }, +[](const V2f& p) { return 1 + double(p.x) * 0.3; },
                                +[](const V2f& p) { return std::cos(double(p.x)) * std::cos(0.5 * double(p.y)); }};
        std::uint64_t seed = 10 * std::uint64_t(kind);
        for (const auto f : functions) {
            const double expected = test::integrateRectangle(
                [&](double x, double y) {
                    const V2f p{float(x), float(y)};
                    return double(filter(p)) * f(p);
                },
                V2d(-r, -r), V2d(r, r));
            const double z = zOfFilteredMean(filter, seed++, expected, f);
            // Constant weights leave rounding alone.
            if (f(V2f(0.3f)) == 1 && filter.sample(V2f(0.1f)).weight == 1) continue;
            EXPECT_GT(test::normalPValue(z), threshold) << "kind " << int(kind) << " z " << z;
        }
    }
}

/// The samples' density is |value| over its integral. Squares that span whole cells of the tables, so that cells of
/// constant density cost nothing.
TEST(FilterStatistics, SamplesFollowTheAbsoluteValue) {
    const double threshold = test::sidakThreshold(0.001, 5);
    for (FilterKind kind : allKinds) {
        const auto settings = Filter::Settings::defaults(kind);
        const Filter filter(settings);
        const float r = settings.radius.x;
        const auto toFilter = [&](const V2f& u) { return V2f(r * (2 * u.x - 1), r * (2 * u.y - 1)); };
        const double mass = test::integrateRectangle(
            [&](double x, double y) { return std::abs(double(filter(toFilter(V2f(float(x), float(y)))))); }, V2d(0, 0),
            V2d(1, 1));
        test::ChiSquaredSettings chi;
        chi.rows = chi.columns = 16;
        chi.samples = 60000;
        chi.seed = 100 + std::uint64_t(kind);
        const auto result = test::chiSquaredSquare(
            [&](RandomStream& random) -> std::optional<V2f> {
                const auto s = filter.sample(V2f(random.uniform(), random.uniform()));
                const V2f u((s.p.x / r + 1) / 2, (s.p.y / r + 1) / 2);
                return V2f(std::min(u.x, 0x1.fffffep-1f), std::min(u.y, 0x1.fffffep-1f));
            },
            [&](const V2f& u) { return std::abs(double(filter(toFilter(u)))) / mass; }, chi);
        EXPECT_GT(result.pValue, threshold) << "kind " << int(kind) << "\n" << result.report;
    }
}

} // namespace
} // namespace vitrine
