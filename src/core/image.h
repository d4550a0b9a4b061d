// A decoded image in memory.
#pragma once

#include "core/vec.h"

#include <vector>

namespace vitrine {

/// Row-major float pixels, row 0 on top, channels interleaved.
struct Image {
    int width = 0, height = 0, channels = 0;
    std::vector<float> pixels;

    float at(int x, int y, int c) const {
        return pixels[(std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels) + std::size_t(c)];
    }
};

} // namespace vitrine
