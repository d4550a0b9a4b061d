// What lies between two radii and two heights. Unlike a box, a ring has a hole.
#pragma once

#include "core/vec.h"

namespace vitrine {

struct Ring {
    double rMin = infinityD, rMax = 0, yMin = infinityD, yMax = -infinityD;

    void extendBy(const Ring& other) {
        rMin = std::min(rMin, other.rMin);
        rMax = std::max(rMax, other.rMax);
        yMin = std::min(yMin, other.yMin);
        yMax = std::max(yMax, other.yMax);
    }
    /// Of the box about it.
    double surface() const { return 8 * rMax * (rMax + yMax - yMin); }
};

} // namespace vitrine
