#include "bsdfs/microfacet.h"

namespace vitrine {

// Stretched by alpha the facets are those of a hemisphere, and the visible ones reflect w into a spherical cap
// (Dupuy & Benyoub 2023, "Sampling visible GGX normals with spherical caps", listing 3).
V3f TrowbridgeReitz::sampleVisible(const V3f& w, const V2f& u) const {
    const float side = std::copysign(1.f, w.z);
    const float scale = side / stretch(w);
    const V3f stretched(alphaX_ * w.x * scale, alphaY_ * w.y * scale, w.z * scale);
    // The halfway vector's z, (z of the cap's point) + stretched.z, is formed first: it must not cancel to 0.
    const float halfZ = (1 - u.y) * (1 + stretched.z);
    const float z = halfZ - stretched.z;
    const float r = safeSqrt(1 - z * z), phi = 2 * pi * u.x;
    const V3f m(alphaX_ * (r * std::cos(phi) + stretched.x), alphaY_ * (r * std::sin(phi) + stretched.y), halfZ);
    return m / std::sqrt(m.length2());
}

} // namespace vitrine
