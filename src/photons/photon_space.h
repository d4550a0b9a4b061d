// Where single precision is enough.
#pragma once

#include "paths/world.h"

namespace vitrine {

/// World space less the middle of the scene: photons and disks are kept in single precision, and a scene may lie far
/// from the origin.
class PhotonSpace {
  public:
    explicit PhotonSpace(const World& world) {
        const Box3d bounds = world.caster->bounds();
        if (bounds.isEmpty()) return;
        middle_ = bounds.center();
        radius_ = bounds.size().length() / 2;
    }

    V3f fromWorld(const V3d& p) const { return toFloat(p - middle_); }
    V3d toWorld(const V3f& p) const { return toDouble(p) + middle_; }
    /// Of the sphere round everything bounded; 0 when nothing is.
    double sceneRadius() const { return radius_; }

  private:
    V3d middle_{0, 0, 0};
    double radius_ = 0;
};

} // namespace vitrine
