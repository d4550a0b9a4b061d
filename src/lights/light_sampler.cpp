#include "lights/light_sampler.h"

#include "lights/scene_sphere.h"

namespace vitrine {

namespace {

/// The share of the choice that goes to all lights that shine alike. Power tells nothing of distance and shadow: where
/// another light than the mightiest is all there is, the variance grows by no more than the inverse of its part of this.
constexpr double evenShare = 0.2;

struct Shine {
    double power = 0;    ///< as a picture sees it: by the sum of the matching functions
    bool isDark = false; ///< at every nanometre
};

/// Wavelengths less than a nanometre apart over the whole range: nothing between them, however narrow, is missed, as
/// what lights emit has one value a nanometre.
Shine shineOf(const Light& light, const SceneSphere& lit) {
    constexpr int strata = 236; // of four wavelengths each: half a nanometre
    Shine shine{0, true};
    // Shapes of infinite area cannot be sampled.
    if (const Box3d box = light.bounds(); !box.isEmpty() && !isFinite(box.size())) return shine;
    for (int i = 0; i < strata; ++i) {
        const auto lambda = SampledWavelengths::uniform((float(i) + 0.5f) / strata / spectrumSamples);
        const SampledSpectrum power = light.powerInto(lit, lambda);
        shine.isDark &= power.isBlack();
        const SampledSpectrum seen = cieX().sample(lambda) + cieY().sample(lambda) + cieZ().sample(lambda);
        // In a scene of enormous size power may overflow.
        shine.power += double(std::min((power * seen).average(), std::numeric_limits<float>::max()));
    }
    // Into a tiny sphere lights at infinity shine less than floats hold.
    if (shine.isDark && lit.radius < 1) shine.isDark = shineOf(light, {lit.center, 1}).isDark;
    return shine;
}

std::vector<double> weightsByPower(const std::vector<LightPtr>& lights, const SceneSphere& lit) {
    std::vector<Shine> shines;
    double total = 0;
    std::size_t shining = 0;
    for (const LightPtr& light : lights) {
        shines.push_back(shineOf(*light, lit));
        total += shines.back().power;
        shining += !shines.back().isDark;
    }
    std::vector<double> weights;
    for (const Shine& shine : shines) {
        const double even = shine.isDark ? 0 : 1 / double(shining);
        weights.push_back(total > 0 ? (1 - evenShare) * shine.power / total + evenShare * even : even);
    }
    return weights;
}

} // namespace

LightSampler::LightSampler(std::vector<LightPtr> lights, const SceneSphere& lit, Choice choice)
    : lights_(std::move(lights)) {
    if (lights_.empty()) return;
    table_ =
        AliasTable(choice == Choice::Power ? weightsByPower(lights_, lit) : std::vector<double>(lights_.size(), 1.));
    for (std::size_t i = 0; i < lights_.size(); ++i)
        probability_[lights_[i].get()] = table_.probability(int(i));
}

float LightSampler::probability(const Light* light) const {
    const auto found = probability_.find(light);
    return found == probability_.end() ? 0 : found->second;
}

} // namespace vitrine
