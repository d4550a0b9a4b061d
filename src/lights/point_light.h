// LightSource "point".
#pragma once

#include "core/motion.h"
#include "lights/light.h"

namespace vitrine {

/// LightSource "point": shines alike in all directions from one point.
///
/// | name  | type     | unit        | default              | meaning |
/// |-------|----------|-------------|----------------------|---------|
/// | I     | spectrum | cd          | colour space's white | intensity |
/// | scale | float    |             | 1                    | multiplies I |
/// | power | float    | lm          | -1                   | if positive: what the light emits in all |
/// | from  | point3   | scene units | 0 0 0                | where it is |
class PointLight final : public Light {
  public:
    struct Parameters {
        SpectrumPtr i;
        double scale = 1;
        double power = -1;
        V3d from{0, 0, 0};
    };
    /// By pbrt's rule (lights/emission.h); `unit` for the power is 4 pi.
    /// \throws std::invalid_argument as scaledEmission does
    static std::shared_ptr<PointLight> create(const Transform& worldFromLight, const Parameters& parameters);
    /// One that may move. \throws likewise
    static LightPtr create(const Motion& worldFromLight, const Shutter& shutter, const Parameters& parameters);

    /// \param position in the world  \param intensity already scaled
    PointLight(const V3d& position, SpectrumPtr intensity) : position_(position), intensity_(std::move(intensity)) {}

    SampledSpectrum power(const SampledWavelengths& lambda) const override;
    Box3d bounds() const override { return Box3d(position_); }
    std::optional<LightSample> sample(const LightReceiver& at, const V2f& u,
                                      const SampledWavelengths& lambda) const override;
    std::optional<LightEmission> emit(const V2f& uPosition, const V2f& uDirection, const SampledWavelengths& lambda,
                                      double time = 0) const override;
    bool isDelta() const override { return true; }

  private:
    V3d position_;
    SpectrumPtr intensity_;
};

} // namespace vitrine
