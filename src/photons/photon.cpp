#include "photons/photon.h"

namespace vitrine {

namespace {

constexpr float steps = 2046; // even: the axes are represented exactly

std::uint32_t quantize(float x) {
    return std::uint32_t((std::clamp(x, -1.f, 1.f) * 0.5f + 0.5f) * steps + 0.5f);
}

float restore(std::uint32_t bits) {
    return float(bits) * (2 / steps) - 1;
}

float foldedBack(float x, float other) {
    return std::copysign(1 - std::abs(other), x);
}

} // namespace

std::uint32_t Photon::packDirection(const V3f& w) {
    const float sum = std::abs(w.x) + std::abs(w.y) + std::abs(w.z);
    float x = w.x / sum, y = w.y / sum;
    if (w.z < 0) {
        const float folded = foldedBack(x, y);
        y = foldedBack(y, x);
        x = folded;
    }
    return quantize(x) << 11 | quantize(y);
}

V3f Photon::unpackDirection(std::uint32_t bits) {
    float x = restore(bits >> 11 & 2047), y = restore(bits & 2047);
    const float z = 1 - std::abs(x) - std::abs(y);
    if (z < 0) {
        const float folded = foldedBack(x, y);
        y = foldedBack(y, x);
        x = folded;
    }
    return V3f(x, y, z).normalized();
}

} // namespace vitrine
