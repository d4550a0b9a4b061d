// The reference scenes against pictures made by pbrt-v4 (tests/images/references/README.md): means and 8 x 8 blocks
// within the noise of both.
#include "reference_picture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vitrine {
namespace {

constexpr int runs = 8, blockSide = 8;

/// Mean and variance of the mean of a quantity over independent runs.
struct Estimate {
    double mean = 0, variance = 0;
};

Estimate overRuns(const std::vector<double>& values) {
    Estimate e;
    for (const double v : values)
        e.mean += v / double(values.size());
    for (const double v : values)
        e.variance += (v - e.mean) * (v - e.mean);
    e.variance /= double(values.size()) * double(values.size() - 1);
    return e;
}

class Reference : public testing::TestWithParam<const char*> {};

TEST_P(Reference, MeanAndBlocksAgreeWithinNoise) {
    const ReferencePicture reference = readReference(GetParam());
    const int width = reference.width, height = reference.height;

    std::vector<Image> images;
    for (int run = 0; run < runs; ++run) {
        Overrides overrides;
        overrides.seed = std::uint64_t(run);
        images.push_back(renderReference(GetParam(), overrides, {128}).front());
        ASSERT_EQ(images.back().width, width);
        ASSERT_EQ(images.back().height, height);
    }

    int blocks = 0, close = 0;
    for (int c = 0; c < 3; ++c) {
        const auto compare = [&](int x0, int y0, int x1, int y1) {
            std::vector<double> ours;
            for (const auto& image : images)
                ours.push_back(meanOf(x0, y0, x1, y1, [&](int x, int y) { return double(image.at(x, y, c)); }));
            Estimate theirs;
            theirs.mean = meanOf(x0, y0, x1, y1, [&](int x, int y) { return reference.mean(x, y, c); });
            theirs.variance = meanOf(x0, y0, x1, y1, [&](int x, int y) { return reference.variance(x, y, c); }) /
                              (double(x1 - x0) * (y1 - y0));
            return std::pair(overRuns(ours), theirs);
        };
        const auto [ours, theirs] = compare(0, 0, width, height);
        const double sigma = std::sqrt(ours.variance + theirs.variance);
        EXPECT_NEAR(ours.mean, theirs.mean, std::max(0.005 * theirs.mean, 4 * sigma)) << "channel " << c;
        RecordProperty("ratio" + std::to_string(c), std::to_string(ours.mean / theirs.mean));

        for (int y = 0; y < height; y += blockSide)
            for (int x = 0; x < width; x += blockSide) {
                const auto [a, b] = compare(x, y, x + blockSide, y + blockSide);
                ++blocks;
                close += std::abs(a.mean - b.mean) <= 4 * std::sqrt(a.variance + b.variance) + 0.01 * b.mean;
            }
    }
    EXPECT_GE(double(close), 0.97 * blocks);
    RecordProperty("blocksWithinNoise", std::to_string(double(close) / blocks));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Reference, testing::Values("box", "caustic", "dof", "goblet", "vase"),
                         [](const auto& scene) { return std::string(scene.param); });

} // namespace
} // namespace vitrine
