// LightSource "spot".
#pragma once

#include "core/motion.h"
#include "lights/light.h"

namespace vitrine {

/// LightSource "spot": shines from one point into a cone whose rim falls off smoothly.
///
/// | name           | type     | unit        | default              | meaning |
/// |----------------|----------|-------------|----------------------|---------|
/// | I              | spectrum | cd          | colour space's white | intensity on the axis |
/// | scale          | float    |             | 1                    | multiplies I |
/// | power          | float    | lm          | -1                   | if positive: what the light emits in all |
/// | from           | point3   | scene units | 0 0 0                | where it is |
/// | to             | point3   | scene units | 0 0 1                | where it aims |
/// | coneangle      | float    | degrees     | 30                   | half angle of the cone: no light beyond |
/// | conedeltaangle | float    | degrees     | 5                    | width of the rim in which the light falls off |
class SpotLight final : public Light {
  public:
    struct Cone {
        double angle = 30, delta = 5; ///< degrees
    };
    struct Parameters {
        SpectrumPtr i;
        double scale = 1;
        double power = -1;
        V3d from{0, 0, 0}, to{0, 0, 1};
        Cone cone;
    };
    /// By pbrt's rule (lights/emission.h); `unit` for the power is power() at one candela.
    /// \throws std::invalid_argument if from is to, and as scaledEmission and the constructor do
    static std::shared_ptr<SpotLight> create(const Transform& worldFromLight, const Parameters& parameters);
    /// One that may move. \throws likewise
    static LightPtr create(const Motion& worldFromLight, const Shutter& shutter, const Parameters& parameters);

    /// \param worldFromSpot the light sits in the origin of its space and aims along +z
    /// \param intensity already scaled
    /// \throws std::invalid_argument unless 0 < angle <= 180 and 0 <= delta <= angle
    SpotLight(const Transform& worldFromSpot, SpectrumPtr intensity, const Cone& cone);

    SampledSpectrum power(const SampledWavelengths& lambda) const override;
    Box3d bounds() const override { return Box3d(position_); }
    LightBounds partBounds(unsigned part) const override;
    std::optional<LightSample> sample(const LightReceiver& at, const V2f& u,
                                      const SampledWavelengths& lambda) const override;
    std::optional<LightEmission> emit(const V2f& uPosition, const V2f& uDirection, const SampledWavelengths& lambda,
                                      double time = 0) const override;
    bool isDelta() const override { return true; }

  private:
    /// Part of the intensity at this angle from the axis.
    double falloff(double cosTheta) const;
    /// Its integral over the sphere: the mean of a smoothstep in the cosine is one half.
    double solidAngle() const;
    /// Cosine from the axis with density in proportion to the falloff.
    double sampleCosine(double u) const;

    Transform spotFromWorld_;
    V3d position_;
    SpectrumPtr intensity_;
    double cosStart_, cosEnd_; ///< where the falloff starts and ends
};

} // namespace vitrine
