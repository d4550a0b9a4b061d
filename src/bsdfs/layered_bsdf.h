// A base under a dielectric coat, with a medium between them: varnished wood, lacquered metal.
#pragma once

#include "bsdfs/conductor_bsdf.h"
#include "bsdfs/dielectric_bsdf.h"
#include "bsdfs/diffuse_bsdf.h"

#include <array>

namespace vitrine {

/// What lies between coat and base, and how far walks in it go.
struct CoatMedium {
    float thickness = 0.01f;     ///< in mean free paths: the medium's extinction is 1
    SampledSpectrum albedo{0};   ///< share of an extinction that is scattered on; all 0: it only absorbs
    float g = 0;                 ///< of Henyey & Greenstein's phase function
    std::uint16_t maxDepth = 10; ///< events between the coat and the base: paths of more are left out
    std::uint16_t samples = 1;   ///< walks for each value
};

/// The position-free random walk of Guo, Hasan & Zhao (2018, "Position-free Monte Carlo simulation for arbitrary layered
/// BSDFs") with the parameters of pbrt-v4's layered materials. Both layers are infinite planes; the surface looks the same
/// from both sides. Values and densities have no closed form: f() and pdf() are estimates by walks whose random numbers are
/// a function of the two directions and the seed, so that the same question has the same answer; their means, over seeds,
/// are the model's value and the density of sample(). sample() draws a direction by a walk that goes by chance alone,
/// of weight f |cos| / pdf at most 1; its pdf is pdf() of that direction.
template <class Base>
class LayeredBsdf {
  public:
    LayeredBsdf(const DielectricBsdf& coat, const Base& base, const CoatMedium& medium, std::uint32_t seed);

    float roughness() const;
    unsigned lobes() const;
    SampledSpectrum f(const V3f& wo, const V3f& wi, TransportMode mode) const;
    float pdf(const V3f& wo, const V3f& wi, TransportMode mode) const;
    std::optional<BsdfSample> sample(const V3f& wo, float uc, const V2f& u, TransportMode mode) const;
    void regularize() {
        coat_.regularize();
        base_.regularize();
    }

  private:
    struct Values;
    struct Densities;
    struct Scatter;
    /// What walks that come to wi by an even chance of all ways bring in the mean, for one of the measures above.
    template <class Measure>
    class Estimate;
    enum class Question : std::uint32_t { Value, Density, Sample };

    bool hasMedium() const { return albedo_ != std::array<std::uint16_t, spectrumSamples>{}; }
    SampledSpectrum albedo() const;
    bool isBaseSmooth() const { return base_.lobes() & lobe::specular; }
    std::optional<Scatter> scatter(const V3f& wo, float uc, const V2f& u, TransportMode mode) const;

    // In this order no space is lost: GatherPoint holds one for each eye path.
    [[no_unique_address]] Base base_;
    float thickness_, g_;
    [[no_unique_address]] DielectricBsdf coat_;
    std::uint16_t samples_;
    std::array<std::uint16_t, spectrumSamples> albedo_; ///< in units of 1 / 65535
    std::uint32_t seed_;
    std::uint16_t maxDepth_;
};

using CoatedDiffuseBsdf = LayeredBsdf<DiffuseBsdf>;
using CoatedConductorBsdf = LayeredBsdf<ConductorBsdf>;

extern template class LayeredBsdf<DiffuseBsdf>;
extern template class LayeredBsdf<ConductorBsdf>;

} // namespace vitrine
