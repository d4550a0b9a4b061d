#include "lights/light_sampler.h"

namespace vitrine {

namespace {

/// Mean of the power over wavelengths drawn as the eye's are, so that infrared does not count like green.
double visiblePower(const Light& light) {
    constexpr int strata = 16;
    double sum = 0;
    for (int i = 0; i < strata; ++i)
        sum += light.power(SampledWavelengths::visible((float(i) + 0.5f) / strata)).average();
    const double power = sum / strata;
    // Shapes of infinite area cannot be sampled.
    return std::isfinite(power) ? std::max(power, 0.) : 0;
}

} // namespace

LightSampler::LightSampler(std::vector<LightPtr> lights, Choice choice) : lights_(std::move(lights)) {
    if (lights_.empty()) return;
    std::vector<double> weights;
    for (const LightPtr& light : lights_)
        weights.push_back(choice == Choice::Power ? visiblePower(*light) : 1);
    table_ = AliasTable(weights);
    for (std::size_t i = 0; i < lights_.size(); ++i)
        probability_[lights_[i].get()] = table_.probability(int(i));
}

float LightSampler::probability(const Light* light) const {
    const auto found = probability_.find(light);
    return found == probability_.end() ? 0 : found->second;
}

} // namespace vitrine
