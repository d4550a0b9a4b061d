// Crossings of a line with a sphere and with a circle about the origin.
//
// Haines, Gunther & Akenine-Moller 2019, "Precision improvements for ray/sphere intersection" (Ray Tracing Gems, ch.
// 7): the discriminant comes from the distance between line and centre, so that it keeps its digits for far origins,
// and the smaller root from the quotient that does not cancel.
#pragma once

#include "core/vec.h"

namespace vitrine {

struct Crossings {
    double near, far; ///< along the ray, in order
};

/// Solves a s^2 + 2 b s + c = 0 where `discriminant` is b^2 - a c. False when there is no root, or NaN comes in. An
/// a of 0 gives roots that are infinite or NaN, so in no open interval.
inline bool solveCrossings(double a, double b, double c, double discriminant, Crossings& roots) {
    if (!(discriminant >= 0)) return false;
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    const double large = q / a, small = c / q;
    roots = q > 0 ? Crossings{small, large} : Crossings{large, small};
    return true;
}

/// Where the line o + s d crosses the sphere about the origin.
inline bool crossSphere(const V3d& o, const V3d& d, double radius2, Crossings& roots) {
    const double a = d.dot(d), b = o.dot(d), c = o.dot(o) - radius2;
    // Lagrange: |o|^2 |d|^2 - (o.d)^2 = |o x d|^2, which is a times the squared distance from the centre.
    return solveCrossings(a, b, c, radius2 * a - o.cross(d).length2(), roots);
}

/// Where the line crosses the cylinder about the z axis; none when it is parallel to the axis.
inline bool crossCylinder(const V3d& o, const V3d& d, double radius2, Crossings& roots) {
    const double a = sqr(d.x) + sqr(d.y), b = o.x * d.x + o.y * d.y, c = sqr(o.x) + sqr(o.y) - radius2;
    return solveCrossings(a, b, c, radius2 * a - sqr(differenceOfProducts(o.x, d.y, o.y, d.x)), roots);
}

} // namespace vitrine
