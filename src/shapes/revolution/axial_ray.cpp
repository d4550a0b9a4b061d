#include "shapes/revolution/axial_ray.h"

namespace vitrine {

AxialRay::AxialRay(const Ray& ray) {
    constexpr double limit = 1e150; // squares must not overflow
    const double largest = maxAbs(ray.d);
    reach = maxAbs(ray.o);
    if (!(largest > 1 / limit) || !(largest < limit) || !(reach < limit) || !isFinite(ray.d) || !isFinite(ray.o))
        return;
    // Squares of what is neither very long nor very short need no scaling.
    const bool isUsual = largest > 1e-100 && largest < 1e100;
    const double unit = isUsual ? 1 : largest;
    const V3d d = isUsual ? ray.d : ray.d / largest;
    const double horizontal2 = d.x * d.x + d.z * d.z;
    const double scaledLength = std::sqrt(horizontal2 + d.y * d.y), horizontal = std::sqrt(horizontal2);
    const double inverse = 1 / scaledLength;
    length = unit * scaledLength;
    h = horizontal * inverse;
    v = d.y * inverse;
    // For a horizontal ray any height outside the slab is infinitely far; yet a height times this is a number.
    inverseV = std::abs(v) > 1 / limit ? scaledLength / d.y : std::copysign(limit, v);
    ox = ray.o.x;
    oy = ray.o.y;
    oz = ray.o.z;
    dx = d.x * inverse;
    dz = d.z * inverse;
    // For a vertical ray every horizontal direction will do.
    if (horizontal > 0) {
        e = std::abs(differenceOfProducts(ox, d.z, oz, d.x)) / horizontal;
        q = (ox * d.x + oz * d.z) / horizontal;
    } else {
        e = std::abs(oz);
        q = ox;
    }
    vq = v * q;
}

} // namespace vitrine
