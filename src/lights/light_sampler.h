// Which light to ask.
#pragma once

#include "core/sampling.h"
#include "lights/light.h"
#include "lights/light_tree.h"

#include <unordered_map>

namespace vitrine {

/// The choice of lights: with the same probabilities everywhere for paths that start at lights, and for direct light the
/// same ones or by what each brings to the point that asks.
class LightSampler {
  public:
    enum class Choice {
        Power, ///< four fifths in proportion to power as a picture sees it, one fifth alike among all that shine at
               ///< any wavelength; dark lights (and infinite shapes, which cannot be sampled) never, unless all are so
        Uniform, ///< all alike
        Tree,    ///< direct light by a tree over the parts of lights (lights/light_tree.h), light paths by power
        Fitting  ///< Tree with more than fewParts parts of lights at finite places, else Power
    };
    /// With so few parts of lights power is quicker than the tree and serves as well.
    static constexpr std::size_t fewParts = 16;

    struct Sample {
        const Light* light = nullptr;
        float probability = 0;
    };
    LightSampler() = default;
    /// \param lit what is to be lit, with the lights: how much of a light at infinity counts
    LightSampler(std::vector<LightPtr> lights, const SceneSphere& lit, Choice choice = Choice::Power);

    /// Whether a light emits nothing at any nanometre (or is a shape of infinite area, which is never chosen).
    static bool isDark(const Light& light, const SceneSphere& lit);

    bool empty() const { return lights_.empty(); }
    /// For a path that starts at a light. \pre not empty()
    Sample sample(float u) const {
        const auto s = table_.sample(u);
        return {lights_[std::size_t(s.index)].get(), s.probability};
    }
    /// Of sample() giving this light; 0 for a light that is not among them.
    float probability(const Light* light) const;
    const std::vector<LightPtr>& lights() const { return lights_; }

    /// A direction towards a light that is chosen by uLight, its density (or probability, for delta lights) that of both
    /// choices together. \pre not empty()
    std::optional<LightSample> sample(const LightReceiver& at, float uLight, const V2f& u,
                                      const SampledWavelengths& lambda) const;
    /// Density of sample(at, ...) to give a point of a shape that shines, hit by a ray from there, per solid angle.
    float pdf(const LightReceiver& at, const AreaLight& light, const PrimitiveHit& hit,
              const SurfacePoint& point) const;
    /// And to give the direction of a ray that escapes to a light at infinity.
    float pdf(const Light& infinite, const V3f& w) const;
    /// Whether direct light goes by a tree.
    bool usesTree() const { return !groups_.empty(); }
    std::size_t memoryBytes() const;

  private:
    /// A light of its own, or all in the tree.
    struct Group {
        const Light* light = nullptr; ///< null: the tree
        double begin = 0;             ///< of its numbers in [0, 1)
        double probability = 0;
    };
    struct Leaf {
        const Light* light;
        unsigned part;
    };
    struct Known {
        float probability = 0;                 ///< of the table
        std::uint32_t firstLeaf = 0xffffffffu; ///< of the light's parts in the tree
        double group = 0;                      ///< probability of a light at infinity beside the tree
    };
    struct Shine;
    static Shine shineOf(const Light& light, const SceneSphere& lit);
    void plantTree(const std::vector<Shine>& shines);
    bool wantsTree(Choice choice) const;

    std::vector<LightPtr> lights_;
    AliasTable table_;
    std::unordered_map<const Light*, Known> known_;
    LightTree tree_;
    double treeProbability_ = 0;
    std::vector<Leaf> leaves_;
    std::vector<Group> groups_; ///< with the tree: what the choice is first between
};

} // namespace vitrine
