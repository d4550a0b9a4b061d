// Normals from an image.
#pragma once

#include "textures/image_cache.h"
#include "textures/surface_detail.h"

namespace vitrine {

/// Red, green and blue from 0 to 1 are the coordinates from -1 to 1 of a normal in a frame with x along dpdu and z along
/// the shading normal, so y along dpdv up to its sign; bilinear, repeated, (u, v) = (0, 0) the image's lower left corner,
/// as in pbrt-v4.
class NormalMap final : public SurfaceDetail {
  public:
    /// \pre three channels
    explicit NormalMap(std::shared_ptr<const CachedImage> image) : image_(std::move(image)) {}
    ShadingDirections shade(const SurfacePoint& point, const TexturePoint& at) const override;
    bool isFiltered() const override { return false; }

  private:
    std::shared_ptr<const CachedImage> image_;
};

} // namespace vitrine
