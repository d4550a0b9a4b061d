// Rays. Origins and directions are double: analytic shapes are solved in double, and scenes reach 1e5 from the origin.
#pragma once

#include "core/vec.h"

namespace vitrine {

/// The points o + s d for s in (0, tMax). d need not be of unit length; distances are in units of |d|.
struct Ray {
    V3d o{0, 0, 0};
    V3d d{0, 0, 1};
    double tMax = infinityD;
    double time = 0; ///< in the scene's seconds: where moving things are when the ray meets them

    V3d at(double s) const { return o + d * s; }
};

} // namespace vitrine
