// Fresnel reflectance of unpolarised light at dielectrics and metals.
#pragma once

#include "spectrum/sampled.h"

namespace vitrine {

/// What a smooth dielectric boundary does with a ray.
struct DielectricFresnel {
    float reflectance; ///< 1 at total internal reflection
    float cosT;        ///< cosine of the refracted ray with the normal, >= 0; 0 at total internal reflection
};

/// \param cosI cosine on the incident side, in [0, 1] \param eta index of the transmitted over the incident side, > 0
inline DielectricFresnel fresnelDielectric(float cosI, float eta) {
    const float sin2T = std::max(0.f, 1 - sqr(cosI)) / sqr(eta);
    if (sin2T >= 1) return {1, 0};
    const float cosT = std::sqrt(1 - sin2T);
    const float parallel = (eta * cosI - cosT) / (eta * cosI + cosT);
    const float perpendicular = (cosI - eta * cosT) / (cosI + eta * cosT);
    return {(sqr(parallel) + sqr(perpendicular)) / 2, cosT};
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
