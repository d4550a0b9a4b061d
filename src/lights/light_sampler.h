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
        Power,  ///< in proportion to power, the mean over fixed wavelengths spread as the eye's sensitivity; lights of
                ///< no power (and of infinite power: infinite shapes) never, unless all are so
        Uniform ///< all alike
    };
    struct Sample {
        const Light* light = nullptr;
        float probability = 0;
    };
    LightSampler() = default;
    /// \pre each light's preprocess() was called: the power of lights at infinity depends on the scene's size
    explicit LightSampler(std::vector<LightPtr> lights, Choice choice = Choice::Power);

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
