// Texture "fbm" (float): clouds: the sum of octaves of noise.
//
// | name      | type    | unit | default | meaning                                                   |
// |-----------|---------|------|---------|-----------------------------------------------------------|
// | octaves   | integer |      | 8       | how many, each 1.99 times as fine as the one before; at most 100 |
// | roughness | float   | 1    | 0.5     | amplitude of an octave, against the one before            |
//
// The coarsest octave changes within one unit of the texture's space. What is too fine for a pixel fades out.
#pragma once

#include "textures/noise.h"

namespace vitrine {

class FbmTexture final : public FloatTexture {
  public:
    FbmTexture(const TextureSpace& space, const Octaves& octaves) : space_(space), octaves_(octaves) {}
    float evaluate(const TexturePoint& at) const override { return fbm(space_.map(at), octaves_); }
    bool isFiltered() const override { return true; }

  private:
    TextureSpace space_;
    Octaves octaves_;
};

} // namespace vitrine
