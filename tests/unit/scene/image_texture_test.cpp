// Texture "imagemap": what a file's values mean.
#include "film/srgb.h"
#include "scene_text.h"
#include "support/image_files.h"
#include "support/temporary_folder.h"
#include "support/texture_points.h"
#include "texture_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace vitrine {
namespace {

using test::TemporaryFolder;
using test::writeFile;

class ImageTexture : public testing::Test {
  protected:
    /// A file of this form.
    std::string file(const std::string& name, OIIO::TypeDesc type, int width, int channels,
                     const std::vector<float>& values) {
        const int height = int(values.size()) / width / channels;
        OIIO::ImageSpec spec(width, height, channels, type);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        writeFile(folder_.file(name), spec, values);
        return folder_.file(name);
    }
    std::string texture(const char* kind, const std::string& path, const std::string& parameters = "") {
        return fmt::format("Texture \"t\" \"{}\" \"imagemap\" \"string filename\" \"{}\" {}\n", kind, path, parameters);
    }
    float number(const std::string& path, const std::string& parameters = "",
                 const TexturePoint& at = uvAt({0.5, 0.5})) {
        return Textures(texture("float", path, parameters)).number("t", at);
    }

    TemporaryFolder folder_;
};

TEST_F(ImageTexture, LiesWithItsUpperRowWhereVIsOne) {
    const std::string path = file("a.exr", OIIO::TypeFloat, 2, 1, {1, 2, 3, 4});
    EXPECT_EQ(number(path, "", uvAt({0.25, 0.75})), 1);
    EXPECT_EQ(number(path, "", uvAt({0.75, 0.75})), 2);
    EXPECT_EQ(number(path, "", uvAt({0.25, 0.25})), 3);
    EXPECT_EQ(number(path, "", uvAt({0.75, 0.25})), 4);
    EXPECT_EQ(number(path, "", uvAt({0.5, 0.5})), 2.5f);
    EXPECT_EQ(number(path, "\"float uscale\" 3 \"float udelta\" -1", uvAt({0.25, 0.75})), 2);
}

TEST_F(ImageTexture, WrapsAndFiltersArrive) {
    const std::string path = file("a.exr", OIIO::TypeFloat, 2, 1, {1, 2, 3, 4});
    const auto beyond = [&](const std::string& wrap) { return number(path, wrap, uvAt({1.75, 0.75})); };
    EXPECT_EQ(beyond(""), 2);
    EXPECT_EQ(number(path, "", uvAt({1.25, 0.75})), 1);
    EXPECT_EQ(beyond("\"string wrap\" \"repeat\""), 2);
    EXPECT_EQ(number(path, "\"string wrap\" \"clamp\"", uvAt({1.25, 0.75})), 2);
    EXPECT_EQ(beyond("\"string wrap\" \"black\""), 0);

    // A footprint of one texel along s and half a texel along t.
    const TexturePoint spread = uvAt({0.4f, 0.7f}, V2f(0.5, 0), V2f(0, 0.25));
    const auto filtered = [&](const char* filter, const char* more = "") {
        return number(path, fmt::format("\"string filter\" \"{}\" {}", filter, more), spread);
    };
    EXPECT_EQ(filtered("point"), 2.5f);
    EXPECT_EQ(filtered("bilinear"), 2.5f);
    EXPECT_EQ(filtered("trilinear"), 2.5f);
    EXPECT_EQ(number(path, "\"string filter\" \"point\"", uvAt({0.4f, 0.6f})), 1);
    EXPECT_NEAR(number(path, "\"string filter\" \"trilinear\"", uvAt({0.4f, 0.6f})),
                0.7f * (0.7f * 1 + 0.3f * 2) + 0.3f * (0.7f * 3 + 0.3f * 4), 1e-5);
    const std::string wide = file("wide.exr", OIIO::TypeFloat, 64, 1, [] {
        std::vector<float> stripes;
        for (int i = 0; i < 64 * 64; ++i)
            stripes.push_back(float(i % 64 / 4 % 2));
        return stripes;
    }());
    const TexturePoint tall = uvAt({2.f / 64, 0.5}, V2f(0.01f, 0), V2f(0, 0.1f));
    EXPECT_LT(number(wide, "\"string filter\" \"ewa\"", tall), 0.05f);
    EXPECT_GT(number(wide, "\"string filter\" \"ewa\" \"float maxanisotropy\" 1", tall), 0.2f);
}

TEST_F(ImageTexture, EncodingsOfBytes) {
    std::vector<float> codes;
    for (int i = 0; i < 256; ++i)
        codes.push_back(float(i) / 255);
    const std::string path = file("a.png", OIIO::TypeUInt8, 256, 1, codes);
    Textures standard(texture("float", path)), srgb(texture("float", path, "\"string encoding\" \"sRGB\"")),
        linear(texture("float", path, "\"string encoding\" \"linear\"")),
        gamma(texture("float", path, "\"string encoding\" \"gamma 2.2\""));
    for (int i = 0; i < 256; ++i) {
        const TexturePoint at = uvAt({(float(i) + 0.5f) / 256, 0.5});
        const double code = i / 255.;
        // Halves hold 11 bits; below 2^-14 steps of 2^-24.
        const auto near = [](double value) { return testing::DoubleNear(value, value / 4096 + 0x1p-24); };
        EXPECT_THAT(double(standard.number("t", at)), near(linearFromSrgb(code)));
        EXPECT_EQ(srgb.number("t", at), standard.number("t", at));
        EXPECT_THAT(double(linear.number("t", at)), near(code));
        EXPECT_THAT(double(gamma.number("t", at)), near(std::pow(code, 2.2)));
    }
}

TEST_F(ImageTexture, SixteenBitsStayAsFineAsTheyAre) {
    const std::string path = file("a.png", OIIO::TypeUInt16, 2, 1, {30001.f / 65535, 30001.f / 65535});
    EXPECT_FLOAT_EQ(number(path, "\"string encoding\" \"linear\""), 30001.f / 65535);
    EXPECT_FLOAT_EQ(number(path), float(linearFromSrgb(30001. / 65535)));
}

TEST_F(ImageTexture, FloatsAreLinear) {
    const std::string path = file("a.exr", OIIO::TypeFloat, 1, 1, {0.123456f});
    EXPECT_EQ(number(path), 0.123456f);
    EXPECT_EQ(number(path, "\"string encoding\" \"sRGB\""), 0.123456f);
    Textures told(texture("float", path, "\"string encoding\" \"sRGB\""));
    told.number("t");
    ASSERT_EQ(told.warnings().size(), 1u);
    EXPECT_EQ(told.warnings()[0].message, path + " holds floats: \"encoding\" does not matter");
    Textures quiet(texture("float", path, "\"string encoding\" \"linear\""));
    quiet.number("t");
    EXPECT_EQ(quiet.warnings().size(), 0u);
}

TEST_F(ImageTexture, ScaleComesBeforeInvert) {
    const std::string path = file("a.exr", OIIO::TypeFloat, 1, 1, {0.25f});
    EXPECT_EQ(number(path, "\"float scale\" 3"), 0.75f);
    EXPECT_EQ(number(path, "\"bool invert\" true"), 0.75f);
    EXPECT_EQ(number(path, "\"float scale\" 3 \"bool invert\" true"), 0.25f);
    EXPECT_EQ(number(path, "\"float scale\" 5 \"bool invert\" true"), 0);
    EXPECT_EQ(number(path, "\"float scale\" -1"), -0.25f);
}

TEST_F(ImageTexture, NumbersAreMeansOfColoursOrAlpha) {
    EXPECT_FLOAT_EQ(number(file("rgb.exr", OIIO::TypeFloat, 1, 3, {1, 2, 6})), 3);
    EXPECT_FLOAT_EQ(number(file("opaque.exr", OIIO::TypeFloat, 2, 4, {1, 2, 6, 1, 1, 2, 6, 1})), 3);
    const std::string clear = file("clear.exr", OIIO::TypeFloat, 2, 4, {1, 2, 6, 1, 1, 2, 6, 0.5f});
    EXPECT_FLOAT_EQ(number(clear, "", uvAt({0.25, 0.5})), 1);
    EXPECT_FLOAT_EQ(number(clear, "", uvAt({0.75, 0.5})), 0.5f);
    // Not by the sRGB curve.
    EXPECT_NEAR(number(file("clear.png", OIIO::TypeUInt8, 1, 4, {1, 1, 1, 102.f / 255})), 102. / 255, 1e-4);
    EXPECT_NEAR(number(file("grey.png", OIIO::TypeUInt8, 1, 2, {1, 102.f / 255})), 1, 1e-4);
}

TEST_F(ImageTexture, WhatIsNotFiniteCountsAsZero) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::string path = file("a.exr", OIIO::TypeFloat, 2, 1, {nan, 3, -infinity, 5});
    Textures textures(texture("float", path));
    EXPECT_EQ(textures.number("t", uvAt({0.25, 0.75})), 0);
    EXPECT_EQ(textures.number("t", uvAt({0.25, 0.25})), 0);
    EXPECT_EQ(textures.number("t", uvAt({0.5, 0.5})), 2);
    ASSERT_EQ(textures.warnings().size(), 1u);
    EXPECT_EQ(textures.warnings()[0].message,
              path + " has 2 values that are infinite or not a number; they count as 0");
}

