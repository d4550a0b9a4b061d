// Texture "wrinkled" (float): creases: the sum of octaves of the absolute value of noise.
//
// | name      | type    | unit | default | meaning                                                   |
// |-----------|---------|------|---------|-----------------------------------------------------------|
// | octaves   | integer |      | 8       | how many, each 1.99 times as fine as the one before; at most 100 |
// | roughness | float   | 1    | 0.5     | amplitude of an octave, against the one before            |
//
// What is too fine for a pixel becomes its mean.
#pragma once

#include "textures/noise.h"

namespace vitrine {

class WrinkledTexture final : public FloatTexture {
  public:
    WrinkledTexture(const TextureSpace& space, const Octaves& octaves) : space_(space), octaves_(octaves) {}
    float evaluate(const TexturePoint& at) const override { return turbulence(space_.map(at), octaves_); }
    bool isFiltered() const override { return true; }

  private:
    TextureSpace space_;
    Octaves octaves_;
};

} // namespace vitrine
