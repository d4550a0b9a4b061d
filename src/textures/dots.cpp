#include "textures/dots.h"

#include "textures/noise.h"

namespace vitrine {

namespace {

constexpr double radius = 0.35, farthestShift = 0.5 - radius;

/// Noise at a place of its own for each use; the offsets are pbrt-v4's.
double noiseOfCell(const V2d& cell, double ds, double dt) {
    return noise(V3d(cell.x + ds, cell.y + dt, 0.5));
}

} // namespace

float DotsWeight::evaluate(const TexturePoint& at) const {
    const V2d st = mapping_->map(at).st;
    const V2d cell(std::floor(st.x + 0.5), std::floor(st.y + 0.5));
    if (noiseOfCell(cell, 0.5, 0.5) <= 0) return 0;
    const V2d centre = cell + V2d(noiseOfCell(cell, 1.5, 2.8), noiseOfCell(cell, 4.5, 9.8)) * farthestShift;
    return (st - centre).length2() < sqr(radius) ? 1 : 0;
}

} // namespace vitrine
