// Texture "directionmix": goes from one texture to another with the slope of the surface.
//
// | name       | type                 | unit | default | meaning                                                |
// |------------|----------------------|------|---------|--------------------------------------------------------|
// | tex1, tex2 | texture or its value | 1    | 0, 1    | float or spectrum: `tex1` where the surface faces along or against `dir`, `tex2` where it is parallel to it |
// | dir        | vector3              |      | (0,1,0) | direction in the texture's space                       |
#pragma once

#include "core/transform.h"
#include "textures/texture.h"

#include <stdexcept>

namespace vitrine {

/// The share of the second texture: 1 - |cos| of the angle between surface normal and direction.
class DirectionWeight final : public FloatTexture {
  public:
    /// \throws std::invalid_argument for no direction
    DirectionWeight(const Transform& worldFromTexture, const V3d& direction) {
        const V3d world = worldFromTexture.vector(direction);
        if (world.length() == 0) throw std::invalid_argument("\"dir\" must not be the zero vector");
        direction_ = toFloat(world.normalized());
    }
    float evaluate(const TexturePoint& at) const override { return 1 - std::min(absDot(at.ng, direction_), 1.f); }

  private:
    V3f direction_;
};

} // namespace vitrine
