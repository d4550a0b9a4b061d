// Relief that a surface does not have but is shaded as if it had.
#pragma once

#include "shapes/shape.h"
#include "textures/texture.h"

namespace vitrine {

/// What light is scattered by at a point.
struct ShadingDirections {
    V3f n;       ///< unit, in ng's hemisphere
    V3f tangent; ///< where a BSDF's s axis lies along as far as it can
};

class SurfaceDetail {
  public:
    virtual ~SurfaceDetail() = default;
    /// \param at where `point` is, with the pixel's footprint if any is known
    virtual ShadingDirections shade(const SurfacePoint& point, const TexturePoint& at) const = 0;
    /// Whether the footprint makes a difference.
    virtual bool isFiltered() const = 0;
};

using SurfaceDetailPtr = std::shared_ptr<const SurfaceDetail>;

/// The unit vector nearest to n from which the outside is seen: what is tilted beyond the surface's horizon comes back to
/// just above it. (pbrt-v4 turns it round, which makes hills of holes.)
V3f aboveHorizon(const V3d& n, const V3f& ng);

} // namespace vitrine
