// Images for textures, made by a formula.
#pragma once

#include "textures/image_cache.h"

#include <functional>

namespace vitrine::test {

/// Of column, row and channel.
using Formula = std::function<float(int, int, int)>;

inline std::shared_ptr<const CachedImage> makeImage(ImageTextureCache& cache, const V2i& size, int channels,
                                                    const Formula& value, TexelFormat format = TexelFormat::Float) {
    PyramidWriter writer(cache.file(), size.x, size.y, channels, format);
    std::vector<float> row;
    for (int y = 0; y < size.y; ++y) {
        row.clear();
        for (int x = 0; x < size.x; ++x)
            for (int c = 0; c < channels; ++c)
                row.push_back(value(x, y, c));
        writer.addRow(row.data());
    }
    return cache.add(writer.pyramid(), "made");
}

inline std::shared_ptr<ImageTextureCache> makeCache(int megabytes = 64) {
    return std::make_shared<ImageTextureCache>(megabytes);
}

/// Any numbers in [0, 1), without a pattern.
inline float scattered(int x, int y, int c) {
    const std::uint32_t bits =
        std::uint32_t(x) * 73856093u ^ std::uint32_t(y) * 19349663u ^ std::uint32_t(c) * 83492791u;
    return float((bits * 2654435761u) >> 8) * 0x1p-24f;
}

/// The centre of a texel of the finest level.
inline V2d centre(const CachedImage& image, int x, int y) {
    return {(x + 0.5) / image.size(0).x, (y + 0.5) / image.size(0).y};
}

} // namespace vitrine::test
