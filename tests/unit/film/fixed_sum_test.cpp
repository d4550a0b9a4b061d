#include "core/random.h"
#include "film/fixed_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace vitrine {
namespace {

constexpr double resolution = 0x1p-44, limit = 0x1p51;

FixedSum sumOf(std::initializer_list<double> values) {
    FixedSum sum;
    for (const double x : values)
        sum.add(x);
    return sum;
}

TEST(FixedSum, KeepsSmallAndLargeValuesToItsResolution) {
    for (double x : {0., 1., -1., resolution, -resolution, 123456.789, 0x1p19, -0x1p19, 0x1p20 + 0x1p-32, 8.5e9, -8.5e9,
                     1.6e9 * 1e6, -0x1p51 + 0.5, 0x1p51 - 0.5}) {
        FixedSum sum;
        EXPECT_TRUE(sum.add(x)) << x;
        EXPECT_NEAR(sum.value(), x, resolution / 2);
        EXPECT_TRUE(sum.add(-x)) << x;
        EXPECT_EQ(sum.value(), 0) << x;
    }
    EXPECT_EQ(sumOf({0.4 * resolution}).value(), 0);
    EXPECT_EQ(sumOf({0.6 * resolution}).value(), resolution);
}

TEST(FixedSum, CarriesThroughAllItsWords) {
    // Steps that cross 2^-44 * 2^32 and * 2^64 from both sides; each is a multiple of the resolution.
    for (const double edge : {0x1p-12, 0x1p20, 0x1p50}) {
        FixedSum sum;
        double expected = 0;
        for (const double step : {edge, -resolution, resolution, resolution, -edge, -resolution, -resolution, -edge}) {
            EXPECT_TRUE(sum.add(step));
            expected += step; // exact but near 2^50, where the halves of a resolution are lost
            EXPECT_NEAR(sum.value(), expected, edge * 0x1p-51) << edge;
        }
        EXPECT_TRUE(sum.add(edge));
        EXPECT_EQ(sum.value(), -resolution) << edge;
    }
}

TEST(FixedSum, DoesNotDependOnOrderOrGrouping) {
    RandomStream random(3);
    std::vector<double> values;
    for (int i = 0; i < 5000; ++i)
        values.push_back(std::ldexp(random.uniform(-1, 1), int(random.uniform(-30, 40))));
    FixedSum forward;
    for (double v : values)
        forward.add(v);

    std::sort(values.begin(), values.end());
    FixedSum sorted, groups[7], grouped;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sorted.add(values[i]);
        groups[(i * i) % 7].add(values[i]);
    }
    for (const FixedSum& g : groups)
        grouped.add(g);
    EXPECT_TRUE(sorted == forward);
    EXPECT_TRUE(grouped == forward);
}

TEST(FixedSum, SaturatesAndSaysSo) {
    FixedSum sum;
    EXPECT_TRUE(sum.add(2e15));
    EXPECT_FALSE(sum.add(2e15));
    EXPECT_NEAR(sum.value(), limit, 1);
    FixedSum low;
    EXPECT_TRUE(low.add(-2e15));
    EXPECT_FALSE(low.add(-2e15));
    EXPECT_NEAR(low.value(), -limit, 1);
    for (double huge : {1e16, 1e300, limit}) {
        FixedSum one;
        EXPECT_FALSE(one.add(huge));
        EXPECT_NEAR(one.value(), limit, 1);
        FixedSum other;
        EXPECT_FALSE(other.add(-2 * huge));
        EXPECT_NEAR(other.value(), -limit, 1);
    }
    FixedSum a = sum, b = sumOf({1});
    EXPECT_FALSE(b.add(a));
    EXPECT_NEAR(b.value(), limit, 1);
}

TEST(FixedSum, DropsWhatIsNotFinite) {
    FixedSum sum;
    sum.add(1.5);
    EXPECT_FALSE(sum.add(std::numeric_limits<double>::infinity()));
    EXPECT_FALSE(sum.add(-std::numeric_limits<double>::infinity()));
    EXPECT_FALSE(sum.add(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_EQ(sum.value(), 1.5);
}

} // namespace
} // namespace vitrine
