// Gradient noise (Perlin 2002, "Improving noise") and its sums over octaves, with pbrt-v4's choices: they decide what a
// scene's marble looks like.
#pragma once

#include "textures/mapping.h"

namespace vitrine {

/// About [-1, 1]; 0 at points of whole coordinates; the pattern repeats every 256 units.
float noise(const V3d& p);

/// What a sum over octaves of noise is made of. Each is 1.99 times as fine as the one before.
struct Octaves {
    int count = 8;
    float roughness = 0.5f; ///< amplitude of an octave, against the one before

    /// \throws std::invalid_argument for a negative count, or one so large that coordinates overflow
    Octaves(int count, float roughness);
};

/// "Fractional Brownian motion": the sum of octaves of noise. Octaves too fine for the footprint are left out, the last one
/// is faded.
float fbm(const SpacePoint& at, const Octaves& octaves);

/// The same with the absolute value of noise. Octaves too fine for the footprint count with 0.2, about the mean of it.
float turbulence(const SpacePoint& at, const Octaves& octaves);

/// The point and its footprint, scaled about the origin.
SpacePoint scaled(const SpacePoint& at, double scale);

} // namespace vitrine
