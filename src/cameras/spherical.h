// Camera "spherical".
#pragma once

#include "cameras/camera.h"
#include "cameras/camera_space.h"

namespace vitrine {

/// Camera "spherical": sees all directions from one point. Camera space's y is up.
///
/// | name    | type   | unit | default     | meaning |
/// |---------|--------|------|-------------|---------|
/// | mapping | string |      | "equalarea" | "equalarea": the octahedral map of Clarberg 2008, y in the picture's middle; "equirectangular": longitude across from +x over +z, latitude down from +y |
class SphericalCamera final : public Camera {
  public:
    enum class Mapping { EqualArea, Equirectangular };

    /// \throws std::invalid_argument for an empty resolution
    SphericalCamera(const Motion& worldFromCamera, const V2i& resolution, Mapping mapping);

    std::optional<CameraRay> generate(const CameraSample& sample) const override;
    /// The position has density 1; the importance has no cosine, as a point has no normal.
    Density density(const Ray& ray) const override;
    /// All points are in the picture: the margin is that of repeated().
    std::optional<CameraConnection> connect(const V3d& p, const V2f& u, const V2f& margin = V2f(0),
                                            double time = 0) const override;
    std::vector<V2d> repeated(const V2d& raster, const V2f& margin) const override;
    V3d position() const override { return space_.start().pointToWorld(V3d(0, 0, 0)); }
    bool moves() const override { return space_.moves(); }

  private:
    /// Unit camera direction of a point of the unit square and back; z is up here as in the maps' papers.
    V3d directionFromSquare(const V2d& uv) const;
    V2d squareFromDirection(const V3d& d) const;
    /// Solid angle per area of the unit square.
    double solidAngleOfSquare(const V3d& d) const;

    CameraMotion space_;
    V2d resolution_;
    Mapping mapping_;
};

} // namespace vitrine
