// The vocabulary shared by all BSDFs.
#pragma once

#include "core/vec.h"
#include "spectrum/sampled.h"

#include <optional>

namespace vitrine {

/// What the path carries: radiance from lights to the eye, or importance (photons). At refraction radiance is scaled
/// by 1/eta^2, importance is not (Veach 1997, sec. 5.2).
enum class TransportMode { Radiance, Importance };

namespace lobe {
inline constexpr unsigned reflection = 1, transmission = 2, diffuse = 4, glossy = 8, specular = 16;
}

struct BsdfSample {
    V3f wi;
    SampledSpectrum f;
    float pdf = 0;
    unsigned lobes = 0;
    float eta = 1; ///< relative index crossed (transmitted side over incident side); 1 at reflection and thin sheets

    bool isReflection() const { return lobes & lobe::reflection; }
    bool isTransmission() const { return lobes & lobe::transmission; }
    bool isSpecular() const { return lobes & lobe::specular; }
};

/// Directions closer to the surface than this scatter nothing. It lies far below the rounding of a cosine, and keeps
/// 1/cos, and products of two of them with any density, finite.
inline constexpr float minCosine = 1e-18f;

/// Whether w lies in the surface (or is not a number).
inline bool inSurface(const V3f& w) {
    return !(std::abs(w.z) >= minCosine);
}

} // namespace vitrine
