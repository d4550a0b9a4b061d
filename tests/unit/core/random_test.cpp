#include "core/random.h"

#include <set>

namespace vitrine {
namespace {

TEST(Random, IsSplitMix64) {
    // The sequences of Vigna's reference code, splitmix64.c, for seeds 0 and 1234567.
    EXPECT_EQ(randomBits(0, 0), 0xe220a8397b1dcdafull);
    EXPECT_EQ(randomBits(0, 1), 0x6e789e6aa1b965f4ull);
    EXPECT_EQ(randomBits(0, 2), 0x06c45d188009454full);
    EXPECT_EQ(randomBits(1234567, 0), 6457827717110365317ull);
    EXPECT_EQ(randomBits(1234567, 1), 3203168211198807973ull);
    EXPECT_EQ(randomBits(1234567, 2), 9817491932198370423ull);
}

TEST(Random, FloatsStayBelowOne) {
    EXPECT_EQ(unitFloat(0), 0.f);
    EXPECT_EQ(unitFloat(0xffffffffu), 0x1.fffffep-1f);
    EXPECT_EQ(unitFloat(0x80000000u), 0.5f);
    EXPECT_EQ(unitDouble(0), 0.);
    EXPECT_EQ(unitDouble(~0ull), 0x1.fffffffffffffp-1);
}

TEST(Random, KeysDifferByEveryPartAndTheirOrder) {
    std::set<std::uint64_t> keys;
    for (int seed = 0; seed < 20; ++seed)
        for (int pass = 0; pass < 20; ++pass)
            for (int pixel = 0; pixel < 20; ++pixel)
                keys.insert(streamKey(seed, pass, pixel));
    EXPECT_EQ(keys.size(), 8000u);
    EXPECT_NE(streamKey(1, 2), streamKey(2, 1));
    EXPECT_NE(streamKey(1), streamKey(1, 0));
    EXPECT_NE(streamKey(0), streamKey());
    EXPECT_EQ(streamKey(-1), streamKey(~0ull));
}

TEST(Random, AStreamIsAPureFunctionOfItsKeyAndCounter) {
    RandomStream a(3, 5), b(3, 5), other(3, 6);
    for (int i = 0; i < 10; ++i) {
        const std::uint64_t bits = a.bits();
        EXPECT_EQ(bits, b.bits());
        EXPECT_EQ(bits, randomBits(streamKey(3, 5), std::uint64_t(i)));
        EXPECT_NE(bits, other.bits());
    }
}

/// Neighbouring streams and neighbouring counters must look independent: each bit pair agrees half of the time.
TEST(Random, NeighbouringStreamsDoNotCorrelate) {
    constexpr int streams = 20000;
    int agreeAlongKeys[64] = {}, agreeAlongCounter[64] = {};
    for (int i = 0; i < streams; ++i) {
        const std::uint64_t here = randomBits(streamKey(7, i), 0);
        const std::uint64_t nextKey = ~(here ^ randomBits(streamKey(7, i + 1), 0));
        const std::uint64_t nextCounter = ~(here ^ randomBits(streamKey(7, i), 1));
        for (int bit = 0; bit < 64; ++bit) {
            agreeAlongKeys[bit] += int(nextKey >> bit & 1);
            agreeAlongCounter[bit] += int(nextCounter >> bit & 1);
        }
    }
    // Binomial with sigma = sqrt(20000)/2 = 70.7; of 128 comparisons none is beyond 5 sigma but once in 10^4 runs.
    for (int bit = 0; bit < 64; ++bit) {
        EXPECT_NEAR(agreeAlongKeys[bit], streams / 2, 354) << "bit " << bit;
        EXPECT_NEAR(agreeAlongCounter[bit], streams / 2, 354) << "bit " << bit;
    }
}

TEST(Random, UniformInARange) {
    RandomStream stream(11);
    double sum = 0;
    for (int i = 0; i < 100000; ++i) {
        const double x = stream.uniform(-2, 6);
        ASSERT_GE(x, -2);
        ASSERT_LT(x, 6);
        sum += x;
    }
    // Standard error 8 / sqrt(12 x 100000) = 0.0073.
    EXPECT_NEAR(sum / 100000, 2, 5 * 0.0073);
}

} // namespace
} // namespace vitrine
