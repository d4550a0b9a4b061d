#include "core/errors.h"
#include "film/imageio.h"
#include "film/primaries.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace vitrine {
namespace {

constexpr float none[8] = {}, rec709[8] = {0.64f, 0.33f, 0.3f, 0.6f, 0.15f, 0.06f, 0.3127f, 0.329f},
                rec2020[8] = {0.708f, 0.292f, 0.17f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.329f};

Image pixel(const V3f& rgb) {
    return Image{1, 1, 3, {rgb.x, rgb.y, rgb.z}};
}

TEST(Primaries, Rec709IsLeftAlone) {
    const Image image = pixel(V3f(0.1f, 2, -3));
    EXPECT_EQ(inRec709(image, none).pixels, image.pixels);
    EXPECT_EQ(inRec709(image, rec709).pixels, image.pixels);
    const Image grey{1, 1, 1, {0.3f}};
    EXPECT_EQ(inRec709(grey, rec2020).pixels, grey.pixels);
}

TEST(Primaries, Rec2020BecomesRec709) {
    // The matrix of ITU-R BT.2087 (BT.2020 to BT.709), to its four figures.
    const float expected[3][3] = {
        {1.6605f, -0.1246f, -0.0182f}, {-0.5876f, 1.1329f, -0.1006f}, {-0.0728f, -0.0083f, 1.1187f}};
    for (int i = 0; i < 3; ++i) {
        V3f unit(0);
        unit[i] = 1;
        const Image image = inRec709(pixel(unit), rec2020);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(image.at(0, 0, c), expected[i][c], 1e-4f) << i << c;
    }
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(inRec709(pixel(V3f(1)), rec2020).at(0, 0, c), 1, 1e-5f);
}

TEST(Primaries, FilesForScreensAreConverted) {
    const test::TemporaryFolder folder;
    const Image image = pixel(V3f(0.5f, 0.3f, 0.2f));
    ImageMetadata metadata;
    std::copy_n(rec2020, 8, metadata.chromaticities);
    writeImage(folder.file("a.pfm"), image, metadata);
    EXPECT_EQ(readImage(folder.file("a.pfm")).pixels, inRec709(image, rec2020).pixels);
    writeImage(folder.file("a.exr"), image, metadata);
    EXPECT_EQ(readImage(folder.file("a.exr")).pixels, image.pixels);
}

TEST(Primaries, DegenerateOnesAreRefused) {
    const float line[8] = {0.3f, 0.3f, 0.3f, 0.3f, 0.15f, 0.06f, 0.3127f, 0.329f};
    EXPECT_THROW(inRec709(pixel(V3f(1)), line), std::invalid_argument);
    const float zeroY[8] = {0.7f, 0, 0.17f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.329f};
    EXPECT_THROW(inRec709(pixel(V3f(1)), zeroY), std::invalid_argument);
}

TEST(ColourChannels, AreFoundByNameOrPlace) {
    const Image image{1, 1, 4, {1, 2, 3, 4}};
    EXPECT_EQ(colourChannels(image, {"B", "Depth.Z", "G", "R"}).pixels, (std::vector<float>{4, 3, 1}));
    for (const std::vector<std::string>& others :
         {std::vector<std::string>{"X", "Y", "Z", "A"}, {"Y", "RY", "BY", "A"}})
        EXPECT_THROW(colourChannels(image, others), std::invalid_argument);
    EXPECT_EQ(colourChannels(image, {}).pixels, (std::vector<float>{1, 2, 3}));
    EXPECT_EQ(colourChannels(Image{1, 1, 2, {7, 8}}, {"Y", "A"}).pixels, (std::vector<float>{7}));
}

TEST(ColourChannels, PicturesOfOtherThingsAreRefusedByName) {
    const test::TemporaryFolder folder;
    ImageMetadata metadata;
    metadata.channelNames = {"X", "Y", "Z"};
    writeImage(folder.file("a.exr"), pixel(V3f(0.8f, 0.4f, 0.1f)), metadata);
    try {
        readColours(folder.file("a.exr"), metadata);
        FAIL() << "no error";
    } catch (const FileError& e) {
        EXPECT_THAT(e.what(), testing::HasSubstr("there are no channels R, G and B, but X, Y, Z"));
    }
}

} // namespace
} // namespace vitrine
