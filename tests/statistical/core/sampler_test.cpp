// Sample streams behave as independent uniform numbers from pixel to pixel and from dimension to dimension, and the
// stratified ones integrate better than independent ones.
#include "core/sampler.h"
#include "support/chi_squared.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

constexpr SamplerKind allKinds[] = {SamplerKind::Independent, SamplerKind::Stratified, SamplerKind::Sobol};
constexpr int side = 1000; ///< pixels of the square that the streams are compared over

SamplerSettings settingsOf(SamplerKind kind, std::uint64_t seed = 77) {
    SamplerSettings settings;
    settings.kind = kind;
    settings.seed = seed;
    return settings;
}

struct Address {
    V2i pixel;
    std::uint64_t sample = 0;
    std::uint32_t dimension = 0;
    std::uint64_t seed = 77;
};

float one(SamplerKind kind, const Address& at) {
    const SamplerSettings settings = settingsOf(kind, at.seed);
    SampleStream stream(settings, at.pixel, at.sample);
    stream.setDimension(at.dimension);
    return stream.get1D();
}

V2f two(SamplerKind kind, const Address& at) {
    const SamplerSettings settings = settingsOf(kind, at.seed);
    SampleStream stream(settings, at.pixel, at.sample);
    stream.setDimension(at.dimension);
    return stream.get2D();
}

double uniformCounts(const std::vector<int>& count) {
    double drawn = 0, statistic = 0;
    for (int c : count)
        drawn += c;
    const double expected = drawn / double(count.size());
    for (int c : count)
        statistic += sqr(c - expected) / expected;
    return test::chiSquaredPValue(statistic, int(count.size()) - 1);
}

/// p-value that the pairs made by `draw` for every second pixel of the square (so that no number is used twice when a
/// pair takes in a neighbour) are uniform on the unit square.
template <class Draw>
double uniformPairs(const Draw& draw) {
    constexpr int bins = 16;
    std::vector<int> count(bins * bins);
    for (int y = 0; y < side; y += 2)
        for (int x = 0; x < side; x += 2) {
            const V2f u = draw(V2i(x, y));
            ++count[std::size_t(u.x * bins) * bins + std::size_t(u.y * bins)];
        }
    return uniformCounts(count);
}

TEST(SamplerStatistics, SinglesAreUniform) {
    const double threshold = test::sidakThreshold(0.001, 3 * 3);
    for (SamplerKind kind : allKinds)
        for (std::uint64_t sample : {0, 1, 21}) {
            std::vector<int> count(4096);
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x)
                    ++count[std::size_t(one(kind, {{x, y}, sample, 4}) * 4096)];
            EXPECT_GT(uniformCounts(count), threshold) << int(kind) << " sample " << sample;
        }
}

TEST(SamplerStatistics, PairsAreUniform) {
    const double threshold = test::sidakThreshold(0.001, 3 * 4 * 2);
    for (SamplerKind kind : allKinds)
        for (std::uint64_t sample : {0ull, 1ull, 13ull, 1ull << 20})
            for (std::uint32_t dimension : {0u, 9u})
                EXPECT_GT(uniformPairs([&](const V2i& p) {
                              return two(kind, {p, sample, dimension});
                          }),
                          threshold)
                    << int(kind) << " sample " << sample << " dimension " << dimension;
}

TEST(SamplerStatistics, DimensionsAreIndependent) {
    const std::pair<std::uint32_t, std::uint32_t> dimensions[] = {{0, 1}, {0, 2}, {3, 8}, {1, 1025}};
    const double threshold = test::sidakThreshold(0.001, 3 * 3 * 4 * 2);
    for (SamplerKind kind : allKinds)
        for (std::uint64_t sample : {0, 1, 14})
            for (const auto& [a, b] : dimensions) {
                EXPECT_GT(uniformPairs([&](const V2i& p) {
                              return V2f(one(kind, {p, sample, a}), one(kind, {p, sample, b}));
                          }),
                          threshold)
                    << int(kind) << " sample " << sample << " dimensions " << a << " " << b;
                EXPECT_GT(uniformPairs([&](const V2i& p) {
                              return V2f(two(kind, {p, sample, a}).y, two(kind, {p, sample, b}).y);
                          }),
                          threshold)
                    << int(kind) << " sample " << sample << " y of dimensions " << a << " " << b;
            }
}

