// A film cut into square tiles, handed to all threads of the current task arena.
#pragma once

#include "core/plain_arithmetic.h"
#include "core/vec.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace vitrine {

/// Calls f(first, last) for the tiles of 16 x 16 that [min, max) is cut into, in parallel; last not included.
template <class F>
void forEachTile(const V2i& min, const V2i& max, F&& f) {
    constexpr int side = 16;
    const V2i size = max - min;
    const std::int64_t across = (size.x + side - 1) / side, down = (size.y + side - 1) / side;
    tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, across * down, 1), [&](const auto& tiles) {
        const PlainArithmetic plain;
        for (std::int64_t tile = tiles.begin(); tile != tiles.end(); ++tile) {
            const V2i first(min.x + int(tile % across) * side, min.y + int(tile / across) * side);
            f(first, V2i(std::min(first.x + side, max.x), std::min(first.y + side, max.y)));
        }
    });
}

/// Calls f(pixel) for every pixel of [min, max), the pixels of a tile in order on one thread; afterTile(number of pixels)
/// after each tile.
template <class PerPixel, class AfterTile>
void forEachPixel(const V2i& min, const V2i& max, PerPixel&& perPixel, AfterTile&& afterTile) {
    forEachTile(min, max, [&](const V2i& first, const V2i& last) {
        for (int y = first.y; y < last.y; ++y)
            for (int x = first.x; x < last.x; ++x)
                perPixel(V2i(x, y));
        afterTile((last.x - first.x) * (last.y - first.y));
    });
}

} // namespace vitrine
