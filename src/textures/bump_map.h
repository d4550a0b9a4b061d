// Bump mapping by a displacement along the normal.
#pragma once

#include "textures/surface_detail.h"

namespace vitrine {

/// The normals of the surface moved outwards along its normals by a displacement in world units (Blinn 1978, "Simulation
/// of wrinkled surfaces"). Derivatives of the displacement are differences over half of what a pixel sees, or over 0.0005
/// of u and v, as in pbrt-v4; but central ones, so that the relief stays in its place and is next to the same for photons,
/// which know no pixel.
class BumpMap final : public SurfaceDetail {
  public:
    explicit BumpMap(FloatTexturePtr displacement) : displacement_(std::move(displacement)) {}
    ShadingDirections shade(const SurfacePoint& point, const TexturePoint& at) const override;
    bool isFiltered() const override { return true; }

  private:
    float slope(const SurfacePoint& point, const TexturePoint& at, int axis, float& heights) const;

    FloatTexturePtr displacement_;
};

} // namespace vitrine
