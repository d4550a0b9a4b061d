// LightSource "distant".
#pragma once

#include "core/motion.h"
#include "lights/light.h"
#include "lights/scene_sphere.h"

namespace vitrine {

/// LightSource "distant": parallel light from infinitely far away.
///
/// | name        | type     | unit | default              | meaning |
/// |-------------|----------|------|----------------------|---------|
/// | L           | spectrum | lx   | colour space's white | illuminance of a surface across the light |
/// | scale       | float    |      | 1                    | multiplies L |
/// | illuminance | float    | lx   | -1                   | if positive: multiplies L too, so for an L of one lux it is the illuminance |
/// | from, to    | point3   |      | 0 0 0, 0 0 1         | the light runs from `from` towards `to` |
class DistantLight final : public Light {
  public:
    struct Parameters {
        SpectrumPtr l;
        double scale = 1;
        double illuminance = -1;
        V3d from{0, 0, 0}, to{0, 0, 1};
    };
    /// By pbrt's rule (lights/emission.h); `unit` for the illuminance is 1.
    /// \throws std::invalid_argument if from is to, and as scaledEmission does
    static std::shared_ptr<DistantLight> create(const Transform& worldFromLight, const Parameters& parameters);
    /// One that may move. \throws likewise
    static LightPtr create(const Motion& worldFromLight, const Shutter& shutter, const Parameters& parameters);

    /// \param towardsLight world direction, of any length  \param irradiance across the light, already scaled
    DistantLight(const V3d& towardsLight, SpectrumPtr irradiance)
        : wi_(towardsLight.normalized()), irradiance_(std::move(irradiance)) {}

    /// What falls on the disk of the scene's bounding sphere.
    SampledSpectrum power(const SampledWavelengths& lambda) const override { return powerInto(scene_, lambda); }
    SampledSpectrum powerInto(const SceneSphere& sphere, const SampledWavelengths& lambda) const override;
    std::optional<LightSample> sample(const LightReceiver& at, const V2f& u,
                                      const SampledWavelengths& lambda) const override;
    std::optional<LightEmission> emit(const V2f& uPosition, const V2f& uDirection, const SampledWavelengths& lambda,
                                      double time = 0) const override;
    bool isDelta() const override { return true; }
    void preprocess(const V3d& center, double radius) override { scene_ = {center, radius}; }

  private:
    V3d wi_;
    SpectrumPtr irradiance_;
    SceneSphere scene_;
};

} // namespace vitrine
