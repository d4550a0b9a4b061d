// The thin lens: what perspective cameras, and orthographic ones with a lens, have in common.
#pragma once

#include "cameras/camera.h"
#include "cameras/camera_space.h"
#include "cameras/raster_window.h"

namespace vitrine {

/// A lens in the plane z = 0 of camera space, of radius zero for a pinhole. Rays run from a uniform point of the lens
/// to the point of the plane of focus that a pinhole would see (Potmesil & Chakravarty 1981; Kolb et al. 1995).
///
/// Density of a direction, for each point of the lens: with A the picture's area in the plane z = 1, the plane of focus
/// z = f is covered uniformly with density 1 / (A f^2), at distance f / cos: 1 / (A cos^3) per solid angle. The
/// importance is that density times the lens's, over cos, so that every ray has weight one (Veach 1997, 8.3; PBRT
/// 4ed, 5.4.1).
class ThinLens {
  public:
    /// \param unitWindow the picture in the plane z = 1 of camera space
    /// \throws std::invalid_argument for a radius that is negative or not finite, and for a distance that is not
    ///         positive and finite if the radius is not zero
    ThinLens(const CameraSpace& space, const RasterWindow& unitWindow, double lensRadius, double focalDistance);

    CameraRay generate(const CameraSample& sample) const;
    /// \param margin pixels around the picture that count as well
    Camera::Density density(const Ray& ray, const V2f& margin = V2f(0)) const;
    std::optional<CameraConnection> connect(const V3d& p, const V2f& u, const V2f& margin) const;
    V3d position() const { return space_.pointToWorld(V3d(0, 0, 0)); }

  private:
    V3d lensPoint(const V2f& u) const;

    CameraSpace space_;
    RasterWindow window_;
    double lensRadius_, focalDistance_;
    double lensArea_; ///< in the world; 1 for a pinhole, as densities over a point are counted
};

/// \throws std::invalid_argument as ThinLens does
void checkLens(double lensRadius, double focalDistance);

} // namespace vitrine
