// Texture "mix": goes from one texture to another.
//
// | name       | type                 | unit | default | meaning                                        |
// |------------|----------------------|------|---------|------------------------------------------------|
// | tex1, tex2 | texture or its value | 1    | 0, 1    | float or spectrum, as the texture is           |
// | amount     | float or texture     | 1    | 0.5     | share of `tex2`; the value is (1 - amount) tex1 + amount tex2 |
#pragma once

#include "textures/texture_over.h"

namespace vitrine {

/// (1 - w) first + w second. All textures that choose between two others are this one: they differ in w.
template <class Input>
class MixTexture final : public TextureOver<MixTexture<Input>, Input> {
  public:
    MixTexture(Input first, Input second, FloatInput weight)
        : first_(std::move(first)), second_(std::move(second)), weight_(std::move(weight)) {}

    template <class... Lambda>
    auto value(const TexturePoint& at, const Lambda&... lambda) const {
        const float w = weight_(at);
        if (w == 0) return first_(at, lambda...);
        if (w == 1) return second_(at, lambda...);
        return (1 - w) * first_(at, lambda...) + w * second_(at, lambda...);
    }
    bool isFiltered() const override { return first_.isFiltered() || second_.isFiltered() || weight_.isFiltered(); }

  private:
    Input first_, second_;
    FloatInput weight_;
};

} // namespace vitrine
