// The BSDFs and directions that the statistical tests go through.
#pragma once

#include "bsdfs/bsdf.h"
#include "core/frame.h"
#include "core/random.h"

#include <string>
#include <vector>

namespace vitrine::test {

struct NamedBsdf {
    std::string name;
    Bsdf bsdf;
};

/// Facets from nearly smooth to as rough as can be, equal and not.
inline const std::vector<V2f>& roughnesses() {
    static const std::vector<V2f> alphas = {{1, 1}, {0.3f, 0.3f}, {0.08f, 0.08f}, {0.08f, 0.4f}, {0.9f, 0.15f}};
    return alphas;
}

inline std::string nameOf(const V2f& alpha) {
    return std::to_string(alpha.x).substr(0, 4) + "/" + std::to_string(alpha.y).substr(0, 4);
}

inline NamedBsdf diffuseCase() {
    return {"diffuse", DiffuseBsdf(SampledSpectrum(0.1f, 0.9f, 0.5f, 0.7f))};
}

inline NamedBsdf sheetCase() {
    return {"diffuse transmission",
            DiffuseTransmissionBsdf(SampledSpectrum(0.1f, 0.6f, 0.5f, 0.7f), SampledSpectrum(0.3f, 0.2f, 0.5f, 0.1f))};
}

/// Copper, silver and glass-like lanes at once.
inline NamedBsdf conductorCase(const V2f& alpha) {
    const SampledSpectrum eta(0.24f, 0.05f, 1.1f, 1.5f), k(3.4f, 4.2f, 2.3f, 0.f);
    return {"conductor " + nameOf(alpha), ConductorBsdf(TrowbridgeReitz(alpha.x, alpha.y), eta, k)};
}

/// A metal that reflects everything.
inline NamedBsdf losslessCase(const V2f& alpha) {
    return {"lossless " + nameOf(alpha),
            ConductorBsdf(TrowbridgeReitz(alpha.x, alpha.y), SampledSpectrum(0), SampledSpectrum(1))};
}

inline NamedBsdf dielectricCase(float eta, const V2f& alpha) {
    return {"dielectric " + std::to_string(eta).substr(0, 5) + " " + nameOf(alpha),
            DielectricBsdf(eta, TrowbridgeReitz(alpha.x, alpha.y))};
}

inline std::vector<NamedBsdf> roughCases() {
    std::vector<NamedBsdf> cases = {diffuseCase(), sheetCase()};
    for (const V2f& alpha : roughnesses()) {
        cases.push_back(conductorCase(alpha));
        for (float eta : {1.5f, 1 / 1.5f, 2.4f})
            cases.push_back(dielectricCase(eta, alpha));
    }
    return cases;
}

inline V3f directionAt(double theta, double phi) {
    return V3f(float(std::sin(radians(theta)) * std::cos(radians(phi))),
               float(std::sin(radians(theta)) * std::sin(radians(phi))), float(std::cos(radians(theta))));
}

/// From both sides, straight and grazing, off the axes of the roughness.
inline std::vector<V3f> outgoingDirections() {
    return {directionAt(0, 0),   directionAt(35, 20),   directionAt(70, 110), directionAt(87, -50),
            directionAt(180, 0), directionAt(140, -80), directionAt(115, 15), directionAt(94, 160)};
}

inline std::optional<BsdfSample> draw(const Bsdf& bsdf, const V3f& wo, TransportMode mode, RandomStream& random) {
    const float uc = random.uniform(), u = random.uniform();
    return bsdf.sample(wo, uc, V2f(u, random.uniform()), mode);
}

} // namespace vitrine::test
