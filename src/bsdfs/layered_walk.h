// How layered BSDFs walk between their layers; a part of layered_bsdf.cpp.
#pragma once

#include "bsdfs/henyey_greenstein.h"
#include "bsdfs/layered_bsdf.h"
#include "core/random.h"
#include "core/sampling.h"

namespace vitrine {

namespace layered {

/// A walk whose weight has fallen below this goes on with a chance of that weight.
inline constexpr float rouletteBelow = 0.25f;
inline V2f next2D(RandomStream& random) {
    const float x = random.uniform();
    return V2f(x, random.uniform());
}

/// Share that comes through this depth of the medium unscattered. 1e-30: 0 / 0 of a layer without depth is no loss.
inline float through(float depth, const V3f& w) {
    return std::exp(-depth / std::max(std::abs(w.z), 1e-30f));
}

inline float greatest(const SampledSpectrum& weight) {
    return weight.max();
}
inline float greatest(float weight) {
    return weight;
}

/// A walk's state: it travels along w, `depth` below the coat.
struct Traveller {
    V3f w;
    float depth = 0;

    enum class Meets { Medium, Coat, Base };
    /// To where it meets something. In a medium that scatters, flights end by chance.
    Meets fly(float thickness, bool scatters, RandomStream& random) {
        const bool up = w.z > 0;
        if (scatters) {
            const float descent = -std::log1p(-random.uniform()) * -w.z, to = depth + descent;
            if (to > 0 && to < thickness) {
                depth = to;
                return Meets::Medium;
            }
        }
        depth = up ? 0 : thickness;
        return up ? Meets::Coat : Meets::Base;
    }
};

} // namespace layered

/// The measure of f(): what a walk's steps do to light. Kernels hold the cosine of the direction that they lead to, but
/// for the last one.
template <class Base>
struct LayeredBsdf<Base>::Values {
    using Weight = SampledSpectrum;
    const LayeredBsdf& b;
    TransportMode mode;
    SampledSpectrum albedo = b.albedo();

    Weight step(const DielectricBsdf::SideSample& s) const { return Weight(s.f * std::abs(s.wi.z) / s.pdf); }
    Weight step(const BsdfSample& s) const { return s.f * (std::abs(s.wi.z) / s.pdf); }
    Weight atBase(const V3f& wo, const V3f& wi) const { return b.base_.f(wo, wi, mode) * std::abs(wi.z); }
    Weight scattering() const { return albedo; }
    float passing(float share) const { return share; }
    /// On through the coat along the way that was looked for from outside (in the other mode: the same way, backwards).
    Weight leaving(const DielectricBsdf::SideSample& back, const V3f&) const { return Weight(back.f / back.pdf); }
    Weight atCoat(const V3f& wo, const V3f& wi) const { return b.coat_.f(wo, wi, mode); }
};

/// The measure of pdf(): by which chance sample() takes the steps.
template <class Base>
struct LayeredBsdf<Base>::Densities {
    using Weight = float;
    const LayeredBsdf& b;
    TransportMode mode;

    Weight step(const DielectricBsdf::SideSample& s) const { return s.chance; }
    Weight step(const BsdfSample&) const { return 1; }
    Weight atBase(const V3f& wo, const V3f& wi) const { return b.base_.pdf(wo, wi, mode); }
    Weight scattering() const { return 1; }
    /// A medium that only absorbs ends no walks: it takes from their weight.
    float passing(float share) const { return b.hasMedium() ? share : 1; }
    Weight leaving(const DielectricBsdf::SideSample& back, const V3f& wi) const {
        if (!b.coat_.isSmooth()) return b.coat_.pdf(back.wi, wi, mode) / back.pdf;
        // d(inside) / d(outside), by Snell's law.
        return back.chance * std::abs(wi.z) / (sqr(b.coat_.eta()) * std::abs(back.wi.z));
    }
    Weight atCoat(const V3f& wo, const V3f& wi) const { return b.coat_.pdf(wo, wi, mode); }
};

/// Walks from wo down into the layers, which at each of their events look for wi: by a way that was chosen from wi
/// inwards, and, where the coat is rough, by the way that they take themselves. The power heuristic weighs both.
template <class Base>
template <class Measure>
class LayeredBsdf<Base>::Estimate {
  public:
    using Weight = typename Measure::Weight;

    Estimate(const LayeredBsdf& b, const V3f& wo, const V3f& wi, TransportMode mode, RandomStream& random)
        : b_(b), measure_{b, mode}, phase_(b.g_), wo_(wo), wi_(wi), mode_(mode), random_(random) {}

