#include "textures/bump_map.h"

namespace vitrine {

/// The derivative of the displacement by u (axis 0) or v. Adds the two heights that it looks up to `heights`.
float BumpMap::slope(const SurfacePoint& point, const TexturePoint& at, int axis, float& heights) const {
    float step = (std::abs(at.duvdx[axis]) + std::abs(at.duvdy[axis])) / 2;
    if (!(step > 0)) step = 0.0005f;
    // Some units in the last place of a large u: and what rounding leaves of the step is what it counts as.
    step = std::max(step, std::abs(at.uv[axis]) * 0x1p-20f);
    const V3d tangent = toDouble(axis == 0 ? point.dpdu : point.dpdv);
    const auto beside = [&](float offset) {
        TexturePoint moved = at;
        moved.uv[axis] += offset;
        moved.p += tangent * double(moved.uv[axis] - at.uv[axis]);
        return moved;
    };
    const TexturePoint before = beside(-step / 2), behind = beside(step / 2);
    const float low = displacement_->evaluate(before), high = displacement_->evaluate(behind);
    heights += low + high;
    return (high - low) / (behind.uv[axis] - before.uv[axis]);
}

ShadingDirections BumpMap::shade(const SurfacePoint& point, const TexturePoint& at) const {
    float heights = 0;
    const float du = slope(point, at, 0, heights), dv = slope(point, at, 1, heights), here = heights / 4;
    const ShadingDirections unchanged{point.ns, point.dpdu};
    // A parallel surface has the same normals.
    if (du == 0 && dv == 0) return unchanged;
    // In double: squares of the tangents of large surfaces may overflow. An interpolated normal is the surface's own to it.
    const V3d n = toDouble(point.ns), u = toDouble(point.dpdu), v = toDouble(point.dpdv);
    const V3d bumpedU = u - n * n.dot(u) + n * double(du) + toDouble(point.dndu) * double(here);
    const V3d bumpedV = v - n * n.dot(v) + n * double(dv) + toDouble(point.dndv) * double(here);
    V3d bumped = bumpedU.cross(bumpedV);
    if (!(bumped.length2() > 0) || !isFinite(bumped)) return unchanged; // at a pole
    if (u.cross(v).dot(n) < 0) bumped = -bumped;
    return {aboveHorizon(bumped, point.ng), toFloat(bumpedU)};
}

} // namespace vitrine
