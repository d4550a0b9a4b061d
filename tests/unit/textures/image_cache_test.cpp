// Lookups in images that lie on disk.
#include "made_image.h"
#include "textures/image_cache.h"

#include <gtest/gtest.h>

#include <thread>

namespace vitrine {
namespace {

using test::centre;
using test::makeCache;
using test::makeImage;
using test::scattered;

/// The texel that `wrap` puts at any column and row.
float wrapped(const V2i& size, ImageWrap wrap, int x, int y, int c) {
    const auto one = [&](int i, int n) {
        if (wrap == ImageWrap::Clamp) return std::clamp(i, 0, n - 1);
        if (wrap == ImageWrap::Repeat) return ((i % n) + n) % n;
        return i >= 0 && i < n ? i : -1;
    };
    const int i = one(x, size.x), j = one(y, size.y);
    return i < 0 || j < 0 ? 0 : scattered(i, j, c);
}

class Wraps : public testing::TestWithParam<std::tuple<ImageWrap, std::pair<int, int>>> {};

TEST_P(Wraps, AtAndBetweenTexelsWithinAndBeyondTheEdges) {
    const auto [wrap, wh] = GetParam();
    const V2i size(wh.first, wh.second);
    const auto cache = makeCache();
    const auto image = makeImage(*cache, size, 3, scattered);
    for (int y = -3; y < size.y + 3; ++y)
        for (int x = -3; x < size.x + 3; ++x) {
            const V2d at = centre(*image, x, y);
            const Texel nearest = image->look(0, at, wrap, TexelInterpolation::Nearest);
            const Texel there = image->look(0, at, wrap, TexelInterpolation::Bilinear);
            const V2d step(0.25 / size.x, 0.75 / size.y);
            const Texel between = image->look(0, at + step, wrap, TexelInterpolation::Bilinear);
            for (int c = 0; c < 3; ++c) {
                const auto k = std::size_t(c);
                const auto value = [&](int i, int j) { return wrapped(size, wrap, x + i, y + j, c); };
                EXPECT_EQ(nearest[k], value(0, 0)) << x << ' ' << y;
                // Coordinates are rounded to 2^-24 of the image and more beyond it.
                EXPECT_NEAR(there[k], value(0, 0), 1e-4);
                EXPECT_NEAR(between[k],
                            0.25f * (0.75f * value(0, 0) + 0.25f * value(1, 0)) +
                                0.75f * (0.75f * value(0, 1) + 0.25f * value(1, 1)),
                            1e-4);
            }
            EXPECT_EQ(there[3], 0);
        }
}

INSTANTIATE_TEST_SUITE_P(ImageCache, Wraps,
                         testing::Combine(testing::Values(ImageWrap::Repeat, ImageWrap::Black, ImageWrap::Clamp),
                                          testing::Values(std::pair(1, 1), std::pair(5, 1), std::pair(8, 8),
                                                          std::pair(130, 70))));

TEST(ImageCache, FarAwayIsNothingSpecial) {
    const auto cache = makeCache();
    const auto image = makeImage(*cache, V2i(16, 16), 1, scattered);
    const auto at = [&](double s, ImageWrap wrap) {
        return image->look(0, V2d(s, 0.5 / 16), wrap, TexelInterpolation::Nearest)[0];
    };
    for (const double far : {1e9, 1e15, 1e300}) {
        EXPECT_EQ(at(far, ImageWrap::Clamp), scattered(15, 0, 0));
        EXPECT_EQ(at(-far, ImageWrap::Clamp), scattered(0, 0, 0));
        EXPECT_EQ(at(far, ImageWrap::Black), 0);
    }
    EXPECT_EQ(at(1e9 + 2.5 / 16, ImageWrap::Repeat), scattered(2, 0, 0));
    EXPECT_EQ(at(-1e9 + 2.5 / 16, ImageWrap::Repeat), scattered(2, 0, 0));
}

/// Values at scattered places of all levels, found by so many threads.
std::vector<Texel> manyLookups(const CachedImage& image, std::size_t threads) {
    constexpr std::size_t count = 20000;
    std::vector<Texel> result(count);
    std::vector<std::thread> workers;
    for (std::size_t t = 0; t < threads; ++t)
        workers.emplace_back([&, t] {
            for (std::size_t i = t; i < count; i += threads) {
                const V2d at(double(scattered(int(i), 1, 0)), double(scattered(int(i), 2, 0)));
                result[i] = image.look(int(i) % image.levels(), at, ImageWrap::Repeat, TexelInterpolation::Bilinear);
            }
        });
    for (auto& worker : workers)
        worker.join();
    return result;
}

TEST(ImageCache, NeitherItsSizeNorThreadsChangeValues) {
    constexpr std::size_t megabyte = 1 << 20;
    // 32 MB of texels.
    const auto large = makeCache(256), small = makeCache(1);
    const auto all = makeImage(*large, V2i(2048, 1024), 3, scattered);
    const auto few = makeImage(*small, V2i(2048, 1024), 3, scattered);
    const std::vector<Texel> values = manyLookups(*all, 1);
    EXPECT_EQ(manyLookups(*all, 3), values);
    EXPECT_EQ(manyLookups(*few, 1), values);
    EXPECT_EQ(manyLookups(*few, 3), values);
    EXPECT_GT(large->memory(), 20 * megabyte);
    // Each thread may hold a few tiles of 48 KB more.
    EXPECT_LT(small->memory(), 3 * megabyte / 2);
}

TEST(ImageCache, LivesAsLongAsItsImages) {
    std::shared_ptr<const CachedImage> image;
    {
        const auto cache = makeCache();
        image = makeImage(*cache, V2i(100, 100), 1, scattered);
    }
    EXPECT_EQ(image->look(0, centre(*image, 70, 80), ImageWrap::Repeat, TexelInterpolation::Nearest)[0],
              scattered(70, 80, 0));
}

TEST(ImageCache, KeepsImagesApart) {
    const auto cache = makeCache();
    std::vector<std::shared_ptr<const CachedImage>> images;
    for (int i = 0; i < 300; ++i)
        images.push_back(
            makeImage(*cache, V2i(3, 2), 1, [&](int x, int y, int) { return float(100 * i + 10 * y + x); }));
    for (int i = 0; i < 300; ++i) {
        const CachedImage& image = *images[std::size_t(i)];
        EXPECT_EQ(image.look(0, centre(image, 2, 1), ImageWrap::Repeat, TexelInterpolation::Nearest)[0],
                  float(100 * i + 12));
    }
}

} // namespace
} // namespace vitrine
