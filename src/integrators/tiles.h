// A film cut into square tiles, handed to all threads of the current task arena.
#pragma once

#include "core/vec.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <xmmintrin.h>

namespace vitrine {

/// Rounding and denormal numbers as IEEE 754 has them, for as long as this lives. TBB runs tasks with the settings of
/// whoever used its scheduler first, and Embree does so with denormals flushed: no picture shall depend on that.
class PlainArithmetic {
  public:
    PlainArithmetic() : before_(_mm_getcsr()) { _mm_setcsr(0x1f80); }
    ~PlainArithmetic() { _mm_setcsr(before_); }
    PlainArithmetic(const PlainArithmetic&) = delete;
    PlainArithmetic& operator=(const PlainArithmetic&) = delete;

  private:
    unsigned before_;
};

/// Calls f(pixel) for every pixel of [min, max), tiles of 16 x 16 in parallel, the pixels of a tile in order on one
/// thread; afterTile(number of pixels) after each tile.
template <class PerPixel, class AfterTile>
void forEachPixel(const V2i& min, const V2i& max, PerPixel&& perPixel, AfterTile&& afterTile) {
    constexpr int side = 16;
    const V2i size = max - min;
    const std::int64_t across = (size.x + side - 1) / side, down = (size.y + side - 1) / side;
    tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, across * down, 1), [&](const auto& tiles) {
        const PlainArithmetic plain;
        for (std::int64_t tile = tiles.begin(); tile != tiles.end(); ++tile) {
            const V2i first(min.x + int(tile % across) * side, min.y + int(tile / across) * side);
            const V2i last(std::min(first.x + side, max.x), std::min(first.y + side, max.y));
            for (int y = first.y; y < last.y; ++y)
                for (int x = first.x; x < last.x; ++x)
                    perPixel(V2i(x, y));
            afterTile((last.x - first.x) * (last.y - first.y));
        }
    });
}

} // namespace vitrine
