// The radiance of an environment image, texel by texel.
#pragma once

#include "core/image.h"
#include "lights/environment_grid.h"
#include "spectrum/colorspace.h"

namespace vitrine {

/// Between the texels' centres.
enum class EnvironmentLookup {
    Nearest, ///< as pbrt-v4: texels are flat
    Bilinear ///< the spectra of the four nearest texels are interpolated, also over the picture's edges
};

/// Texels as illuminant spectra: sigmoids of quadratics times the colour space's white (Jakob & Hanika 2019), uplifted once.
class EnvironmentImage {
  public:
    /// \param image at least three channels, of which the first are R G B; negative values count as zero
    /// \throws std::invalid_argument as EnvironmentGrid, for too few channels and for values that are not finite
    EnvironmentImage(const Image& image, const RgbColorSpace& colorSpace, EnvironmentMapping mapping,
                     EnvironmentLookup lookup);

    const EnvironmentGrid& grid() const { return grid_; }
    SampledSpectrum radiance(const V2f& square, const SampledWavelengths& lambda) const;
    /// The mean over the sphere, by its colour.
    const RgbIlluminantSpectrum& mean() const { return mean_; }
    /// Mean over each texel of the mean of R, G and B, row-major. Positive wherever radiance() is: under bilinear lookups
    /// nine texels reach into each.
    const std::vector<float>& texelMeans() const { return texelMeans_; }
    /// Luminous illuminance, for radiances in nits, of a surface whose normal is +z, in pbrt-v4's count: each texel of the
    /// upper half weighs half its solid angle, so the true value is twice that. Kept, as the same scene shall be as
    /// bright in both.
    double pbrtIlluminance() const { return pbrtIlluminance_; }

  private:
    struct Texel {
        SigmoidPolynomial polynomial;
        float scale; ///< of the polynomial's spectrum; zero for black
    };

    EnvironmentGrid grid_;
    EnvironmentLookup lookup_;
    const DenseSpectrum* white_;
    std::vector<Texel> texels_;
    RgbIlluminantSpectrum mean_;
    std::vector<float> texelMeans_;
    double pbrtIlluminance_;
};

} // namespace vitrine
