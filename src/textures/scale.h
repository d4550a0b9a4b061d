// Texture "scale": the product of a texture and a number.
//
// | name  | type              | unit | default | meaning                                 |
// |-------|-------------------|------|---------|-----------------------------------------|
// | tex   | texture or its value | 1 | 1       | float or spectrum, as the texture is     |
// | scale | float or texture  | 1    | 1       | factor; where it is 0, `tex` is not asked |
#pragma once

#include "textures/texture_over.h"

namespace vitrine {

template <class Input>
class ScaleTexture final : public TextureOver<ScaleTexture<Input>, Input> {
  public:
    ScaleTexture(Input input, FloatInput scale) : input_(std::move(input)), scale_(std::move(scale)) {}

    template <class... Lambda>
    auto value(const TexturePoint& at, const Lambda&... lambda) const {
        using Value = decltype(input_(at, lambda...));
        const float scale = scale_(at);
        return scale == 0 ? Value(0.f) : input_(at, lambda...) * scale;
    }
    bool isFiltered() const override { return input_.isFiltered() || scale_.isFiltered(); }

  private:
    Input input_;
    FloatInput scale_;
};

} // namespace vitrine
