// A ray as a surface of revolution about the y axis sees it.
//
// With l the length along the ray, the distance r from the axis and the height y are
//     r^2 = e^2 + g^2,   g = q + h l,   y = y_o + v l,
// a branch of a hyperbola in the half-plane (r, y), run through once; h and v are the horizontal and vertical part of
// the unit direction, e the distance of the ray from the axis, q the way from the closest approach to the origin.
// Eliminating l without dividing, with  P(y) = h (y - y_o) + v q = v g,  a profile point (x, y) lies on the ray when
//     F(x, y) = P(y)^2 - v^2 (x^2 - e^2) = 0,
// positive outside the hyperbola's convex side (between ray and axis), and, for either sign of g, when
//     G(x, y) = P(y) -+ v sqrt(x^2 - e^2) = 0.
// F is one polynomial in the profile's parameter; it keeps its digits unless v is small. Then G does: at v = 0 the two
// are y(t) = y_o, twice. Neither divides by v or h, so horizontal and vertical rays are no special cases.
#pragma once

#include "core/ray.h"

namespace vitrine {

struct AxialRay {
    double h = 0, v = 1; ///< h >= 0, h^2 + v^2 = 1
    double e = 0;        ///< >= 0
    double q = 0;
    double oy = 0;
    double vq = 0;                         ///< v q
    double inverseV = 1;                   ///< 1 / v, at most 1e150 in magnitude
    double length = 0;                     ///< of the ray's direction: s = l / length
    double ox = 0, oz = 0, dx = 0, dz = 0; ///< horizontal origin and horizontal part of the unit direction
    double reach = 0;                      ///< largest coordinate of the origin: what rounding is measured by

    /// Empty for directions or origins that are zero (the direction), NaN, infinite, or beyond 1e150.
    explicit AxialRay(const Ray& objectRay);

    bool valid() const { return length > 0; }
    /// Below this slope F loses too many digits (v^2 of them) and the branches are solved apart.
    bool isShallow() const { return std::abs(v) < 0.01; }

    double P(double y) const { return h * (y - oy) + vq; }
    double halfWidth(double x) const { return safeSqrt((x - e) * (x + e)); }
    double F(double x, double p) const { return p * p - (v * v) * ((x - e) * (x + e)); }
};

} // namespace vitrine
