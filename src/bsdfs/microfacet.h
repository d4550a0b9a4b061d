// The Trowbridge-Reitz (GGX) distribution of microfacet normals, anisotropic, with Smith's height-correlated masking.
#pragma once

#include "core/vec.h"

namespace vitrine {

/// Rough surfaces as a statistical crowd of mirrors. Directions are local, z along the normal; those below the surface
/// count as their opposites: the surface looks the same from both sides. Roughness alpha is the slope of the facets.
///
/// Everything is written with stretch(w) = sqrt(alphaX^2 x^2 + alphaY^2 y^2 + z^2), which turns Smith's
/// Lambda(w) = (sqrt(1 + alpha^2 tan^2) - 1) / 2 (Heitz 2014, eq. 72) into (stretch(w) / |z| - 1) / 2: products with
/// the foreshortening factors then have no pole at the horizon, and no tangent has to be formed.
class TrowbridgeReitz {
  public:
    /// A mirror.
    TrowbridgeReitz() = default;
    /// A roughness below 1e-4 in one direction only becomes 1e-4 (as pbrt-v4).
    TrowbridgeReitz(float alphaX, float alphaY) : alphaX_(alphaX), alphaY_(alphaY) {
        if (effectivelySmooth()) return;
        alphaX_ = std::max(alphaX_, 1e-4f);
        alphaY_ = std::max(alphaY_, 1e-4f);
    }

    /// pbrt-v4's map from "roughness" in [0, 1] to alpha.
    static float alphaFromRoughness(float roughness) { return std::sqrt(roughness); }

    float alphaX() const { return alphaX_; }
    float alphaY() const { return alphaY_; }
    /// The smaller alpha; 0 for what is treated as a mirror.
    float roughness() const { return effectivelySmooth() ? 0 : std::min(alphaX_, alphaY_); }
    /// To be treated as a mirror: float has not the digits for so narrow a lobe.
    bool effectivelySmooth() const { return std::max(alphaX_, alphaY_) < 1e-3f; }
    /// Doubles roughness below 0.3 and bounds it to [0.1, 0.3], for paths that are to end in fewer fireflies.
    void regularize() {
        if (alphaX_ < 0.3f) alphaX_ = std::clamp(2 * alphaX_, 0.1f, 0.3f);
        if (alphaY_ < 0.3f) alphaY_ = std::clamp(2 * alphaY_, 0.1f, 0.3f);
    }

    /// Area of the facets of normal m, per steradian and per area of the surface; m.z >= 0 (Heitz 2014, eq. 85).
    float d(const V3f& m) const {
        const float area = alphaX_ * alphaY_;
        const float q = sqr(m.x * alphaY_) + sqr(m.y * alphaX_) + sqr(m.z * area);
        return area * area * area / (pi * q * q);
    }
    float stretch(const V3f& w) const { return std::sqrt(sqr(alphaX_ * w.x) + sqr(alphaY_ * w.y) + sqr(w.z)); }
    /// Share of the facets facing w that w sees.
    float g1(const V3f& w) const { return std::abs(w.z) * visibleOverD(w); }
    /// Share of the facets that both see, heights correlated (Heitz 2014, eq. 99).
    float g(const V3f& wo, const V3f& wi) const { return std::abs(wo.z) * std::abs(wi.z) * gOverCosines(wo, wi); }
    /// g / (|cos wo| |cos wi|).
    float gOverCosines(const V3f& wo, const V3f& wi) const {
        return 2 / (stretch(wo) * std::abs(wi.z) + stretch(wi) * std::abs(wo.z));
    }
    /// g1 / |cos w|: the density of visible normals is this times |w.m| d(m) (Heitz 2014, eq. 16).
    float visibleOverD(const V3f& w) const { return 2 / (std::abs(w.z) + stretch(w)); }
    /// Density, per steradian, of the normals m that sampleVisible draws.
    float visiblePdf(const V3f& w, const V3f& m) const { return visibleOverD(w) * absDot(w, m) * d(m); }
    /// A normal, in the upper hemisphere, as often as w (or its opposite, from below) sees it.
    V3f sampleVisible(const V3f& w, const V2f& u) const;

  private:
    float alphaX_ = 0, alphaY_ = 0;
};

} // namespace vitrine
