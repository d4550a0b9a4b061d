// Camera space in the world, and what the map between them does to densities.
#pragma once

#include "core/motion.h"

#include <optional>

namespace vitrine {

/// Where a camera stands. Any invertible affine map is allowed, mirrored and stretched ones too: densities carry the
/// Jacobians, so that generate, density and connect agree in world measure.
class CameraSpace {
  public:
    explicit CameraSpace(const Transform& worldFromCamera);

    /// The ray in the world with unit direction; a ray of infinite length stays one.
    Ray toWorld(const V3d& o, const V3d& d, double time = 0) const;
    V3d pointToWorld(const V3d& p) const { return worldFromCamera_.point(p); }
    V3d pointToCamera(const V3d& p) const { return cameraFromWorld_.point(p); }
    /// Unit direction in camera space of a direction of the world.
    V3d directionToCamera(const V3d& d) const { return cameraFromWorld_.vector(d).normalized(); }

    /// Camera solid angle per world solid angle about the unit camera direction d: |L d|^3 / |det L| with L the linear
    /// part (the solid angle dA cos / r^2 of an area that L moves).
    double solidAngleRatio(const V3d& d) const;
    /// World area per camera area of the plane z = 0 (lens or film).
    double planeArea() const { return planeArea_; }
    /// Cosine in the world between the unit world direction and the normal of that plane.
    double cosine(const V3d& worldDirection) const { return std::abs(worldDirection.dot(normal_)); }

  private:
    Transform worldFromCamera_, cameraFromWorld_;
    double determinant_, planeArea_;
    V3d normal_;
};

/// Where a camera stands at each time.
class CameraMotion {
  public:
    CameraMotion(const Motion& worldFromCamera) : motion_(worldFromCamera), start_(worldFromCamera.start()) {}

    bool moves() const { return motion_.moves(); }
    const CameraSpace& start() const { return start_; }
    /// \param room for the answer where it has to be made
    const CameraSpace& at(double time, std::optional<CameraSpace>& room) const {
        return moves() ? room.emplace(motion_.at(time)) : start_;
    }

  private:
    Motion motion_;
    CameraSpace start_;
};

} // namespace vitrine
