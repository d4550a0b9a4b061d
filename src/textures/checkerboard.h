// Texture "checkerboard": squares of the (s, t) plane, or cubes of the texture's space, by turns.
//
// | name       | type                 | unit | default | meaning                                             |
// |------------|----------------------|------|---------|-----------------------------------------------------|
// | tex1, tex2 | texture or its value | 1    | 1, 0    | float or spectrum; `tex1` has the square [0,1) x [0,1) |
// | dimension  | integer              |      | 2       | 2: squares of a mapping; 3: cubes, without a mapping |
//
// Side 1. Seen from afar the two become their mean: the pattern is filtered by a triangle in each coordinate.
#pragma once

#include "textures/mapping.h"

namespace vitrine {

/// The share of the second texture in a 2D checkerboard.
class SquaresWeight final : public FloatTexture {
  public:
    explicit SquaresWeight(MappingPtr mapping) : mapping_(std::move(mapping)) {}
    float evaluate(const TexturePoint& at) const override;
    bool isFiltered() const override { return true; }

  private:
    MappingPtr mapping_;
};

/// The share of the second texture in a 3D checkerboard.
class CubesWeight final : public FloatTexture {
  public:
    explicit CubesWeight(const TextureSpace& space) : space_(space) {}
    float evaluate(const TexturePoint& at) const override;
    bool isFiltered() const override { return true; }

  private:
    TextureSpace space_;
};

} // namespace vitrine
