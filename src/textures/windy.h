// Texture "windy" (float): waves on water under gusts of wind: noise of six octaves, its height set by noise of three that is
// ten times as coarse. It has no parameters.
#pragma once

#include "textures/noise.h"

namespace vitrine {

class WindyTexture final : public FloatTexture {
  public:
    explicit WindyTexture(const TextureSpace& space) : space_(space) {}
    float evaluate(const TexturePoint& at) const override {
        const SpacePoint point = space_.map(at);
        const float wind = fbm(scaled(point, 0.1), Octaves(3, 0.5f)), waves = fbm(point, Octaves(6, 0.5f));
        return std::abs(wind) * waves;
    }
    bool isFiltered() const override { return true; }

  private:
    TextureSpace space_;
};

} // namespace vitrine
