// How the disks of photon mapping shrink: the one place where radii change.
#pragma once

#include "core/vec.h"

#include <cstdint>

namespace vitrine {

/// One radius for all: pass i (from 0) uses the base radius times this (Knaus & Zwicker 2011, eq. 15:
/// r_{i+1}^2 / r_i^2 = (i + alpha) / (i + 1), i from 1). Depends on nothing but the pass, so passes are independent.
/// \param alpha in (0, 1]; 1: the radius stays
float sharedRadiusFactor(std::uint64_t pass, double alpha);

/// One radius a point, by the photons that it found (Hachisuka, Ogaki & Jensen 2008, on radius reduction):
/// R'^2 = R^2 (N + alpha M) / (N + M), N' = N + alpha M. Held as a factor of the base radius.
struct PointRadius {
    float factor = 1;
    float photons = 0; ///< N

    void found(std::uint32_t m, double alpha) {
        if (m == 0) return;
        const double n = double(photons), kept = n + alpha * m;
        factor = float(double(factor) * std::sqrt(kept / (n + m)));
        photons = float(kept);
    }
};

} // namespace vitrine
