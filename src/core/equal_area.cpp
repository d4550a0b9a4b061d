#include "core/equal_area.h"

#include <utility>

namespace vitrine {

namespace {

template <class T>
constexpr T quarterPi = T(piD / 4);

} // namespace

template <class T>
Imath::Vec3<T> equalAreaSquareToSphere(const Imath::Vec2<T>& p) {
    const T u = 2 * p.x - 1, v = 2 * p.y - 1;
    const T absU = std::abs(u), absV = std::abs(v);
    // Positive within the diamond |u| + |v| < 1, the upper half of the sphere.
    const T inside = 1 - (absU + absV);
    const T r = 1 - std::abs(inside);
    const T phi = r > 0 ? ((absV - absU) / r + 1) * quarterPi<T> : quarterPi<T>;
    const T sinTheta = r * safeSqrt(2 - r * r);
    return Imath::Vec3<T>(std::copysign(std::cos(phi), u) * sinTheta, std::copysign(std::sin(phi), v) * sinTheta,
                          std::copysign(1 - r * r, inside));
}

template <class T>
Imath::Vec2<T> equalAreaSphereToSquare(const Imath::Vec3<T>& d) {
    const T x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    // r^2 = 1 - z, without the cancellation near the poles.
    const T r = safeSqrt((x * x + y * y) / (1 + z));
    const T phi = x > 0 || y > 0 ? std::atan2(y, x) / (2 * quarterPi<T>) : T(0);
    T v = phi * r, u = r - v;
    if (d.z < 0) {
        std::swap(u, v);
        u = 1 - u;
        v = 1 - v;
    }
    u = std::clamp(std::copysign(u, d.x), T(-1), T(1));
    v = std::clamp(std::copysign(v, d.y), T(-1), T(1));
    return Imath::Vec2<T>((u + 1) / 2, (v + 1) / 2);
}

template <class T>
Imath::Vec2<T> wrapEqualAreaSquare(const Imath::Vec2<T>& p) {
    Imath::Vec2<T> q = p;
    if (q.x < 0 || q.x > 1) {
        q.x = (q.x < 0 ? 0 : 2) - q.x;
        q.y = 1 - q.y;
    }
    if (q.y < 0 || q.y > 1) {
        q.x = 1 - q.x;
        q.y = (q.y < 0 ? 0 : 2) - q.y;
    }
    return q;
}

template V3f equalAreaSquareToSphere(const V2f&);
template V3d equalAreaSquareToSphere(const V2d&);
template V2f equalAreaSphereToSquare(const V3f&);
template V2d equalAreaSphereToSquare(const V3d&);
template V2f wrapEqualAreaSquare(const V2f&);
template V2d wrapEqualAreaSquare(const V2d&);

} // namespace vitrine