    /// Of one walk.
    Weight walk() {
        const TransportMode other =
            mode_ == TransportMode::Radiance ? TransportMode::Importance : TransportMode::Radiance;
        const auto entering = b_.coat_.sampleSide(wo_, false, layered::next2D(random_), mode_);
        back_ = b_.coat_.sampleSide(wi_, false, layered::next2D(random_), other);
        if (!entering || !back_) return Weight(0);
        at_ = {entering->wi};
        beta_ = measure_.step(*entering);
        const float entered = layered::greatest(beta_);
        sum_ = Weight(0);
        for (int event = 0; event < b_.maxDepth_; ++event) {
            if (const float left = layered::greatest(beta_) / entered; left < layered::rouletteBelow) {
                if (!(random_.uniform() < left)) break;
                beta_ *= 1 / left;
            }
            const float from = at_.depth;
            const auto meets = at_.fly(b_.thickness_, b_.hasMedium(), random_);
            if (!b_.hasMedium()) beta_ *= measure_.passing(layered::through(std::abs(at_.depth - from), at_.w));
            if (meets == layered::Traveller::Meets::Medium)
                inMedium(event);
            else if (!(meets == layered::Traveller::Meets::Coat ? atCoat() : atBase()))
                break;
        }
        return sum_;
    }

  private:
    /// \param event how many there were before
    void inMedium(int event) {
        beta_ *= measure_.scattering();
        if (b_.coat_.isSmooth() && b_.isBaseSmooth()) {
            connectByMirrors(b_.maxDepth_ - event);
        } else {
            const float towards = phase_(at_.w, -back_->wi);
            connect(Weight(towards), towards);
        }
        const V3f w = phase_.sample(at_.w, layered::next2D(random_));
        const float density = phase_(at_.w, w);
        at_.w = w;
        look(density);
    }
    bool atCoat() {
        const auto s = b_.coat_.sampleSide(-at_.w, true, layered::next2D(random_), mode_);
        if (!s) return false;
        beta_ *= measure_.step(*s);
        at_.w = s->wi;
        return true;
    }
    bool atBase() {
        const bool smooth = b_.isBaseSmooth();
        if (!smooth) connect(measure_.atBase(-at_.w, -back_->wi), b_.base_.pdf(-at_.w, -back_->wi, mode_));
        const float uc = random_.uniform();
        const auto s = b_.base_.sample(-at_.w, uc, layered::next2D(random_), mode_);
        if (!s) return false;
        beta_ *= measure_.step(*s);
        at_.w = s->wi;
        look(smooth ? infinity : s->pdf);
        return true;
    }
    /// Along the way that comes in from wi. \param density with which the walk would take it itself
    void connect(const Weight& kernel, float density) {
        const float share = b_.coat_.isSmooth() ? 1 : powerShare(back_->pdf, density);
        sum_ += beta_ * kernel * measure_.leaving(*back_, wi_) *
                (share * measure_.passing(layered::through(at_.depth, back_->wi)));
    }
    /// Between two mirrors no later event finds wi: the way that comes in from there goes up and down here as long as it may.
    /// (pbrt-v4 takes the first stretch alone.) \param stretches at most
    void connectByMirrors(int stretches) {
        Weight share = beta_ * measure_.leaving(*back_, wi_);
        V3f w = back_->wi;
        for (int i = 0; i < stretches && layered::greatest(share) > 0; ++i) {
            const bool down = w.z < 0;
            const float way = down ? at_.depth : b_.thickness_ - at_.depth;
            sum_ += share * (phase_(at_.w, -w) * measure_.passing(layered::through(way, w)));
            if (down) {
                const auto s = b_.base_.sample(-w, 0, V2f(0), mode_);
                share *= s ? measure_.step(*s) : Weight(0);
            } else {
                const auto s = b_.coat_.sampleSide(-w, true, V2f(0), mode_);
                share *= s ? measure_.step(*s) : Weight(0);
            }
            share *= measure_.passing(layered::through(b_.thickness_, w));
            w.z = -w.z;
        }
    }
    /// From the walk's own new direction through a rough coat. \param density of that direction
    void look(float density) {
        if (b_.coat_.isSmooth() || at_.w.z <= 0) return;
        const float share = powerShare(density, b_.coat_.sidePdf(wi_, -at_.w));
        sum_ += beta_ * measure_.atCoat(-at_.w, wi_) * (share * measure_.passing(layered::through(at_.depth, at_.w)));
    }
    static float powerShare(float density, float other) {
        return std::isinf(density) ? 1 : powerHeuristic(density, other);
    }

    const LayeredBsdf& b_;
    Measure measure_;
    HenyeyGreenstein phase_;
    V3f wo_, wi_;
    TransportMode mode_;
    RandomStream& random_;
    std::optional<DielectricBsdf::SideSample> back_;
    layered::Traveller at_;
    Weight beta_{}, sum_{};
};

} // namespace vitrine
