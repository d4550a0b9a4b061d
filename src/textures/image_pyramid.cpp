#include "textures/image_pyramid.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <half.h>

namespace vitrine {

namespace {

/// Of texels 2i, 2i + 1 and 2i + 2 of n in texel i of n/2 (rounded down), which covers n/(n/2) of them: Guthe & Heckbert
/// 2005, "Non-power-of-two mipmap creation".
std::array<float, 3> shares(int n, int i) {
    if (n == 1) return {1, 0, 0};
    if (n % 2 == 0) return {0.5f, 0.5f, 0};
    const int half = n / 2;
    return {float(half - i) / float(n), float(half) / float(n), float(i + 1) / float(n)};
}

/// A row at half the resolution.
void halve(const float* row, int width, int channels, std::vector<float>& halved) {
    const int half = std::max(1, width / 2);
    halved.resize(std::size_t(half * channels));
    const int second = width > 1 ? channels : 0, third = width % 2 == 1 && width > 1 ? 2 * channels : 0;
    for (int i = 0; i < half; ++i) {
        const auto share = shares(width, i);
        const float* const from = row + std::size_t(2 * i * channels);
        for (int c = 0; c < channels; ++c)
            halved[std::size_t(i * channels + c)] =
                share[0] * from[c] + share[1] * from[second + c] + share[2] * from[third + c];
    }
}

} // namespace

/// What is still in memory of a level.
struct PyramidWriter::Strip {
    int row = 0;                 ///< the next
    std::vector<char> tiles;     ///< one row of tiles
    std::vector<half> halves;    ///< one row
    std::vector<float> narrowed; ///< one row at half the width
    std::vector<float> sum;      ///< the coming row of the next level
};

PyramidWriter::PyramidWriter(TexelFile& file, int width, int height, int channels, TexelFormat format) : file_(file) {
    pyramid_.channels = channels;
    pyramid_.format = format;
    for (;; width = std::max(1, width / 2), height = std::max(1, height / 2)) {
        ImagePyramid::Level level{width, height, 0};
        level.offset =
            file.reserve(std::uint64_t(level.tilesAcross()) * std::uint64_t(level.tilesDown()) * pyramid_.tileBytes());
        pyramid_.levels.push_back(level);
        Strip strip;
        strip.tiles.resize(std::size_t(level.tilesAcross()) * pyramid_.tileBytes());
        strip.sum.resize(std::size_t(std::max(1, width / 2) * channels));
        strips_.push_back(std::move(strip));
        if (width == 1 && height == 1) break;
    }
}

PyramidWriter::~PyramidWriter() = default;

void PyramidWriter::store(std::size_t index, const float* row) {
    constexpr int side = ImagePyramid::tileSize;
    const ImagePyramid::Level& level = pyramid_.levels[index];
    Strip& strip = strips_[index];
    const char* from = reinterpret_cast<const char*>(row);
    if (pyramid_.format == TexelFormat::Half) {
        strip.halves.assign(row, row + std::size_t(level.width) * std::size_t(pyramid_.channels));
        from = reinterpret_cast<const char*>(strip.halves.data());
    }
    const int y = strip.row % side;
    if (y == 0) std::fill(strip.tiles.begin(), strip.tiles.end(), char(0));
    for (int x = 0; x < level.width; x += side)
        std::memcpy(strip.tiles.data() + std::size_t(x / side) * pyramid_.tileBytes() +
                        std::size_t(y * side) * pyramid_.texelBytes(),
                    from + std::size_t(x) * pyramid_.texelBytes(),
                    std::size_t(std::min(side, level.width - x)) * pyramid_.texelBytes());
    if (y == side - 1 || strip.row == level.height - 1)
        file_.write(level.offset + std::uint64_t(strip.row / side) * strip.tiles.size(), strip.tiles.data(),
                    strip.tiles.size());
}

void PyramidWriter::addRow(std::size_t index, const float* row) {
    store(index, row);
    const ImagePyramid::Level& level = pyramid_.levels[index];
    Strip& strip = strips_[index];
    const int y = strip.row++, n = level.height;
    if (index + 1 == pyramid_.levels.size()) return;

    halve(row, level.width, pyramid_.channels, strip.narrowed);
    const auto add = [&](float share) {
        for (std::size_t i = 0; i < strip.sum.size(); ++i)
            strip.sum[i] += share * strip.narrowed[i];
    };
    const auto finish = [&] {
        addRow(index + 1, strip.sum.data());
        std::fill(strip.sum.begin(), strip.sum.end(), 0.f);
    };
    // Of an odd number of rows every even one but the first is also the last that the row above it needs.
    if (n % 2 == 1 && y % 2 == 0 && y > 0) {
        add(shares(n, y / 2 - 1)[2]);
        finish();
    }
    if (y / 2 >= std::max(1, n / 2)) return;
    add(shares(n, y / 2)[std::size_t(y % 2)]);
    if (n == 1 || (n % 2 == 0 && y % 2 == 1)) finish();
}

} // namespace vitrine