TEST_F(ImageTexture, AllFormatsAndLayoutsAreRead) {
    // Larger than a tile, and cropped.
    constexpr int width = 150, height = 90;
    std::vector<float> values;
    for (int i = 0; i < width * height; ++i)
        for (int c = 0; c < 3; ++c)
            values.push_back(float((i * 7 + c * 50) % 256) / 255);
    for (const std::string name :
         {"a.png", "a.tif", "a.exr", "a.tga", "a.bmp", "a.hdr", "tiled.tif", "tiled.exr", "crop.exr"}) {
        OIIO::ImageSpec spec(width, height, 3, OIIO::TypeUInt8);
        if (name.ends_with("exr")) spec.set_format(OIIO::TypeFloat);
        if (name.starts_with("tiled")) spec.tile_width = spec.tile_height = 32;
        if (name.starts_with("crop")) {
            spec.x = 20;
            spec.y = -7;
        }
        std::vector<float> written = values;
        const auto out = OIIO::ImageOutput::create(folder_.file(name));
        ASSERT_TRUE(out && out->open(folder_.file(name), spec)) << name;
        ASSERT_TRUE(out->write_image(OIIO::TypeFloat, written.data())) << name;
        ASSERT_TRUE(out->close());
        Textures textures(texture("float", folder_.file(name)));
        const bool bytes = spec.format == OIIO::TypeUInt8 && name != "a.hdr";
        for (const auto& [x, y] : {std::pair(0, 0), {149, 0}, {64, 63}, {63, 64}, {149, 89}, {100, 70}}) {
            double mean = 0;
            for (int c = 0; c < 3; ++c) {
                const double value = double(values[std::size_t((y * width + x) * 3 + c)]);
                mean += (bytes ? linearFromSrgb(value) : value) / 3;
            }
            EXPECT_NEAR(textures.number("t", uvAt({(float(x) + 0.5f) / width, 1 - (float(y) + 0.5f) / height})), mean,
                        name == "a.hdr" ? 0.01 : 5e-4)
                << name << ' ' << x << ' ' << y;
        }
    }
}

