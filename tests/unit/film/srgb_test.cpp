#include "film/srgb.h"

#include <gtest/gtest.h>

#include <limits>

namespace vitrine {
namespace {

TEST(Srgb, CurvesAreInverses) {
    for (int i = -100; i <= 300; ++i)
        EXPECT_NEAR(srgbFromLinear(linearFromSrgb(i / 100.)), i / 100., 1e-4);
    EXPECT_EQ(srgbFromLinear(0), 0);
    EXPECT_NEAR(srgbFromLinear(1), 1, 1e-12);
    EXPECT_NEAR(srgbFromLinear(0.18), 0.46136, 1e-5); // mid grey, IEC 61966-2-1
}

TEST(Srgb, BytesAreTheNearestCode) {
    for (int i = 0; i <= 200000; ++i) {
        const float x = float(i) / 190000 - 0.01f;
        const double exact = 255 * srgbFromLinear(std::min(1., std::max(0., double(x))));
        // On the border itself either neighbour is as near.
        ASSERT_LE(std::abs(double(srgbByte(x)) - exact), 0.5 + 1e-4) << x;
    }
    for (int code = 0; code < 256; ++code)
        EXPECT_EQ(srgbByte(float(linearFromSrgb(code / 255.))), code);
}

TEST(Srgb, BytesOfExtremesAreClamped) {
    const float inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(srgbByte(inf), 255);
    EXPECT_EQ(srgbByte(1e30f), 255);
    EXPECT_EQ(srgbByte(-inf), 0);
    EXPECT_EQ(srgbByte(-0.f), 0);
    EXPECT_EQ(srgbByte(std::numeric_limits<float>::quiet_NaN()), 0);
}

} // namespace
} // namespace vitrine
