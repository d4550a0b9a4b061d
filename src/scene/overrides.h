// What the command line says over the scene file.
#pragma once

#include "core/vec.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

struct Overrides {
    std::string integrator; ///< replaces the type; parameters that the new type does not know are dropped and named
    std::optional<std::uint64_t> samplesPerPixel;
    std::optional<std::uint64_t> seed;
    std::optional<V2i> resolution;
    std::optional<std::array<double, 4>> cropWindow; ///< x0 x1 y0 y1 in [0, 1]
    std::optional<std::array<int, 4>> pixelBounds;   ///< x0 x1 y0 y1
    std::optional<int> textureCacheMegabytes;        ///< in place of Option "texturecachemb"
    bool quick = false;                              ///< a quarter of the resolution, one sample
    std::vector<std::string> settings;               ///< key=value of --set
};

} // namespace vitrine
