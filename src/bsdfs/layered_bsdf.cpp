#include "bsdfs/layered_bsdf.h"

#include "bsdfs/layered_walk.h"

#include <bit>

namespace vitrine {

namespace {

using layered::next2D, layered::Traveller, layered::through;

/// Walks may answer that a direction is never drawn which has been; a floor of so much a steradian, 1e-5 in all, keeps the
/// weight of what was drawn finite.
constexpr float leastPdf = 1e-6f;

std::uint64_t bitsOf(float a, float b) {
    return std::uint64_t(std::bit_cast<std::uint32_t>(a)) << 32 | std::bit_cast<std::uint32_t>(b);
}

} // namespace

template <class Base>
struct LayeredBsdf<Base>::Scatter {
    V3f wi;
    SampledSpectrum weight; ///< f |cos| / pdf
    bool specular;
    float chance; ///< of a specular walk
};

template <class Base>
LayeredBsdf<Base>::LayeredBsdf(const DielectricBsdf& coat, const Base& base, const CoatMedium& medium,
                               std::uint32_t seed)
    : base_(base), thickness_(medium.thickness), g_(medium.g), coat_(coat), samples_(medium.samples), seed_(seed),
      maxDepth_(medium.maxDepth) {
    for (int i = 0; i < spectrumSamples; ++i)
        albedo_[std::size_t(i)] = std::uint16_t(std::lround(std::clamp(medium.albedo[i], 0.f, 1.f) * 65535));
}

template <class Base>
SampledSpectrum LayeredBsdf<Base>::albedo() const {
    return SampledSpectrum(albedo_[0], albedo_[1], albedo_[2], albedo_[3]) / 65535;
}

/// Of the narrowest of its lobes that is no delta: what a medium or a matt base scatters is wide under a smooth coat.
template <class Base>
float LayeredBsdf<Base>::roughness() const {
    float narrowest = 1;
    if (!coat_.isSmooth()) narrowest = std::min(narrowest, coat_.roughness());
    if (!isBaseSmooth()) narrowest = std::min(narrowest, base_.roughness());
    return lobes() & (lobe::diffuse | lobe::glossy) ? narrowest : 0;
}

template <class Base>
unsigned LayeredBsdf<Base>::lobes() const {
    unsigned all = lobe::reflection;
    if (coat_.isSmooth()) all |= lobe::specular;
    if (hasMedium() || base_.lobes() & lobe::diffuse)
        all |= lobe::diffuse;
    else if (!coat_.isSmooth() || base_.lobes() & lobe::glossy)
        all |= lobe::glossy;
    return all;
}

template <class Base>
SampledSpectrum LayeredBsdf<Base>::f(const V3f& wo, const V3f& wi, TransportMode mode) const {
    if (!(wo.z * wi.z > 0) || !(lobes() & (lobe::diffuse | lobe::glossy))) return {};
    const float side = std::copysign(1.f, wo.z);
    RandomStream random(seed_, std::uint32_t(Question::Value), bitsOf(wo.x, wo.y), bitsOf(wo.z, wi.x),
                        bitsOf(wi.y, wi.z));
    Estimate<Values> estimate(*this, wo * side, wi * side, mode, random);
    SampledSpectrum sum;
    for (int i = 0; i < samples_; ++i)
        sum += estimate.walk();
    return coat_.f(wo * side, wi * side, mode) + sum / float(samples_);
}

template <class Base>
float LayeredBsdf<Base>::pdf(const V3f& wo, const V3f& wi, TransportMode mode) const {
    if (!(wo.z * wi.z > 0) || !(lobes() & (lobe::diffuse | lobe::glossy))) return 0;
    const float side = std::copysign(1.f, wo.z);
    RandomStream random(seed_, std::uint32_t(Question::Density), bitsOf(wo.x, wo.y), bitsOf(wo.z, wi.x),
                        bitsOf(wi.y, wi.z));
    Estimate<Densities> estimate(*this, wo * side, wi * side, mode, random);
    float sum = 0;
    for (int i = 0; i < samples_; ++i)
        sum += estimate.walk();
    return coat_.pdf(wo * side, wi * side, mode) + std::max(sum / float(samples_), leastPdf);
}

/// A walk by chance alone, from wo above the surface until it leaves.
template <class Base>
auto LayeredBsdf<Base>::scatter(const V3f& wo, float uc, const V2f& u, TransportMode mode) const
    -> std::optional<Scatter> {
    RandomStream random(seed_, std::uint32_t(Question::Sample), bitsOf(wo.x, wo.y), bitsOf(wo.z, uc), bitsOf(u.x, u.y));
    Scatter walk{wo, SampledSpectrum(1), true, 1};
    const auto step = [&](const std::optional<BsdfSample>& s) {
        if (!s) return false;
        walk.weight *= s->f * (std::abs(s->wi.z) / s->pdf);
        walk.specular &= s->isSpecular();
        walk.chance *= s->pdf;
        walk.wi = s->wi;
        return true;
    };
    const auto first = coat_.sample(wo, uc, u, mode);
    if (!step(first)) return {};
    if (first->isReflection()) return walk;

    const HenyeyGreenstein phase(g_);
    const SampledSpectrum albedo = this->albedo();
    Traveller at{walk.wi};
    for (int event = 0; !walk.weight.isBlack();) {
        const float from = at.depth;
        const auto meets = at.fly(thickness_, hasMedium(), random);
        if (!hasMedium()) walk.weight *= through(std::abs(at.depth - from), at.w);
        if (meets == Traveller::Meets::Medium) {
            walk.weight *= albedo;
            walk.specular = false;
            at.w = phase.sample(at.w, next2D(random));
        } else {
            const float lobeNumber = random.uniform();
            const V2f direction = next2D(random);
            const bool isCoat = meets == Traveller::Meets::Coat;
            const auto s = isCoat ? coat_.sample(-at.w, lobeNumber, direction, mode)
                                  : base_.sample(-at.w, lobeNumber, direction, mode);
            if (!step(s)) return {};
            if (isCoat && s->isTransmission()) return walk;
            at.w = walk.wi;
        }
        if (++event > maxDepth_) return {};
    }
    return {};
}

template <class Base>
std::optional<BsdfSample> LayeredBsdf<Base>::sample(const V3f& wo, float uc, const V2f& u, TransportMode mode) const {
    if (inSurface(wo)) return {};
    const float side = std::copysign(1.f, wo.z);
    const auto walk = scatter(wo * side, uc, u, mode);
    if (!walk || walk->weight.isBlack() || inSurface(walk->wi)) return {};
    const V3f wi = walk->wi * side;
    const float density = walk->specular ? walk->chance : pdf(wo, wi, mode);
    const unsigned kind = walk->specular ? lobe::specular : lobes() & (lobe::diffuse | lobe::glossy);
    return BsdfSample{wi, walk->weight * (density / std::abs(wi.z)), density, lobe::reflection | kind};
}

template class LayeredBsdf<DiffuseBsdf>;
template class LayeredBsdf<ConductorBsdf>;

} // namespace vitrine
