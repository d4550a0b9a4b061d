// Where photons count for a point of a surface, and how much.
#pragma once

#include "core/vec.h"

namespace vitrine {

/// A flat disk in the surface's tangent plane. A ball would also collect what landed on the other side of a thin wall or
/// on the wall beside a floor.
struct GatherDisk {
    /// Photons count up to this part of the radius off the plane, on either side: enough for a sphere of the same radius
    /// that bulges by r^2 / 2R within it, and little of a wall that stands on the surface.
    static constexpr float thickness = 0.25f;

    V3f center;
    V3f normal; ///< unit, geometric
    float radius = 0;

    float radius2() const { return radius * radius; }
    /// Half the extents of the box round it.
    V3f halfExtents() const {
        const auto along = [this](float n) { return radius * (safeSqrt(1 - n * n) + thickness * std::abs(n)); };
        return V3f(along(normal.x), along(normal.y), along(normal.z));
    }
};

/// How photons in a disk are weighed by their distance from its centre.
enum class Kernel {
    Constant,    ///< 1 / (pi r^2)
    Epanechnikov ///< 2 (1 - d^2 / r^2) / (pi r^2) (Epanechnikov 1969; Silverman 1986, p. 76, in two dimensions)
};

/// Times pi r^2.
inline float kernelShape(Kernel kernel, float distance2, float radius2) {
    return kernel == Kernel::Constant ? 1.f : 2 * std::max(0.f, 1 - distance2 / radius2);
}

/// Distance in the plane, squared; negative when p is too far off the plane or out of the disk.
inline float distance2InDisk(const GatherDisk& disk, const V3f& p) {
    const V3f d = p - disk.center;
    const float off = d.dot(disk.normal);
    const float distance2 = d.length2() - off * off;
    const bool inside = distance2 < disk.radius2() && std::abs(off) <= GatherDisk::thickness * disk.radius;
    return inside ? std::max(0.f, distance2) : -1;
}

} // namespace vitrine
