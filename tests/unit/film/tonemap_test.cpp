#include "film/tonemap.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace vitrine {
namespace {

Image pixel(std::vector<float> values) {
    return Image{1, 1, int(values.size()), std::move(values)};
}

constexpr ToneMap allMaps[] = {ToneMap::None, ToneMap::Reinhard, ToneMap::Filmic};

TEST(ToneMapping, NoneIsExposureAlone) {
    EXPECT_EQ(toneMapped(pixel({0.25f, -1, 3}), 0, ToneMap::None).pixels, (std::vector<float>{0.25f, -1, 3}));
    EXPECT_EQ(toneMapped(pixel({0.25f, -1, 3}), 2, ToneMap::None).pixels, (std::vector<float>{1, -4, 12}));
    EXPECT_EQ(toneMapped(pixel({8, 4, 2}), -1, ToneMap::None).pixels, (std::vector<float>{4, 2, 1}));
}

TEST(ToneMapping, ReinhardCompressesLuminanceAndKeepsHue) {
    EXPECT_NEAR(toneMapped(pixel({1, 1, 1}), 0, ToneMap::Reinhard).pixels[1], 0.5f, 1e-6f);
    EXPECT_NEAR(toneMapped(pixel({3}), 0, ToneMap::Reinhard).pixels[0], 0.75f, 1e-6f);
    const auto mapped = toneMapped(pixel({4, 2, 1}), 1, ToneMap::Reinhard).pixels;
    EXPECT_NEAR(mapped[0] / mapped[1], 2, 1e-6f);
    EXPECT_NEAR(mapped[1] / mapped[2], 2, 1e-6f);
}

TEST(ToneMapping, FilmicHasFilmsShoulderAndToe) {
    const auto grey = [](float x) { return toneMapped(pixel({x}), 0, ToneMap::Filmic).pixels[0]; };
    EXPECT_NEAR(grey(0), 0, 1e-3f);
    // The fitted curve at 0.18 and at 1: (x (x + 0.0245786) - 0.000090537) / (x (0.983729 x + 0.432951) + 0.238081).
    EXPECT_NEAR(grey(0.18f), 0.10559f, 1e-4f);
    EXPECT_NEAR(grey(1), 0.61912f, 1e-4f);
    EXPECT_LT(grey(20), 1);
    EXPECT_EQ(grey(30), 1);
    // Bright saturated light bleaches.
    const auto red = toneMapped(pixel({50, 0, 0}), 0, ToneMap::Filmic).pixels;
    EXPECT_GT(red[1], 0.3f);
}

TEST(ToneMapping, EveryOperatorGrowsWithTheLightAndStaysFinite) {
    for (ToneMap map : allMaps) {
        float previous = -1;
        for (int i = -40; i <= 40; ++i) {
            const float value = toneMapped(pixel({1, 1, 1}), float(i), map).pixels[0];
            EXPECT_GE(value, previous) << int(map) << " " << i;
            EXPECT_TRUE(std::isfinite(value));
            previous = value;
        }
        for (float extreme : {1e30f, -1e30f})
            for (float v : toneMapped(pixel({extreme, 1, 0}), 0, map).pixels)
                EXPECT_TRUE(std::isfinite(v)) << int(map);
    }
}

TEST(ToneMapping, ChannelsBeyondColourStay) {
    for (ToneMap map : allMaps) {
        EXPECT_EQ(toneMapped(pixel({1, 2, 3, 0.5f, 7}), 3, map).pixels[3], 0.5f);
        EXPECT_EQ(toneMapped(pixel({1, 2, 3, 0.5f, 7}), 3, map).pixels[4], 7);
        EXPECT_EQ(toneMapped(pixel({1, 0.25f}), 3, map).pixels[1], 0.25f);
    }
}

TEST(ToneMapping, NamesAreKnownAndOthersRefused) {
    for (const auto& name : toneMapNames())
        EXPECT_EQ(toneMapNames()[std::size_t(toneMapNamed(name))], name);
    EXPECT_EQ(toneMapNamed("filmic"), ToneMap::Filmic);
    try {
        toneMapNamed("reinhart");
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("did you mean \"reinhard\"?"));
    }
    EXPECT_THROW(toneMapped(pixel({1}), infinity, ToneMap::None), std::invalid_argument);
    EXPECT_THROW(toneMapped(pixel({1}), std::nanf(""), ToneMap::None), std::invalid_argument);
}

} // namespace
} // namespace vitrine
