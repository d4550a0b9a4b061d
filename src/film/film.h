// The film: sums of weighted samples per pixel that do not depend on the order of adding.
#pragma once

#include "core/image.h"
#include "film/filter.h"
#include "film/fixed_sum.h"
#include "film/imageio.h"
#include "spectrum/colorspace.h"

#include <optional>
#include <span>

namespace vitrine {

/// Film "rgb": the picture, in linear RGB of the colour space that is current at the directive.
///
/// | name              | type       | unit   | default         | meaning |
/// |-------------------|------------|--------|-----------------|---------|
/// | xresolution       | integer    | pixels | 1280            | width of the full picture |
/// | yresolution       | integer    | pixels | 720             | height of the full picture |
/// | cropwindow        | float[4]   |        | 0 1 0 1         | x0 x1 y0 y1, shares of width and height: the part that is rendered |
/// | pixelbounds       | integer[4] | pixels | everything      | x0 x1 y0 y1, the ends not included: the same in pixels; cropwindow goes first |
/// | filename          | string     |        | the scene's own name with .exr | picture to write unless the command line names one |
/// | maxcomponentvalue | float      |        | infinity        | a sample whose largest value on the sensor is above is scaled down to it |
/// | iso               | float      |        | 100             | the picture is multiplied by the camera's exposure time times iso / 100 |
/// | shutteropen, shutterclose | float | s   | 0, 1            | of the Camera directive: their difference is the exposure time, and what moves is seen where it is between them |
/// | sensor            | string     |        | "cie1931"       | the only one there is: XYZ matching functions |
/// | whitebalance      | float      | K      | 0               | only 0, none, is supported |
struct FilmSettings {
    V2i resolution{1280, 720};
    /// Half-open pixel rectangle that is rendered: min (inclusive), max (exclusive).
    V2i cropMin{0, 0}, cropMax{1280, 720};
    const RgbColorSpace* colorSpace = nullptr; ///< null: sRGB
    /// Samples whose largest sensor value (XYZ x imagingRatio, as pbrt-v4's sensor "cie1931") is above are scaled down.
    float maxComponentValue = infinity;
    float imagingRatio = 1; ///< exposure time x ISO / 100 (pbrt-v4's sensor "cie1931")
    Filter::Settings filter;

    V2i cropSize() const { return cropMax - cropMin; }
};

/// The picture being made. Different pixels may be added to from different threads at once; one pixel may not.
class Film {
  public:
    static constexpr std::size_t sumsPerPixel = 8; ///< two halves of r, g, b, weight
    static constexpr std::size_t bytesPerPixel = sumsPerPixel * sizeof(FixedSum) + sizeof(std::uint32_t);

    /// \throws std::invalid_argument for an empty, inverted or absurd rectangle (more than 2^31 pixels, or outside the
    ///         picture), and for limits and ratios that are not positive
    explicit Film(const FilmSettings& settings);

    const FilmSettings& settings() const { return settings_; }
    const Filter& filter() const { return filter_; }

    /// \param pixel in the full picture's coordinates, inside the crop rectangle
    /// \param half which of the two half-buffers (even or odd samples) the sample belongs to: 0 or 1
    void add(const V2i& pixel, const SampledSpectrum& radiance, const SampledWavelengths& lambda, float weight,
             unsigned half);
    /// Adds to a pixel without weighing: what a light path leaves, a share of the pass's value for it.
    void addSplat(const V2i& pixel, const SampledSpectrum& value, const SampledWavelengths& lambda, unsigned half);
    /// Says that a whole pass used these wavelengths for all its samples. Few wavelengths sum up a spectrum wrongly, and
    /// all pixels in the same way: image() scales each channel by what the passes' wavelengths make of the colour
    /// space's white. Not for several threads at a time.
    void addPassWavelengths(const SampledWavelengths& lambda);
    /// Adds another film's sums (same settings). \throws std::invalid_argument when the sizes differ
    void merge(const Film& other);

    /// Linear RGB in the film's colour space, crop window only, 3 channels; 0 where no sample fell.
    Image image() const;
    /// Mean relMSE of image(), estimated from the two half-buffers: design.md's relMSE with b the mean m of both
    /// halves. With the halves' means a0, a1 and weights w0, w1, the squared error of m is estimated by (a0 - a1)^2 w0
    /// w1 / (w0 + w1)^2, whose expectation is m's variance when all samples have one variance. A pixel that lacks a
    /// half counts as infinite.
    double estimatedRelMse() const;

    /// Samples that were NaN or infinite (left out) and those that drove a sum beyond its range (which then stays at its
    /// end): both zero in a sound render.
    std::uint64_t badSamples() const;
    /// The first pixel that had one, in the full picture's coordinates; empty when none had.
    std::optional<V2i> firstBadPixel() const;

    /// Raw sums for checkpoints: per pixel of the crop window and half: r, g, b, weight; in the end those of the white
    /// that addPassWavelengths() saw, and their count.
    std::span<const FixedSum> sums() const { return sums_; }
    std::span<FixedSum> sums() { return sums_; }
    /// Per pixel: samples that badSamples() counts.
    std::span<const std::uint32_t> badCounts() const { return bad_; }
    std::span<std::uint32_t> badCounts() { return bad_; }

  private:
    std::size_t index(const V2i& pixel) const {
        return (std::size_t(pixel.y - settings_.cropMin.y) * std::size_t(settings_.cropSize().x) +
                std::size_t(pixel.x - settings_.cropMin.x));
    }

    void addToSums(std::size_t pixel, const Rgb& rgb, float weight, unsigned half);
    std::size_t pixelCount() const { return bad_.size(); }
    /// What the channels of image() are multiplied by.
    V3d whiteScale() const;

    FilmSettings settings_;
    Filter filter_;
    std::vector<FixedSum> sums_;     ///< [pixel][half][r g b weight], then white's [r g b count]
    std::vector<std::uint32_t> bad_; ///< per pixel, as no thread shares a pixel with another
};

/// What pictures of such a film carry beside their pixels: the crop's place and the colour space.
ImageMetadata metadataOf(const FilmSettings& settings);

} // namespace vitrine
