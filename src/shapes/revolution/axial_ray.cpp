#include "shapes/revolution/axial_ray.h"

namespace vitrine {

AxialRay::AxialRay(const Ray& ray) {
    constexpr double limit = 1e150; // squares must not overflow
    const double largest = maxAbs(ray.d);
    reach = maxAbs(ray.o);
    if (!(largest > 1 / limit) || !(largest < limit) || !(reach < limit) || !isFinite(ray.d) || !isFinite(ray.o))
        return;
    const V3d scaled = ray.d / largest;
    const double horizontal = std::sqrt(scaled.x * scaled.x + scaled.z * scaled.z);
    const double scaledLength = std::sqrt(horizontal * horizontal + scaled.y * scaled.y);
    length = largest * scaledLength;
    h = horizontal / scaledLength;
    v = scaled.y / scaledLength;
    ox = ray.o.x;
    oy = ray.o.y;
    oz = ray.o.z;
    dx = scaled.x / scaledLength;
    dz = scaled.z / scaledLength;
    // For a vertical ray every horizontal direction will do.
    const double ux = horizontal > 0 ? scaled.x / horizontal : 1, uz = horizontal > 0 ? scaled.z / horizontal : 0;
    e = std::abs(differenceOfProducts(ox, uz, oz, ux));
    q = ox * ux + oz * uz;
    vq = v * q;
}

} // namespace vitrine
