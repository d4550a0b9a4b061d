// The thin lens: what perspective cameras, and orthographic ones with a lens, have in common.
#pragma once

#include "cameras/aperture.h"
#include "cameras/camera.h"
#include "cameras/camera_space.h"
#include "cameras/raster_window.h"

namespace vitrine {

/// A lens in the plane z = 0 of camera space, of radius zero for a pinhole. Rays run from a point of the lens, uniform or by the
/// aperture's density,
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
    ThinLens(const CameraMotion& space, const RasterWindow& unitWindow, double lensRadius, double focalDistance,
             AperturePtr aperture);

    CameraRay generate(const CameraSample& sample) const;
    /// \param margin pixels around the picture that count as well
    Camera::Density density(const Ray& ray, const V2f& margin = V2f(0)) const;
    std::optional<CameraConnection> connect(const V3d& p, const V2f& u, const V2f& margin, double time) const;
    V3d position() const { return space_.start().pointToWorld(V3d(0, 0, 0)); }
    bool moves() const { return space_.moves(); }

  private:
    /// In units of the lens radius.
    V2d lensPoint(const V2f& u) const;
    V3d inCamera(const V2d& lens) const { return V3d(lens.x, lens.y, 0) * lensRadius_; }
    /// One over the density of a lens point, per area in the world: the lens's area if it is even; 1 for a pinhole, as
    /// densities over a point are counted.
    double inverseDensity(const CameraSpace& space, const V2d& lens) const;
    Camera::Density density(const CameraSpace& space, const Ray& ray, double inverseDensity, const V2f& margin) const;

    CameraMotion space_;
    RasterWindow window_;
    double lensRadius_, focalDistance_;
    AperturePtr aperture_; ///< null: the full circle
};

/// \throws std::invalid_argument as ThinLens does
void checkLens(double lensRadius, double focalDistance);

} // namespace vitrine
