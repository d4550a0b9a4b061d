// Orthonormal frames: local z is the normal.
#pragma once

#include "core/vec.h"

namespace vitrine {

/// Right-handed orthonormal frame; the local coordinates of v are (v.s, v.t, v.n).
struct Frame {
    V3f s{1, 0, 0}, t{0, 1, 0}, n{0, 0, 1};

    Frame() = default;

    /// Any frame about the unit vector `normal` (Duff et al. 2017, listing 3).
    explicit Frame(const V3f& normal) : n(normal) {
        const float sign = std::copysign(1.f, n.z);
        const float a = -1 / (sign + n.z);
        const float b = n.x * n.y * a;
        s = V3f(1 + sign * sqr(n.x) * a, sign * b, -sign * n.x);
        t = V3f(b, sign + sqr(n.y) * a, -n.y);
    }

    /// The frame about the unit vector `normal` whose s lies along `tangent` as far as it can;
    /// any frame if the two are parallel or the tangent is zero.
    Frame(const V3f& normal, const V3f& tangent) : n(normal) {
        const V3f projected = tangent - n * n.dot(tangent);
        const float length2 = projected.length2();
        if (!(length2 > 1e-12f * tangent.length2()) || !std::isfinite(length2)) {
            *this = Frame(normal);
            return;
        }
        s = projected * (1 / std::sqrt(length2));
        // The projection of a nearly parallel tangent is mostly rounding error: take out what is left along n.
        if (length2 < 1e-2f * tangent.length2()) s = (s - n * n.dot(s)).normalized();
        t = n.cross(s);
    }

    V3f toLocal(const V3f& v) const { return V3f(v.dot(s), v.dot(t), v.dot(n)); }
    V3f toWorld(const V3f& v) const { return s * v.x + t * v.y + n * v.z; }
};

} // namespace vitrine
