// Where single precision is enough.
#pragma once

#include "lights/scene_sphere.h"
#include "paths/world.h"

namespace vitrine {

/// World space less a middle: photons and disks are kept in single precision, and a scene may lie far from the origin. The
/// middle is the camera, so that what it sees is as fine as its pixels whatever else lies far away; the scene's own where the
/// camera looks at it from outside.
class PhotonSpace {
  public:
    explicit PhotonSpace(const World& world)
        : scene_(SceneSphere::around(world.caster->bounds())), middle_(scene_.center) {
        if (!world.camera) return;
        const V3d eye = world.camera->position();
        if ((eye - middle_).length() < scene_.radius) middle_ = eye;
    }

    V3f fromWorld(const V3d& p) const { return toFloat(p - middle_); }
    /// Off the surface, so that rounding does not lead to its other side.
    V3f fromWorld(const V3d& p, const V3f& side) const {
        return fromWorld(p + toDouble(side) * resolution(fromWorld(p)));
    }
    V3d toWorld(const V3f& p) const { return toDouble(p) + middle_; }
    /// Of the sphere round everything bounded; 0 when nothing is.
    double sceneRadius() const { return scene_.radius; }
    /// Bound of what single precision does to a place near p, with room for a few operations.
    double resolution(const V3f& p) const { return 0x1p-21 * maxAbs(toDouble(p)) + 0x1p-40 * scene_.radius; }

  private:
    SceneSphere scene_;
    V3d middle_;
};

} // namespace vitrine
