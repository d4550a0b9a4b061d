#include "core/random.h"
#include "core/sampling.h"

namespace vitrine {
namespace {

constexpr float justBelowOne = 0x1.fffffep-1f;

/// For how many of all 2^24 uniform numbers each entry comes up.
std::vector<std::uint32_t> countsOf(const AliasTable& table) {
    std::vector<std::uint32_t> result(std::size_t(table.size()), 0);
    for (std::uint32_t i = 0; i < 1u << 24; ++i)
        ++result[std::size_t(table.sample(float(i) * 0x1p-24f).index)];
    return result;
}

TEST(AliasTable, DrawsWithExactlyTheProbabilitiesItStates) {
    RandomStream random(1);
    std::vector<double> many, uneven;
    for (int i = 0; i < 1000; ++i) {
        many.push_back(random.uniformDouble() < 0.3 ? 0 : random.uniformDouble());
        uneven.push_back(std::exp(60 * random.uniformDouble()));
    }
    const std::vector<std::vector<double>> cases = {
        {1},       {1, 1}, {1, 3}, {0, 1}, {1, 0, 0, 0}, {0.1, 0.2, 0.3, 0.4}, {1e-300, 1e300}, {1, 1e-9, 1e-9},
        {0, 0, 0}, many,   uneven};
    for (const auto& weights : cases) {
        const AliasTable table(weights);
        ASSERT_EQ(table.size(), int(weights.size()));
        double total = 0;
        for (double w : weights)
            total += w;
        const auto found = countsOf(table);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            ASSERT_EQ(double(found[i]), double(table.probability(int(i))) * 0x1p24) << weights.size() << ", " << i;
            if (!(total > 0)) continue;
            ASSERT_EQ(found[i] > 0, weights[i] > 0) << weights.size() << ", " << i;
            // One value of u for each entry first, the others by weight, rounded.
            ASSERT_NEAR(double(found[i]), weights[i] / total * 0x1p24, 2 + double(weights.size()) * weights[i] / total)
                << weights.size() << ", " << i;
        }
    }
}

TEST(AliasTable, TakesMoreEntriesThanThereAreUniformNumbers) {
    std::vector<double> weights((1u << 24) + 5, 1.);
    weights[7] = 1e7;
    const AliasTable table(weights);
    EXPECT_EQ(table.size(), (1 << 24) + 5);
    const auto found = countsOf(table);
    for (std::size_t i = 0; i < weights.size(); ++i)
        ASSERT_EQ(double(found[i]), double(table.probability(int(i))) * 0x1p24) << i;
    EXPECT_NEAR(found[7], 0x1p24 * 1e7 / (1e7 + 0x1p24 + 4), 2);
}

TEST(AliasTable, SamplesCarryTheirProbability) {
    const AliasTable table(std::vector<double>{1, 2, 0, 5});
    for (int i = 0; i < 1000; ++i) {
        const auto s = table.sample(float(i) / 1000);
        EXPECT_EQ(s.probability, table.probability(s.index));
        EXPECT_GT(s.probability, 0);
    }
}

TEST(AliasTable, OfZerosIsUniform) {
    const AliasTable table(std::vector<double>{0, 0, 0, 0});
    for (int i = 0; i < 4; ++i)
        EXPECT_FLOAT_EQ(table.probability(i), 0.25f);
    for (const std::uint32_t n : countsOf(table))
        EXPECT_NEAR(n, 1 << 22, 1);
}

TEST(AliasTable, AtTheEndsOfTheUnitInterval) {
    for (int n = 1; n < 200; ++n) {
        std::vector<double> weights(std::size_t(n), 1.);
        weights.front() = 0;
        weights.back() = n == 1 ? 1 : 0;
        const AliasTable table(weights);
        for (const float u : {0.f, 0x1p-24f, 1e-40f, justBelowOne}) {
            float left = -1;
            const auto s = table.sample(u, &left);
            ASSERT_GE(s.index, 0);
            ASSERT_LT(s.index, n);
            // Two entries are both zero: then both are equally likely.
            ASSERT_TRUE(n == 2 || weights[std::size_t(s.index)] > 0);
            ASSERT_GE(left, 0);
            ASSERT_LT(left, 1);
        }
    }
}

TEST(AliasTable, WhatIsLeftOfUIsUniformAgain) {
    const AliasTable table(std::vector<double>{0.05, 0.6, 0.2, 0.15});
    constexpr int count = 1 << 20, cells = 8;
    int counts[4][cells] = {};
    for (int i = 0; i < count; ++i) {
        float left = 0;
        const auto s = table.sample((float(i) + 0.5f) / count, &left);
        ++counts[s.index][int(left * cells)];
    }
    for (int i = 0; i < 4; ++i)
        for (int c = 0; c < cells; ++c)
            EXPECT_NEAR(counts[i][c] / double(count), double(table.probability(i)) / cells, 1e-5) << i << ", " << c;
}

TEST(AliasTable, RefusesWhatIsNoDistribution) {
    for (const std::vector<double>& weights : {std::vector<double>{}, {1, -1}, {1, NAN}, {1, infinityD}})
        EXPECT_THROW(AliasTable{weights}, std::invalid_argument);
}

} // namespace
} // namespace vitrine
