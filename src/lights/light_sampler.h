// Which light to ask.
#pragma once

#include "core/sampling.h"
#include "lights/light.h"

#include <unordered_map>

namespace vitrine {

/// Lights chosen by power (mean over the visible wavelengths), the same everywhere.
class LightSampler {
  public:
    struct Sample {
        const Light* light = nullptr;
        float probability = 0;
    };
    LightSampler() = default;
    explicit LightSampler(std::vector<LightPtr> lights);

    bool empty() const { return lights_.empty(); }
    /// \pre not empty()
    Sample sample(float u) const {
        const auto s = table_.sample(u);
        return {lights_[std::size_t(s.index)].get(), s.probability};
    }
    float probability(const Light* light) const;
    const std::vector<LightPtr>& lights() const { return lights_; }

  private:
    std::vector<LightPtr> lights_;
    AliasTable table_;
    std::unordered_map<const Light*, float> probability_;
};

} // namespace vitrine
