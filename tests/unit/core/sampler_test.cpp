#include "core/sampler.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace vitrine {
namespace {

constexpr SamplerKind allKinds[] = {SamplerKind::Independent, SamplerKind::Stratified, SamplerKind::Sobol};

SamplerSettings settingsOf(SamplerKind kind, std::uint64_t seed = 0) {
    SamplerSettings settings;
    settings.kind = kind;
    settings.seed = seed;
    return settings;
}

V2f drawAt(const SamplerSettings& settings, const V2i& pixel, std::uint64_t sample, std::uint32_t dimension) {
    SampleStream stream(settings, pixel, sample);
    stream.setDimension(dimension);
    return stream.get2D();
}

float draw1At(const SamplerSettings& settings, const V2i& pixel, std::uint64_t sample, std::uint32_t dimension) {
    SampleStream stream(settings, pixel, sample);
    stream.setDimension(dimension);
    return stream.get1D();
}

/// How many of the elementary intervals of area 2^-m hold other than one of the 2^m points from `begin`.
int wrongIntervals(const SamplerSettings& settings, const V2i& pixel, std::uint64_t begin, int m, std::uint32_t dim) {
    int wrong = 0;
    for (int xBits = 0; xBits <= m; ++xBits) {
        std::vector<int> count(std::size_t(1) << m);
        for (std::uint64_t i = 0; i < std::uint64_t(1) << m; ++i) {
            const V2f u = drawAt(settings, pixel, begin + i, dim);
            const auto x = std::size_t(u.x * float(1 << xBits)), y = std::size_t(u.y * float(1 << (m - xBits)));
            ++count[(x << (m - xBits)) + y];
        }
        for (int c : count)
            wrong += c != 1;
    }
    return wrong;
}

TEST(Sampler, SobolPairsAreNetsInEveryAlignedBlock) {
    const SamplerSettings settings = settingsOf(SamplerKind::Sobol, 11);
    for (int m = 0; m <= 9; ++m)
        for (std::uint64_t block : {0ull, 1ull, 5ull, 1022ull, (1ull << (32 - m)) - 1, (1ull << (33 - m)) + 3})
            for (int x = 0; x < 8; ++x)
                EXPECT_EQ(wrongIntervals(settings, {x, 40 - x}, block << m, m, std::uint32_t(3 * x)), 0)
                    << "m " << m << " block " << block << " pixel " << x;
}

TEST(Sampler, SobolSinglesAreStratifiedInEveryAlignedBlock) {
    const SamplerSettings settings = settingsOf(SamplerKind::Sobol, 12);
    for (int m = 0; m <= 12; ++m)
        for (std::uint64_t block : {0ull, 3ull, (1ull << (32 - m)) - 1}) {
            std::vector<int> count(std::size_t(1) << m);
            for (std::uint64_t i = 0; i < std::uint64_t(1) << m; ++i)
                ++count[std::size_t(draw1At(settings, {7, m}, (block << m) + i, 5) * float(1 << m))];
            EXPECT_EQ(std::count(count.begin(), count.end(), 1), 1 << m) << "m " << m << " block " << block;
        }
}

TEST(Sampler, SobolIndexIsShuffledPerDimensionAndPixel) {
    // If two dimensions used the same order, points of one stratum would meet in one stratum of the other.
    const SamplerSettings settings = settingsOf(SamplerKind::Sobol);
    int same = 0;
    for (std::uint64_t i = 0; i < 256; ++i)
        same += int(draw1At(settings, {0, 0}, i, 0) * 256) == int(draw1At(settings, {0, 0}, i, 1) * 256);
    EXPECT_LT(same, 20); // 1 is expected
}

TEST(Sampler, StratifiedFillsEachStratumOnce) {
    for (const V2i& strata : {V2i(4, 4), V2i(1, 1), V2i(3, 5), V2i(7, 1), V2i(1, 13), V2i(33, 31)}) {
        SamplerSettings settings = settingsOf(SamplerKind::Stratified, 5);
        settings.xSamples = strata.x;
        settings.ySamples = strata.y;
        const int n = strata.x * strata.y;
        // The samples past the count wrap round to fresh strata.
        for (std::uint64_t begin : {0, n, 7 * n}) {
            std::vector<int> ones(std::size_t(n), 0), pairs(std::size_t(n), 0);
            for (std::uint64_t i = 0; i < std::uint64_t(n); ++i) {
                ++ones[std::size_t(double(draw1At(settings, {2, 9}, begin + i, 4)) * n)];
                const V2f u = drawAt(settings, {2, 9}, begin + i, 6);
                ++pairs[std::size_t(double(u.x) * strata.x) +
                        std::size_t(strata.x) * std::size_t(double(u.y) * strata.y)];
            }
            EXPECT_EQ(std::count(ones.begin(), ones.end(), 1), n) << strata << " from " << begin;
            EXPECT_EQ(std::count(pairs.begin(), pairs.end(), 1), n) << strata << " from " << begin;
        }
    }
}

TEST(Sampler, StratifiedWithoutJitterHitsTheMiddles) {
    SamplerSettings settings = settingsOf(SamplerKind::Stratified);
    settings.jitter = false;
    std::set<float> ones, xs, ys;
    for (std::uint64_t i = 0; i < 16; ++i) {
        ones.insert(draw1At(settings, {1, 1}, i, 0));
        const V2f u = drawAt(settings, {1, 1}, i, 1);
        xs.insert(u.x);
        ys.insert(u.y);
    }
    EXPECT_EQ(xs, (std::set<float>{0.125f, 0.375f, 0.625f, 0.875f}));
    EXPECT_EQ(ys, xs);
    ASSERT_EQ(ones.size(), 16u);
    EXPECT_EQ(*ones.begin(), 0.03125f);
}

TEST(Sampler, StratifiedWrapUsesANewOrder) {
    SamplerSettings settings = settingsOf(SamplerKind::Stratified);
    settings.jitter = false;
    int same = 0;
    for (std::uint64_t i = 0; i < 16; ++i)
        same += draw1At(settings, {3, 3}, i, 0) == draw1At(settings, {3, 3}, i + 16, 0);
    EXPECT_LT(same, 8);
}

TEST(Sampler, DrawsDependOnTheDimensionAloneNotOnTheOrder) {
    for (SamplerKind kind : allKinds) {
        const SamplerSettings settings = settingsOf(kind, 3);
        SampleStream forward(settings, {5, 6}, 7);
        std::vector<float> values;
        for (int d = 0; d < 20; ++d)
            values.push_back(d % 2 ? forward.get1D() : forward.get2D().y);
        SampleStream backward(settings, {5, 6}, 7);
        for (std::uint32_t d = 20; d-- > 0;) {
            backward.setDimension(d);
            EXPECT_EQ(d % 2 ? backward.get1D() : backward.get2D().y, values[d]) << int(kind) << " " << d;
        }
    }
}

TEST(Sampler, StreamsDifferBySeedPixelSampleAndDimension) {
    for (SamplerKind kind : allKinds) {
        std::set<std::pair<float, float>> seen;
        int drawn = 0;
        for (std::uint64_t seed : {0, 1, 2})
            for (int x = -1; x < 3; ++x)
                for (int y = -1; y < 3; ++y)
                    for (std::uint64_t sample = 0; sample < 32; ++sample)
                        for (std::uint32_t d : {0u, 1u, 2u, 1000u}) {
                            const V2f u = drawAt(settingsOf(kind, seed), {x, y}, sample, d);
                            seen.insert({u.x, u.y});
                            ++drawn;
                        }
        EXPECT_EQ(seen.size(), std::size_t(drawn)) << int(kind);
    }
}

TEST(Sampler, ValuesAreMultiplesOfTwoToMinus24BelowOne) {
    for (SamplerKind kind : allKinds) {
        SamplerSettings settings = settingsOf(kind, 9);
        for (const V2i& strata : {V2i(4, 4), V2i(3, 3), V2i(4096, 4096)}) {
            settings.xSamples = strata.x;
            settings.ySamples = strata.y;
            for (std::uint64_t sample = 0; sample < 20000; ++sample) {
                SampleStream stream(settings, {1, 2}, sample);
                const V2f u = stream.get2D();
                for (float v : {u.x, u.y, stream.get1D()}) {
                    ASSERT_GE(v, 0);
                    ASSERT_LT(v, 1);
                    ASSERT_EQ(v * 0x1p24f, std::floor(v * 0x1p24f));
                }
            }
        }
    }
}

/// Values recorded once: the picture's bits hang on them, on every machine.
TEST(Sampler, ValuesAreThoseOfOldRenders) {
    const V3f expected[] = {V3f(13232530, 1421561, 15320126), V3f(12750333, 9509930, 5710810),
                            V3f(3500953, 12815799, 11273546)};
    for (SamplerKind kind : allKinds) {
        SampleStream stream(settingsOf(kind, 1), {2, 3}, 4);
        stream.setDimension(5);
        const V2f pair = stream.get2D();
        EXPECT_EQ(V3f(pair.x, pair.y, stream.get1D()) * 0x1p24f, expected[int(kind)]) << int(kind);
    }
}

TEST(Sampler, ImpossibleStrataAreRefused) {
    SamplerSettings settings;
    EXPECT_NO_THROW(checkSamplerSettings(settings));
    settings.xSamples = 0;
    EXPECT_THROW(checkSamplerSettings(settings), std::invalid_argument);
    settings.xSamples = -4, settings.ySamples = -4;
    EXPECT_THROW(checkSamplerSettings(settings), std::invalid_argument);
    settings.xSamples = settings.ySamples = 4096;
    EXPECT_NO_THROW(checkSamplerSettings(settings));
    settings.xSamples = 65536, settings.ySamples = 65536;
    EXPECT_THROW(checkSamplerSettings(settings), std::invalid_argument);
}

} // namespace
} // namespace vitrine
