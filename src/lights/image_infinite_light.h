// LightSource "infinite" with an image.
#pragma once

#include "core/sampling.h"
#include "core/transform.h"
#include "lights/environment_image.h"
#include "lights/light.h"
#include "lights/scene_sphere.h"

namespace vitrine {

/// LightSource "infinite" (image): radiance from all directions by an image.
///
/// | name        | type   | unit | default | meaning |
/// |-------------|--------|------|---------|---------|
/// | filename    | string |      |         | image, linear RGB in nits: square in pbrt-v4's equal-area mapping, or (not in pbrt) twice as wide as high in latitude and longitude |
/// | scale       | float  |      | 1       | multiplies the image |
/// | illuminance | float  | lx   | -1      | if positive: scales the image to this illuminance of an upward surface, in pbrt-v4's count |
///
/// Directions are drawn texel by texel in proportion to the mean radiance over the texel, so the density is nowhere zero
/// where the radiance is not. pbrt-v4's compensated density is not used: it is zero below the mean, and wrong where no
/// BSDF sample competes.
class ImageInfiniteLight final : public Light {
  public:
    struct Parameters {
        const RgbColorSpace* colorSpace = nullptr; ///< the image's; null: sRGB
        EnvironmentMapping mapping = EnvironmentMapping::EqualArea;
        /// None: Nearest for EqualArea, where pbrt-v4 looks up so, Bilinear for LatLong.
        std::optional<EnvironmentLookup> lookup;
        double scale = 1;
        double illuminance = -1;
    };
    /// By pbrt's rule: scale, divided by photometric() of the colour space's white; if an illuminance is given times that
    /// over the image's.
    /// \throws std::invalid_argument as EnvironmentImage, the constructor and emissionScale (lights/emission.h) do
    static std::shared_ptr<ImageInfiniteLight> create(const Transform& worldFromLight, const Image& image,
                                                      const Parameters& parameters);

    /// \param scale multiplies the texels' illuminant spectra
    /// \throws std::invalid_argument for a transform that changes angles; uniform scales drop out
    ImageInfiniteLight(const Transform& worldFromLight, EnvironmentImage image, float scale);

    /// What falls on the scene's bounding sphere, by the spectrum of the image's mean colour.
    SampledSpectrum power(const SampledWavelengths& lambda) const override { return powerInto(scene_, lambda); }
    SampledSpectrum powerInto(const SceneSphere& sphere, const SampledWavelengths& lambda) const override;
    std::optional<LightSample> sample(const LightReceiver& at, const V2f& u,
                                      const SampledWavelengths& lambda) const override;
    std::optional<LightEmission> emit(const V2f& uPosition, const V2f& uDirection, const SampledWavelengths& lambda,
                                      double time = 0) const override;
    SampledSpectrum escaped(const V3f& w, const SampledWavelengths& lambda) const override;
    float pdf(const V3f& w) const override;
    bool isInfinite() const override { return true; }
    void preprocess(const V3d& center, double radius) override { scene_ = {center, radius}; }

  private:
    V2f squareFromWorld(const V3f& w) const {
        return image_.grid().squareFromDirection(V3f(w.dot(x_), w.dot(y_), w.dot(z_)));
    }
    float pdfOfSquare(const V2f& square) const;

    EnvironmentImage image_;
    float scale_;
    V3f x_, y_, z_; ///< the light's axes in the world
    PiecewiseConstant2D density_;
    SceneSphere scene_;
};

} // namespace vitrine
