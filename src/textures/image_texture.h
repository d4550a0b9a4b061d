// Texture "imagemap": an image file, laid over a surface by a mapping. (s, t) = (0, 0) is its lower left corner.
//
// | name          | type   | unit | default    | meaning                                                              |
// |---------------|--------|------|------------|----------------------------------------------------------------------|
// | filename      | string |      |            | the image: EXR, PNG, JPEG, TIFF, HDR, TGA, PFM and others            |
// | filter        | string |      | bilinear   | "point", "bilinear", "trilinear", "ewa": how it is averaged over what a pixel sees |
// | maxanisotropy | float  | 1    | 8          | how many times longer than wide "ewa" sees a pixel                   |
// | wrap          | string |      | repeat     | beyond the edges: "repeat", "black", "clamp"                         |
// | encoding      | string |      | sRGB       | of files with whole numbers, unless they say that they are linear: "sRGB", "linear", "gamma 2.2"; floats are linear |
// | scale         | float  | 1    | 1          | factor of the values                                                 |
// | invert        | bool   |      | false      | 1 less the scaled values, at least 0                                 |
//
// A float texture takes the mean of red, green and blue, or alpha if a coloured image has one that is not 1 everywhere; alpha is
// never encoded. A spectrum texture leaves alpha alone; reflectances are clamped to [0, 1].
#pragma once

#include "spectrum/colorspace.h"
#include "textures/image_filter.h"
#include "textures/mapping.h"
#include "textures/spectrum_use.h"

namespace vitrine {

/// What float and spectrum image textures have in common.
struct ImageTextureInput {
    std::shared_ptr<const CachedImage> image;
    MappingPtr mapping;
    ImageSampling sampling;
    float scale = 1;
    bool invert = false;
};

class FloatImageTexture final : public FloatTexture {
  public:
    /// \param channel of the image
    FloatImageTexture(ImageTextureInput input, int channel) : input_(std::move(input)), channel_(channel) {}
    float evaluate(const TexturePoint& at) const override;
    bool isFiltered() const override { return input_.image->levels() > 1; }

  private:
    ImageTextureInput input_;
    int channel_;
};

class SpectrumImageTexture final : public SpectrumTexture {
  public:
    /// \pre the image has one channel or three
    SpectrumImageTexture(ImageTextureInput input, const RgbColorSpace& colorSpace, SpectrumUse use)
        : input_(std::move(input)), colorSpace_(&colorSpace), use_(use) {}
    SampledSpectrum evaluate(const TexturePoint& at, const SampledWavelengths& lambda) const override;
    bool isFiltered() const override { return input_.image->levels() > 1; }

  private:
    ImageTextureInput input_;
    const RgbColorSpace* colorSpace_;
    SpectrumUse use_;
};

} // namespace vitrine
