// Scattering at a point of a surface, in the local shading frame (z along the shading normal, towards the outside).
#pragma once

#include "bsdfs/conductor_bsdf.h"
#include "bsdfs/dielectric_bsdf.h"
#include "bsdfs/diffuse_bsdf.h"
#include "bsdfs/diffusetransmission_bsdf.h"
#include "bsdfs/layered_bsdf.h"
#include "bsdfs/lobes.h"
#include "bsdfs/thindielectric_bsdf.h"

#include <variant>

namespace vitrine {

/// One of the BSDFs, held by value. wo points to where the path comes from, wi to where it goes; both unit, local,
/// away from the surface. Values are per steradian without the cosine. Delta lobes: f and pdf are 0, sample gives
/// f = (Fresnel) / |cos wi| and pdf = the lobe's probability, as in pbrt-v4. Layered ones answer f and pdf by estimates,
/// always the same one for the same question.
class Bsdf {
    template <class F>
    decltype(auto) visit(F&& f) const {
        // A switch: std::visit's table of functions keeps the compiler from inlining the hot cases.
        switch (bsdf_.index()) {
        case 0:
            return f(*std::get_if<0>(&bsdf_));
        case 1:
            return f(*std::get_if<1>(&bsdf_));
        case 2:
            return f(*std::get_if<2>(&bsdf_));
        case 3:
            return f(*std::get_if<3>(&bsdf_));
        case 4:
            return f(*std::get_if<4>(&bsdf_));
        case 5:
            return f(*std::get_if<5>(&bsdf_));
        default:
            return f(*std::get_if<6>(&bsdf_));
        }
    }

  public:
    using Variant = std::variant<DiffuseBsdf, ConductorBsdf, DielectricBsdf, ThinDielectricBsdf,
                                 DiffuseTransmissionBsdf, CoatedDiffuseBsdf, CoatedConductorBsdf>;

    template <class B>
    requires std::is_constructible_v<Variant, const B&> Bsdf(const B& bsdf) : bsdf_(bsdf) {}

    /// Which kinds of lobe there are.
    unsigned lobes() const {
        return visit([](const auto& b) { return b.lobes(); });
    }
    /// Something besides delta lobes: worth a shadow ray.
    bool isNonSpecular() const { return lobes() & (lobe::diffuse | lobe::glossy); }
    /// How wide the narrowest lobe is, delta lobes aside, as the alpha of its microfacets: 1 for diffuse ones; 0 if there
    /// are delta lobes alone.
    float roughness() const {
        return visit([](const auto& b) { return b.roughness(); });
    }
    SampledSpectrum f(const V3f& wo, const V3f& wi, TransportMode mode) const {
        return visit([&](const auto& b) { return b.f(wo, wi, mode); });
    }
    /// Density of wi per solid angle when drawn by sample(wo, ...).
    float pdf(const V3f& wo, const V3f& wi, TransportMode mode) const {
        return visit([&](const auto& b) { return b.pdf(wo, wi, mode); });
    }
    /// \param uc picks the lobe, \param u the direction in it. Empty when nothing is scattered.
    std::optional<BsdfSample> sample(const V3f& wo, float uc, const V2f& u, TransportMode mode) const {
        return visit([&](const auto& b) { return b.sample(wo, uc, u, mode); });
    }
    /// Roughens near-delta lobes, for `"bool regularize"` (pbrt-v4: alpha < 0.3 becomes clamp(2 alpha, 0.1, 0.3)).
    void regularize() {
        std::visit([](auto& b) { b.regularize(); }, bsdf_);
    }

  private:
    Variant bsdf_;
};

} // namespace vitrine
