// Levels of an image in a file.
#include "made_image.h"
#include "textures/image_pyramid.h"

#include <gtest/gtest.h>

#include <half.h>

namespace vitrine {
namespace {

using test::scattered;

/// What the file holds of a level.
std::vector<float> texels(const TexelFile& file, const ImagePyramid& pyramid, std::size_t index) {
    const ImagePyramid::Level& level = pyramid.levels[index];
    const bool isHalf = pyramid.format == TexelFormat::Half;
    std::vector<float> result;
    for (int y = 0; y < level.height; ++y)
        for (int x = 0; x < level.width; ++x) {
            constexpr int side = ImagePyramid::tileSize;
            const int tile = y / side * level.tilesAcross() + x / side;
            const std::uint64_t at = level.offset + std::uint64_t(tile) * pyramid.tileBytes() +
                                     std::uint64_t(y % side * side + x % side) * pyramid.texelBytes();
            for (int c = 0; c < pyramid.channels; ++c) {
                half narrow;
                float wide = 0;
                if (isHalf) {
                    EXPECT_TRUE(file.read(at + std::uint64_t(c) * 2, &narrow, 2));
                    wide = narrow;
                } else {
                    EXPECT_TRUE(file.read(at + std::uint64_t(c) * 4, &wide, 4));
                }
                result.push_back(wide);
            }
        }
    return result;
}

ImagePyramid write(TexelFile& file, int width, int height, int channels, TexelFormat format) {
    PyramidWriter writer(file, width, height, channels, format);
    for (int y = 0; y < height; ++y) {
        std::vector<float> row;
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c)
                row.push_back(scattered(x, y, c));
        writer.addRow(row.data());
    }
    return writer.pyramid();
}

TEST(ImagePyramid, HasTheImageAndHalvesOfIt) {
    TexelFile file;
    const ImagePyramid pyramid = write(file, 130, 67, 3, TexelFormat::Float);
    const std::vector<std::pair<int, int>> expected = {{130, 67}, {65, 33}, {32, 16}, {16, 8},
                                                       {8, 4},    {4, 2},   {2, 1},   {1, 1}};
    ASSERT_EQ(pyramid.levels.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(std::pair(pyramid.levels[i].width, pyramid.levels[i].height), expected[i]);
    const std::vector<float> finest = texels(file, pyramid, 0);
    for (int y = 0; y < 67; ++y)
        for (int x = 0; x < 130; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(finest[std::size_t((y * 130 + x) * 3 + c)], scattered(x, y, c));
}

TEST(ImagePyramid, TexelsAreMeansOfTheAreaThatTheyCover) {
    TexelFile file;
    constexpr int width = 13, height = 7;
    const ImagePyramid pyramid = write(file, width, height, 1, TexelFormat::Float);
    const std::vector<float> finest = texels(file, pyramid, 0), next = texels(file, pyramid, 1);
    ASSERT_EQ(next.size(), 6u * 3u);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 6; ++x) {
            double sum = 0;
            for (int j = 0; j < height; ++j)
                for (int i = 0; i < width; ++i) {
                    const auto overlap = [](double begin, double end, int texel) {
                        return std::max(0., std::min(end, texel + 1.) - std::max(begin, double(texel)));
                    };
                    sum += double(finest[std::size_t(j * width + i)]) *
                           overlap(x * width / 6., (x + 1) * width / 6., i) *
                           overlap(y * height / 3., (y + 1) * height / 3., j);
                }
            EXPECT_NEAR(next[std::size_t(y * 6 + x)], sum / (width / 6. * height / 3.), 1e-6);
        }
}

TEST(ImagePyramid, EveryLevelHasTheImagesMean) {
    TexelFile file;
    for (const auto& [width, height] :
         {std::pair(1, 1), {1, 9}, {300, 1}, {64, 64}, {65, 63}, {129, 255}, {2, 3}, {511, 3}}) {
        const ImagePyramid pyramid = write(file, width, height, 2, TexelFormat::Float);
        for (std::size_t c = 0; c < 2; ++c) {
            std::vector<double> means;
            for (std::size_t level = 0; level < pyramid.levels.size(); ++level) {
                const std::vector<float> values = texels(file, pyramid, level);
                double sum = 0;
                for (std::size_t i = c; i < values.size(); i += 2)
                    sum += double(values[i]);
                means.push_back(sum / double(values.size() / 2));
            }
            for (const double mean : means)
                EXPECT_NEAR(mean, means[0], 1e-6) << width << " x " << height;
        }
    }
}

TEST(ImagePyramid, HalvesAreRoundedOnce) {
    TexelFile file;
    const ImagePyramid narrow = write(file, 100, 70, 3, TexelFormat::Half);
    const ImagePyramid wide = write(file, 100, 70, 3, TexelFormat::Float);
    for (std::size_t level = 0; level < narrow.levels.size(); ++level) {
        const std::vector<float> rounded = texels(file, narrow, level), values = texels(file, wide, level);
        for (std::size_t i = 0; i < values.size(); ++i)
            ASSERT_EQ(rounded[i], float(half(values[i])));
    }
}

} // namespace
} // namespace vitrine
