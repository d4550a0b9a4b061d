// Coated surfaces to test, and a walk between two infinite planes without any of the model's tricks.
#pragma once

#include "bsdf_cases.h"

#include <functional>

namespace vitrine::test {

/// A layered BSDF by its parts, so that the oracle can be built from the same.
struct LayeredCase {
    std::string name;
    float eta = 1.5f; ///< of the coat
    V2f coatAlpha{0, 0};
    bool isMetal = false;
    V2f metalAlpha{0.3f, 0.3f};
    CoatMedium medium;

    DielectricBsdf coat() const { return DielectricBsdf(eta, TrowbridgeReitz(coatAlpha.x, coatAlpha.y)); }
    DiffuseBsdf matt() const { return DiffuseBsdf(SampledSpectrum(0.3f, 0.8f, 0.5f, 1)); }
    ConductorBsdf metal() const {
        return ConductorBsdf(TrowbridgeReitz(metalAlpha.x, metalAlpha.y), SampledSpectrum(0.2f, 0.5f, 1, 1.5f),
                             SampledSpectrum(2.4f, 3, 2, 1));
    }
    LayeredCase withWalks(int number) const {
        LayeredCase c = *this;
        c.medium.samples = std::uint16_t(number);
        return c;
    }
    Bsdf bsdf(std::uint32_t seed) const {
        return isMetal ? Bsdf(CoatedConductorBsdf(coat(), metal(), medium, seed))
                       : Bsdf(CoatedDiffuseBsdf(coat(), matt(), medium, seed));
    }
};

inline CoatMedium coatMedium(float thickness, float albedo = 0, float g = 0, int depth = 400, int samples = 1) {
    return {thickness, SampledSpectrum(albedo), g, std::uint16_t(depth), std::uint16_t(samples)};
}

inline std::vector<LayeredCase> layeredCases() {
    return {
        {"matt, polished coat", 1.5f, {0, 0}, false, {}, coatMedium(0.01f)},
        {"matt, rough coat", 1.5f, {0.4f, 0.2f}, false, {}, coatMedium(0)},
        {"matt, rough coat, forward medium", 1.4f, {0.3f, 0.3f}, false, {}, coatMedium(0.5f, 0.8f, 0.6f)},
        {"matt, polished coat, backward medium", 1.5f, {0, 0}, false, {}, coatMedium(2, 0.9f, -0.4f, 400, 2)},
        {"metal, polished coat", 1.5f, {0, 0}, true, {0.3f, 0.3f}, coatMedium(0.1f)},
        {"metal, rough coat", 1.5f, {0.3f, 0.3f}, true, {0.4f, 0.25f}, coatMedium(0.2f)},
        {"mirror, rough coat", 1.3f, {0.35f, 0.35f}, true, {0, 0}, coatMedium(0.01f)},
        {"mirror, polished coat, medium", 1.5f, {0, 0}, true, {0, 0}, coatMedium(1, 0.7f, 0.3f)},
        {"metal, rough coat, medium", 1.6f, {0.5f, 0.5f}, true, {0.3f, 0.3f}, coatMedium(0.7f, 0.6f, 0)},
    };
}

/// What leaves the layers.
struct Outcome {
    V3f wi;
    SampledSpectrum weight; ///< share of the flux that came in
    bool specular;
};

/// A particle comes from wo through the plane z = 0 (the coat) and moves in space above the plane z = -thickness (the base)
/// until it leaves. No step is favoured, none is bounded in number, and nothing is looked for.
template <class Base>
std::optional<Outcome> wander(const LayeredCase& c, const Base& base, const V3f& wo, RandomStream& random) {
    const DielectricBsdf coat = c.coat();
    const double floor = -double(c.medium.thickness);
    Outcome out{wo, SampledSpectrum(1), true};
    const auto meet = [&](const auto& plane, const V3f& from) -> std::optional<BsdfSample> {
        const float uc = random.uniform(), u = random.uniform();
        const auto s = plane.sample(from, uc, V2f(u, random.uniform()), TransportMode::Importance);
        if (!s) return {};
        out.weight *= s->f * (std::abs(s->wi.z) / s->pdf);
        out.specular &= s->isSpecular();
        out.wi = s->wi;
        return s;
    };
    const auto first = meet(coat, wo);
    if (!first) return {};
    if (first->isReflection()) return out;
    double z = 0;
    while (!out.weight.isBlack()) {
        const double length = -std::log(1 - random.uniformDouble()), to = z + length * double(out.wi.z);
        if (to > floor && to < 0) {
            z = to;
            out.weight *= c.medium.albedo;
            out.specular = false;
            // The mean cosine is g: Henyey & Greenstein's cumulative distribution, inverted by bisection.
            const double g = double(c.medium.g), u = random.uniformDouble();
            double low = -1, high = 1;
            for (int i = 0; i < 40; ++i) {
                const double x = (low + high) / 2;
                const double below =
                    g == 0 ? (1 + x) / 2 : (1 - g * g) / (2 * g) * (1 / std::sqrt(1 + g * g - 2 * g * x) - 1 / (1 + g));
                (below < u ? low : high) = x;
            }
            const double sine = std::sqrt(1 - low * low), phi = 2 * piD * random.uniformDouble();
            out.wi = Frame(out.wi).toWorld(V3f(float(sine * std::cos(phi)), float(sine * std::sin(phi)), float(low)));
            continue;
        }
        const bool up = out.wi.z > 0;
        z = up ? 0 : floor;
        const auto s = up ? meet(coat, -out.wi) : meet(base, -out.wi);
        if (!s) return {};
        if (up && s->isTransmission()) return out;
    }
    return {};
}

} // namespace vitrine::test
