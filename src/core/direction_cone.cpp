#include "core/direction_cone.h"

namespace vitrine {

namespace {

/// By so much (radians) a united cone is wider than it must be.
constexpr double slack = 1e-9;

} // namespace

DirectionCone unite(const DirectionCone& a, const DirectionCone& b) {
    if (a.cosAngle > b.cosAngle) return unite(b, a);
    if (a.isAll()) return a;
    const V3d across = a.axis.cross(b.axis);
    const double between = std::atan2(across.length(), a.axis.dot(b.axis));
    const double angleA = std::acos(std::min(a.cosAngle, 1.)), angleB = std::acos(std::min(b.cosAngle, 1.));
    if (between + angleB <= angleA) return a;
    const double angle = (angleA + between + angleB) / 2 + slack;
    // Opposite axes leave the side to turn to open: then all directions do.
    if (!(angle < piD) || !(across.length2() > 0)) return between > 1 ? DirectionCone() : a;
    // Towards b's axis, in the plane of both.
    const V3d side = across.normalized().cross(a.axis);
    const double turn = angle - angleA;
    return {(a.axis * std::cos(turn) + side * std::sin(turn)).normalized(), std::cos(angle)};
}

} // namespace vitrine