TEST(SamplerStatistics, NeighbouringPixelsAndSeedsAreIndependent) {
    const double threshold = test::sidakThreshold(0.001, 3 * 2 * 4);
    for (SamplerKind kind : allKinds)
        for (std::uint64_t sample : {0, 6}) {
            for (const V2i& step : {V2i(1, 0), V2i(0, 1), V2i(1, 1)})
                EXPECT_GT(uniformPairs([&](const V2i& p) {
                              return V2f(one(kind, {p, sample, 3}), one(kind, {p + step, sample, 3}));
                          }),
                          threshold)
                    << int(kind) << " sample " << sample << " step " << step;
            EXPECT_GT(uniformPairs([&](const V2i& p) {
                          return V2f(one(kind, {p, sample, 3, 77}), one(kind, {p, sample, 3, 78}));
                      }),
                      threshold)
                << int(kind) << " sample " << sample << " seeds";
        }
}

TEST(SamplerStatistics, IndependentSamplesOfAPixelAreIndependent) {
    const double threshold = test::sidakThreshold(0.001, 2);
    for (std::uint64_t next : {1, 2})
        EXPECT_GT(uniformPairs([&](const V2i& p) {
                      return V2f(one(SamplerKind::Independent, {p, 0, 2}), one(SamplerKind::Independent, {p, next, 2}));
                  }),
                  threshold);
}

/// A smooth function of mean 0 over the unit square.
double smooth(const V2f& u) {
    return double(u.x) * u.y * u.y - 1 / 6.;
}

/// Errors of the pixels' means over `samples` samples each, row by row.
std::vector<double> errorsOfMeans(SamplerKind kind, int width, int samples) {
    SamplerSettings settings = settingsOf(kind);
    settings.xSamples = settings.ySamples = int(std::lround(std::sqrt(double(samples))));
    std::vector<double> errors;
    for (int y = 0; y < width; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            for (int i = 0; i < samples; ++i) {
                SampleStream stream(settings, {x, y}, std::uint64_t(i));
                sum += smooth(stream.get2D());
            }
            errors.push_back(sum / samples);
        }
    return errors;
}

double meanSquare(const std::vector<double>& values) {
    double sum = 0;
    for (double v : values)
        sum += v * v;
    return sum / double(values.size());
}

TEST(SamplerStatistics, MeansAreUnbiasedAndStratificationLowersTheirVariance) {
    const double threshold = test::sidakThreshold(0.001, 3);
    double variance[3] = {};
    for (SamplerKind kind : allKinds) {
        const std::vector<double> errors = errorsOfMeans(kind, 40, 256);
        variance[int(kind)] = meanSquare(errors);
        double mean = 0;
        for (double e : errors)
            mean += e / double(errors.size());
        EXPECT_GT(test::normalPValue(mean / std::sqrt(meanSquare(errors) / double(errors.size()))), threshold)
            << int(kind);
    }
    // Jittered sampling of a smooth function: n^-2 against n^-1; scrambled nets: n^-3 log n (Owen 1997).
    EXPECT_LT(variance[int(SamplerKind::Stratified)], variance[int(SamplerKind::Independent)] / 50);
    EXPECT_LT(variance[int(SamplerKind::Sobol)], variance[int(SamplerKind::Stratified)] / 5);
}

TEST(SamplerStatistics, ErrorsOfNeighbouringPixelsAreUncorrelated) {
    constexpr int width = 100;
    const double threshold = test::sidakThreshold(0.001, 3 * 2);
    for (SamplerKind kind : allKinds) {
        const std::vector<double> e = errorsOfMeans(kind, width, 16);
        for (int step : {1, width}) {
            double sum = 0;
            int pairs = 0;
            for (int i = 0; i + step < width * width; ++i) {
                if (step == 1 && i % width == width - 1) continue;
                sum += e[std::size_t(i)] * e[std::size_t(i + step)];
                ++pairs;
            }
            EXPECT_GT(test::normalPValue(sum / (meanSquare(e) * std::sqrt(double(pairs)))), threshold)
                << int(kind) << " step " << step;
        }
    }
}

} // namespace
} // namespace vitrine
