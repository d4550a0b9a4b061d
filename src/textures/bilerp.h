// Texture "bilerp": between four values at the corners of the unit square, bilinear in (s, t).
//
// | name               | type              | unit | default    | meaning                                    |
// |--------------------|-------------------|------|------------|--------------------------------------------|
// | v00, v01, v10, v11 | float or spectrum | 1    | 0, 1, 0, 1 | at (s, t) = (0,0), (0,1), (1,0), (1,1); outside the square it goes on in the same way |
#pragma once

#include "textures/mapping.h"
#include "textures/texture_over.h"

#include <array>

namespace vitrine {

template <class Input>
class BilerpTexture final : public TextureOver<BilerpTexture<Input>, Input> {
  public:
    /// \param corners constants, in the order of the table
    BilerpTexture(MappingPtr mapping, std::array<Input, 4> corners)
        : mapping_(std::move(mapping)), corners_(std::move(corners)) {}

    template <class... Lambda>
    auto value(const TexturePoint& at, const Lambda&... lambda) const {
        const V2f st(mapping_->map(at).st);
        const auto edge = [&](const Input& t0, const Input& t1) {
            return (1 - st.y) * t0(at, lambda...) + st.y * t1(at, lambda...);
        };
        return (1 - st.x) * edge(corners_[0], corners_[1]) + st.x * edge(corners_[2], corners_[3]);
    }

  private:
    MappingPtr mapping_;
    std::array<Input, 4> corners_;
};

} // namespace vitrine
