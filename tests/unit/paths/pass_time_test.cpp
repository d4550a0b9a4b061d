#include "paths/pass_time.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace vitrine {
namespace {

TEST(PassTime, EvenOverTheShutter) {
    const Shutter shutter{0.5, 2};
    for (const std::uint64_t seed : {0, 1, 77}) {
        // Of 3^k passes that begin at a multiple of that, one in each of as many equal parts.
        for (const std::uint64_t first : {0, 243}) {
            std::vector<double> places;
            for (std::uint64_t pass = first; pass < first + 243; ++pass) {
                const double time = passTime(shutter, pass, seed);
                EXPECT_GE(time, 0.5);
                EXPECT_LT(time, 2);
                places.push_back((time - 0.5) / 1.5);
            }
            std::sort(places.begin(), places.end());
            for (std::size_t i = 1; i < places.size(); ++i)
                EXPECT_NEAR(places[i] - places[i - 1], 1. / 243, 1e-9);
        }
    }
    EXPECT_NE(passTime(shutter, 0, 1), passTime(shutter, 0, 2)) << "another seed, other times";
    EXPECT_GE(passTime(shutter, ~std::uint64_t(0), 3), 0.5) << "the last pass there can be";
}

} // namespace
} // namespace vitrine
