// Fresnel reflectance of unpolarised light at dielectrics and metals.
#pragma once

#include "spectrum/sampled.h"

namespace vitrine {

/// What a smooth dielectric boundary does with a ray.
struct DielectricFresnel {
    float reflectance; ///< 1 at total internal reflection
    float cosT;        ///< cosine of the refracted ray with the normal, >= 0; 0 at total internal reflection
};

/// Reflectance where both cosines are known. \param eta index of the transmitted over the incident side
inline float fresnelDielectric(float cosI, float cosT, float eta) {
    const float parallel = (eta * cosI - cosT) / (eta * cosI + cosT);
    const float perpendicular = (cosI - eta * cosT) / (cosI + eta * cosT);
    return (sqr(parallel) + sqr(perpendicular)) / 2;
}

/// \param cosI cosine on the incident side, in [0, 1] \param eta index of the transmitted over the incident side, > 0
inline DielectricFresnel fresnelDielectric(float cosI, float eta) {
    // Snell's law as (eta cosT)^2 = cosI^2 + eta^2 - 1: exact for matching indices at any angle.
    const float square = sqr(cosI) + (eta - 1) * (eta + 1);
    if (square <= 0) return {1, 0};
    const float cosT = std::sqrt(square) / eta;
    return {fresnelDielectric(cosI, cosT, eta), cosT};
}

/// The refraction of w, which points away from a boundary of normal n on its own side.
/// \param cosI n.w \param cosT as fresnelDielectric returned it for the same eta
inline V3f refract(const V3f& w, const V3f& n, float eta, float cosI, float cosT) {
    const float inverse = 1 / eta;
    return n * (cosI * inverse - cosT) - w * inverse;
}

/// The mirror image of w about n.
inline V3f reflect(const V3f& w, const V3f& n) {
    return n * (2 * w.dot(n)) - w;
}

/// Reflectance of a boundary to an absorbing medium of complex index eta + i k, relative to the incident side,
/// at the four wavelengths. \param cosI in [0, 1]
SampledSpectrum fresnelConductor(float cosI, const SampledSpectrum& eta, const SampledSpectrum& k);

} // namespace vitrine
