// Texture "marble" (spectrum): grey stone with dark veins across y.
//
// | name      | type    | unit     | default | meaning                                                   |
// |-----------|---------|----------|---------|-----------------------------------------------------------|
// | scale     | float   | 1/length | 1       | of the texture's space, before anything else: 2 halves the distance of the veins |
// | variation | float   | 1        | 0.2     | how far noise shifts the veins                            |
// | octaves   | integer |          | 8       | of the noise, each 1.99 times as fine as the one before; at most 100 |
// | roughness | float   | 1        | 0.5     | amplitude of an octave, against the one before            |
//
// Its colours are a reflectance (sRGB, at most 0.9) wherever it is used, as in pbrt-v4.
#pragma once

#include "textures/noise.h"

namespace vitrine {

class MarbleTexture final : public SpectrumTexture {
  public:
    MarbleTexture(const TextureSpace& space, const Octaves& octaves, float scale, float variation)
        : space_(space), octaves_(octaves), scale_(scale), variation_(variation) {}
    SampledSpectrum evaluate(const TexturePoint& at, const SampledWavelengths& lambda) const override;
    bool isFiltered() const override { return true; }

  private:
    TextureSpace space_;
    Octaves octaves_;
    float scale_, variation_;
};

} // namespace vitrine
