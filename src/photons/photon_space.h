// Where single precision is enough.
#pragma once

#include "lights/scene_sphere.h"
#include "paths/world.h"

namespace vitrine {

/// World space less the middle of the scene: photons and disks are kept in single precision, and a scene may lie far
/// from the origin.
class PhotonSpace {
  public:
    explicit PhotonSpace(const World& world) : scene_(SceneSphere::around(world.caster->bounds())) {}

    V3f fromWorld(const V3d& p) const { return toFloat(p - scene_.center); }
    V3d toWorld(const V3f& p) const { return toDouble(p) + scene_.center; }
    /// Of the sphere round everything bounded; 0 when nothing is.
    double sceneRadius() const { return scene_.radius; }

  private:
    SceneSphere scene_;
};

} // namespace vitrine
