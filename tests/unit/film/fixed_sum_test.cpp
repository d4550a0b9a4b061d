#include "core/random.h"
#include "film/fixed_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace vitrine {
namespace {

TEST(FixedSum, KeepsSmallAndLargeValuesToItsResolution) {
    for (double x : {0., 1., -1., 0x1p-30, -0x1p-30, 123456.789, 8.5e9, -8.5e9}) {
        FixedSum sum;
        EXPECT_TRUE(sum.add(x));
        EXPECT_NEAR(sum.value(), x, std::max(0x1p-31, std::abs(x) * 0x1p-52));
    }
    FixedSum half;
    half.add(0.4 * 0x1p-30);
    EXPECT_EQ(half.raw(), 0);
    half.add(0.6 * 0x1p-30);
    EXPECT_EQ(half.raw(), 1);
}

TEST(FixedSum, DoesNotDependOnOrderOrGrouping) {
    RandomStream random(3);
    std::vector<double> values;
    for (int i = 0; i < 5000; ++i)
        values.push_back(std::ldexp(random.uniform(-1, 1), int(random.uniform(-20, 20))));
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
    EXPECT_EQ(sorted.raw(), forward.raw());
    EXPECT_EQ(grouped.raw(), forward.raw());
}

TEST(FixedSum, SaturatesAndSaysSo) {
    FixedSum sum;
    EXPECT_TRUE(sum.add(8e9));
    EXPECT_FALSE(sum.add(8e9));
    EXPECT_NEAR(sum.value(), 0x1p33, 1);
    FixedSum low;
    EXPECT_TRUE(low.add(-8e9));
    EXPECT_FALSE(low.add(-8e9));
    EXPECT_NEAR(low.value(), -0x1p33, 1);
    for (double huge : {1e10, 1e300, 0x1p33}) {
        FixedSum one;
        EXPECT_FALSE(one.add(huge));
        EXPECT_GT(one.value(), 8.5e9);
        FixedSum other;
        other.add(-huge);
        EXPECT_LT(other.value(), -8.5e9);
    }
    FixedSum a = FixedSum::fromRaw(sum.raw()), b = FixedSum::fromRaw(1);
    EXPECT_FALSE(b.add(a));
    EXPECT_EQ(b.raw(), std::numeric_limits<std::int64_t>::max());
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
