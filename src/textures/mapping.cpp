#include "textures/mapping.h"

#include <stdexcept>

namespace vitrine {

namespace {

/// Turns by which the angle of (x, y) changes as (x, y) moves by (dx, dy); whoever passes over the centre sees all angles.
double turnsOver(double x, double y, double dx, double dy) {
    const double r2 = sqr(x) + sqr(y);
    if (r2 == 0) return dx != 0 || dy != 0 ? 1 : 0;
    return std::clamp((x * dy - y * dx) / (2 * piD * r2), -1., 1.);
}

/// (s, t) of "spherical".
V2d spherical(const V3d& p) {
    const double phi = std::atan2(p.y, p.x) / (2 * piD);
    // What is just below 0 would round up to 1.
    return {std::atan2(std::hypot(p.x, p.y), p.z) / piD, phi < 0 ? std::min(phi + 1, 1 - 0x1p-53) : phi};
}

/// How (s, t) of "spherical" changes.
V2d sphericalStep(const V3d& p, const V3d& dp) {
    const double r = std::hypot(p.x, p.y);
    // On the axis the radius grows whatever the direction.
    const double dr = r > 0 ? (p.x * dp.x + p.y * dp.y) / r : std::hypot(dp.x, dp.y);
    return {2 * turnsOver(p.z, r, dp.z, dr), turnsOver(p.x, p.y, dp.x, dp.y)};
}

} // namespace

PlanePoint UvMapping::map(const TexturePoint& at) const {
    return {V2d(at.uv) * scale_ + delta_, V2d(at.duvdx) * scale_, V2d(at.duvdy) * scale_};
}

PlanePoint SphericalMapping::map(const TexturePoint& at) const {
    const SpacePoint point = space_.map(at);
    return {spherical(point.p), sphericalStep(point.p, point.dpdx), sphericalStep(point.p, point.dpdy)};
}

PlanePoint CylindricalMapping::map(const TexturePoint& at) const {
    const auto [p, dpdx, dpdy] = space_.map(at);
    const auto step = [&p = p](const V3d& dp) { return V2d(turnsOver(p.x, p.y, dp.x, dp.y), dp.z); };
    return {V2d(0.5 + std::atan2(p.y, p.x) / (2 * piD), p.z), step(dpdx), step(dpdy)};
}

PlanePoint PlanarMapping::map(const TexturePoint& at) const {
    const SpacePoint point = space_.map(at);
    return {project(point.p) + delta_, project(point.dpdx), project(point.dpdy)};
}

AxisMapping::AxisMapping(const TextureSpace& space, const V3d& axis, double period, double offset) : space_(space) {
    if (axis.length() == 0) throw std::invalid_argument("\"axis\" must not be the zero vector");
    if (period == 0) throw std::invalid_argument("\"period\" must not be 0");
    axis_ = axis.normalized() / period;
    s0_ = -offset / period;
}

PlanePoint AxisMapping::map(const TexturePoint& at) const {
    const SpacePoint point = space_.map(at);
    return {V2d(s0_ + point.p.dot(axis_), 0.5), V2d(point.dpdx.dot(axis_), 0), V2d(point.dpdy.dot(axis_), 0)};
}

} // namespace vitrine
