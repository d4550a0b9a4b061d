#include "lights/eight_lights.h"

#include <cstring>
#ifdef __AVX__
#include <immintrin.h>
#endif

namespace vitrine {

namespace {

/// Cosines are taken for so much more than they are, so that no rounding hides a light that shines: a cosine near 1 tells
/// the angle, and with it the sine, no better than to some 4e-4.
constexpr float slack = 1e-3f;
/// What is dimmer than this part of all, or nearer than the root of this part of its size, counts for no less: a float
/// holds the quotient.
constexpr float leastIntensity = 1e-12f, leastDistance2 = 1e-20f;
constexpr double leastSize = 1e-280;
/// Places are rounded to floats twice, here and when a receiver asks, by no more than this part of the size.
constexpr double placeError = 5e-7;

using Floats [[gnu::vector_size(32)]] = float;

inline Floats squareRoot(const Floats& x) {
#ifdef __AVX__
    return Floats(_mm256_sqrt_ps(__m256(x)));
#else
    Floats root{};
    for (unsigned i = 0; i < EightLights::lanes; ++i)
        root[i] = std::sqrt(x[i]);
    return root;
#endif
}

inline Floats atLeast(const Floats& x, float least) {
    return x > least ? x : Floats{} + least;
}

struct Angles {
    Floats cos, sin;
};

inline Angles anglesOf(Floats c) {
    c = c > 1 ? Floats{} + 1 : c < -1 ? Floats{} - 1 : c;
    return {c, squareRoot(1 - c * c)};
}

/// The difference, but not less than none.
inline Angles less(const Angles& a, const Angles& b) {
    const Floats c = a.cos * b.cos + a.sin * b.sin, s = a.sin * b.cos - a.cos * b.sin;
    return {a.cos >= b.cos ? Floats{} + 1 : c, a.cos >= b.cos ? Floats{} : s};
}

} // namespace

EightLights::EightLights(std::span<const LightBounds> bounds) {
    Box3d all;
    double intensity = 0;
    for (const LightBounds& one : bounds) {
        all.extendBy(one.box);
        intensity += one.intensity;
    }
    center_ = all.center();
    size_ = std::max({all.size().x, all.size().y, all.size().z, leastSize});
    for (unsigned i = 0; i < bounds.size(); ++i) {
        const LightBounds& one = bounds[i];
        const V3f c = toFloat((one.box.center() - center_) * (1 / size_));
        x_[i] = c.x;
        y_[i] = c.y;
        z_[i] = c.z;
        radius_[i] = float(one.box.size().length() / 2 / size_ + placeError);
        intensity_[i] = std::max(float(one.intensity / intensity), leastIntensity);
        axisX_[i] = float(one.normals.axis.x);
        axisY_[i] = float(one.normals.axis.y);
        axisZ_[i] = float(one.normals.axis.z);
        cosNormals_[i] = float(one.normals.cosAngle);
        sinNormals_[i] = float(safeSqrt(1 - sqr(one.normals.cosAngle)));
        cosReach_[i] = float(one.cosReach);
        twoSided_[i] = one.twoSided ? 1.f : 0.f;
    }
}

void EightLights::importances(const LightReceiver& receiver, float importance[lanes]) const {
    // Lengths in a unit that keeps their squares within float.
    const V3d offset = receiver.p - center_;
    const double perUnit = 1 / (maxAbs(offset) + size_);
    const V3f p = toFloat(offset * perUnit);
    const auto size = float(size_ * perUnit);
    const Floats x = x_ * size - p.x, y = y_ * size - p.y, z = z_ * size - p.z, r = radius_ * size;
    const Floats r2 = r * r, d2 = atLeast(x * x + y * y + z * z, leastDistance2);
    const Floats perDistance = 1 / squareRoot(d2);
    const Floats wx = x * perDistance, wy = y * perDistance, wz = z * perDistance;
    // Within the sphere light may come from anywhere, and it is as near as the lights lie apart.
    const auto isInside = r2 >= d2;
    const Floats sinSeen = r * perDistance;
    const Angles seen{isInside ? Floats{} - 1 : squareRoot(1 - sinSeen * sinSeen), isInside ? Floats{} : sinSeen};

    const Floats cosAxis = -(axisX_ * wx + axisY_ * wy + axisZ_ * wz);
    const Angles off = anglesOf((twoSided_ > 0) & (cosAxis < 0) ? -cosAxis : cosAxis);
    const Floats cosOut = less(less(off, {cosNormals_, sinNormals_}), seen).cos + slack;
    Floats light = intensity_ / (isInside ? r2 : d2) * (cosOut > cosReach_ ? atLeast(cosOut, slack) : Floats{});
    if (const V3f& n = receiver.n; n.x != 0 || n.y != 0 || n.z != 0) {
        const Floats cosIn = less(anglesOf(wx * n.x + wy * n.y + wz * n.z), seen).cos + slack;
        light *= atLeast(cosIn, 0);
    }
    std::memcpy(importance, &light, sizeof(light));
}

} // namespace vitrine
