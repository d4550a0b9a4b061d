// What tests of rays against boxes share.
#pragma once

#include "core/vec.h"

namespace vitrine {

/// 1 / d for the slabs of Kay & Kajiya 1986 ("Ray Tracing Complex Scenes"). Finite, as 0 times infinity is nothing: boxes
/// are to be padded, so that what is in one is off its bounds.
inline V3d slabInverse(const V3d& d) {
    const auto inverse = [](double x) { return std::max(std::min(1 / x, 0x1p1000), -0x1p1000); };
    return V3d(inverse(d.x), inverse(d.y), inverse(d.z));
}

} // namespace vitrine