TEST_F(ImageTexture, OptionBoundsTheCache) {
    const std::string path = file("a.exr", OIIO::TypeFloat, 1, 1, {1});
    const auto withCache = [&](const std::string& value) {
        return errorsOf("Option \"texturecachemb\" " + value + "\nWorldBegin\n" + texture("float", path));
    };
    EXPECT_EQ(withCache("1"), Lines{});
    EXPECT_EQ(withCache("1048576"), Lines{});
    EXPECT_EQ(withCache("0"), Lines{"1:8: error: option \"texturecachemb\" must lie in [1, 1048576]"});
    EXPECT_EQ(withCache("1048577"), Lines{"1:8: error: option \"texturecachemb\" must lie in [1, 1048576]"});
    Overrides overrides;
    overrides.textureCacheMegabytes = 2;
    EXPECT_EQ(errorsOf("Option \"texturecachemb\" 0\nWorldBegin\n" + texture("float", path), overrides), Lines{});
}

TEST_F(ImageTexture, TheCachesSizeIsNoneOfThePicture) {
    const std::string text = "WorldBegin\n" + texture("float", file("a.exr", OIIO::TypeFloat, 1, 1, {1}));
    Overrides overrides;
    overrides.textureCacheMegabytes = 2;
    EXPECT_EQ(built(text, overrides).fingerprint, built(text).fingerprint);
}

} // namespace
} // namespace vitrine
