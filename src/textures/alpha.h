// The "alpha" of shapes: a number or a texture that says how much of them is there.
#pragma once

#include "accel/cutout.h"
#include "textures/texture.h"

namespace vitrine {

/// Looked up without a footprint and at the geometric normal: what is known of every point of a shape, whether a ray
/// meets it or a light draws it. Both must find the same.
class AlphaCutout final : public Cutout {
  public:
    explicit AlphaCutout(FloatInput alpha) : alpha_(std::move(alpha)) {}

    float opacity(const SurfacePoint& point) const override {
        if (alpha_.isConstant()) return alpha_.constant();
        TexturePoint at;
        at.p = point.p;
        at.ng = point.ng;
        at.uv = point.uv;
        return alpha_(at);
    }

  private:
    FloatInput alpha_;
};

} // namespace vitrine
