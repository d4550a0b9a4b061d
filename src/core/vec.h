// Imath's vectors under short names, and the few scalar helpers everything uses.
#pragma once

#include <ImathBox.h>
#include <ImathMatrix.h>
#include <ImathVec.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vitrine {

using Imath::Box3d;
using Imath::M44d;
using Imath::V2d;
using Imath::V2f;
using Imath::V2i;
using Imath::V3d;
using Imath::V3f;

inline constexpr float pi = 3.14159265358979323846f;
inline constexpr float invPi = 0.31830988618379067154f;
inline constexpr double piD = 3.14159265358979323846;
inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr double infinityD = std::numeric_limits<double>::infinity();

template <class T>
constexpr T sqr(T x) {
    return x * x;
}

template <class T>
constexpr T lerp(T t, T a, T b) {
    return (1 - t) * a + t * b;
}

constexpr double radians(double degrees) {
    return degrees * (piD / 180);
}

constexpr double degrees(double radians) {
    return radians * (180 / piD);
}

/// Square root that takes the rounding-negative zeros of geometry for zero.
inline float safeSqrt(float x) {
    return std::sqrt(std::max(0.f, x));
}

inline double safeSqrt(double x) {
    return std::sqrt(std::max(0., x));
}

/// a b - c d with one rounding's error (Kahan; Jeannerod, Louvet & Muller 2013).
template <class T>
T differenceOfProducts(T a, T b, T c, T d) {
    const T cd = c * d;
    const T difference = std::fma(a, b, -cd);
    const T error = std::fma(-c, d, cd);
    return difference + error;
}

inline V3f toFloat(const V3d& v) {
    return V3f(float(v.x), float(v.y), float(v.z));
}

inline V3d toDouble(const V3f& v) {
    return V3d(v.x, v.y, v.z);
}

template <class V>
auto absDot(const V& a, const V& b) {
    return std::abs(a.dot(b));
}

inline double maxAbs(const V3d& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

inline bool isFinite(const V3d& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace vitrine
