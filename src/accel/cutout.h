// Shapes with holes.
#pragma once

#include "shapes/shape.h"

namespace vitrine {

/// How much of a shape is there, place by place ("alpha").
class Cutout {
  public:
    virtual ~Cutout() = default;
    /// The share of rays that the surface stops at a point (world space): all from 1 on, none down from 0. Between them
    /// each ray is stopped or not, by a hash of what it is.
    virtual float opacity(const SurfacePoint& point) const = 0;
};

using CutoutPtr = std::shared_ptr<const Cutout>;

} // namespace vitrine
