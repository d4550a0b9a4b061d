// Which light to ask.
#pragma once

#include "core/sampling.h"
#include "lights/light.h"

#include <unordered_map>

namespace vitrine {

/// Lights chosen with the same probabilities everywhere.
class LightSampler {
  public:
    enum class Choice {
        Power,  ///< four fifths in proportion to power as a picture sees it, one fifth alike among all that shine at
                ///< any wavelength; dark lights (and infinite shapes, which cannot be sampled) never, unless all are so
        Uniform ///< all alike
    };
    struct Sample {
        const Light* light = nullptr;
        float probability = 0;
    };
    LightSampler() = default;
    /// \param lit what is to be lit, with the lights: how much of a light at infinity counts
    LightSampler(std::vector<LightPtr> lights, const SceneSphere& lit, Choice choice = Choice::Power);

    bool empty() const { return lights_.empty(); }
    /// \pre not empty()
    Sample sample(float u) const {
        const auto s = table_.sample(u);
        return {lights_[std::size_t(s.index)].get(), s.probability};
    }
    /// Of sample() giving this light; 0 for a light that is not among them.
    float probability(const Light* light) const;
    const std::vector<LightPtr>& lights() const { return lights_; }

  private:
    std::vector<LightPtr> lights_;
    AliasTable table_;
    std::unordered_map<const Light*, float> probability_;
};

} // namespace vitrine
