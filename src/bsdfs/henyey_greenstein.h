// How a medium scatters: the phase function of Henyey & Greenstein (1941).
#pragma once

#include "core/frame.h"

namespace vitrine {

/// Reciprocal, and the density with which it samples itself. Directions are those of propagation, before and after.
class HenyeyGreenstein {
  public:
    /// \param g mean cosine of the deflection: 1 forwards, -1 back. Beyond 0.99 it is a delta to float, and counts as 0.99.
    explicit HenyeyGreenstein(float g) : g_(std::clamp(g, -0.99f, 0.99f)) {}

    /// Per steradian; the integral over the sphere is 1.
    float operator()(const V3f& before, const V3f& after) const {
        const float q = 1 + sqr(g_) - 2 * g_ * before.dot(after);
        return (1 - sqr(g_)) / (4 * pi * q * std::sqrt(std::max(q, 1e-9f)));
    }
    V3f sample(const V3f& before, const V2f& u) const {
        // The distribution of the cosine, inverted; at g = 0 it is uniform.
        float cosine = 1 - 2 * u.x;
        if (std::abs(g_) > 1e-3f) cosine = -(sqr((1 - sqr(g_)) / (1 + g_ - 2 * g_ * u.x)) - 1 - sqr(g_)) / (2 * g_);
        const float sine = safeSqrt(1 - sqr(cosine)), phi = 2 * pi * u.y;
        return Frame(before).toWorld(V3f(sine * std::cos(phi), sine * std::sin(phi), cosine));
    }

  private:
    float g_;
};

} // namespace vitrine
