// Texture "constant": the same everywhere.
//
// | name  | type              | unit | default | meaning                                                 |
// |-------|-------------------|------|---------|---------------------------------------------------------|
// | value | float or spectrum | 1    | 1       | a float in a float texture, a spectrum in a spectrum one |
#pragma once

#include "textures/texture_over.h"

namespace vitrine {

template <class Input>
class ConstantTexture final : public TextureOver<ConstantTexture<Input>, Input> {
  public:
    explicit ConstantTexture(Input input) : input_(std::move(input)) {}

    template <class... Lambda>
    auto value(const TexturePoint& at, const Lambda&... lambda) const {
        return input_(at, lambda...);
    }

  private:
    Input input_;
};

} // namespace vitrine
