// LightSource "infinite" without an image.
#pragma once

#include "lights/light.h"
#include "lights/scene_sphere.h"

namespace vitrine {

/// LightSource "infinite" (constant): the same radiance from everywhere.
///
/// | name        | type     | unit | default              | meaning |
/// |-------------|----------|------|----------------------|---------|
/// | L           | spectrum | nit  | colour space's white | radiance |
/// | scale       | float    |      | 1                    | multiplies L |
/// | illuminance | float    | lx   | -1                   | if positive: of an upward surface, for an L of one nit |
class ConstantInfiniteLight final : public Light {
  public:
    struct Parameters {
        SpectrumPtr l;
        double scale = 1;
        double illuminance = -1;
    };
    /// By pbrt's rule (lights/emission.h); `unit` for the illuminance is pi.
    /// \throws std::invalid_argument as scaledEmission does
    static std::shared_ptr<ConstantInfiniteLight> create(const Parameters& parameters);

    /// \param l radiance, already scaled
    explicit ConstantInfiniteLight(SpectrumPtr l) : l_(std::move(l)) {}

    /// What falls on the scene's bounding sphere.
    SampledSpectrum power(const SampledWavelengths& lambda) const override { return powerInto(scene_, lambda); }
    SampledSpectrum powerInto(const SceneSphere& sphere, const SampledWavelengths& lambda) const override;
    std::optional<LightSample> sample(const LightReceiver& at, const V2f& u,
                                      const SampledWavelengths& lambda) const override;
    std::optional<LightEmission> emit(const V2f& uPosition, const V2f& uDirection, const SampledWavelengths& lambda,
                                      double time = 0) const override;
    SampledSpectrum escaped(const V3f&, const SampledWavelengths& lambda) const override { return l_->sample(lambda); }
    float pdf(const V3f&) const override { return invPi / 4; }
    bool isInfinite() const override { return true; }
    void preprocess(const V3d& center, double radius) override { scene_ = {center, radius}; }

  private:
    SpectrumPtr l_;
    SceneSphere scene_;
};

} // namespace vitrine
