// Texture "dots": round dots, in about half of the unit squares around whole numbers (s, t), each shifted at random.
//
// | name            | type                 | unit | default | meaning                             |
// |-----------------|----------------------|------|---------|-------------------------------------|
// | inside, outside | texture or its value | 1    | 1, 0    | float or spectrum, in a dot and beside |
//
// A dot's radius is 0.35. The footprint of a pixel does not matter: dots have hard edges at any distance, as in pbrt-v4.
#pragma once

#include "textures/mapping.h"

namespace vitrine {

/// 1 in a dot, else 0. Patterns are pbrt-v4's.
class DotsWeight final : public FloatTexture {
  public:
    explicit DotsWeight(MappingPtr mapping) : mapping_(std::move(mapping)) {}
    float evaluate(const TexturePoint& at) const override;

  private:
    MappingPtr mapping_;
};

} // namespace vitrine
