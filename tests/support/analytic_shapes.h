// The analytic shapes of size about 1 with their surfaces written down a second time, in long double and straight from
// the definition: the oracle of the tests of src/shapes.
#pragma once

#include "core/random.h"
#include "shapes/box.h"
#include "shapes/cylinder.h"
#include "shapes/disk.h"
#include "shapes/plane.h"
#include "shapes/sphere.h"

#include <functional>
#include <string>
#include <vector>

namespace vitrine::test {

using Real = long double;
using Vec = Imath::Vec3<Real>;

/// Where a line crosses the surface that a shape is part of.
struct Crossing {
    Real s;
    Real margin; ///< distance from the shape's edges in object space; positive on the shape, negative beside it
};

struct LineCrossings {
    std::vector<Crossing> all; ///< in order of s
    Real tangency = 1;         ///< how far the line is from touching or running along the surface: 0 it does
};

struct AnalyticShape {
    std::string name;
    /// Whether a mirroring placement turns the normals round: so it is with pbrt's shapes, not with ours.
    bool mirrorsInsideOut = true;
    std::function<ShapePtr(const Transform&, bool reverse)> make;
    std::function<LineCrossings(const Vec& o, const Vec& d)> cross;
    /// The point of parameters (u, v) in object space; not for the box.
    std::function<V3d(double u, double v)> pointOf;
    /// Signed distance from the surface in object space, positive outside (on the side of +z for flat shapes).
    std::function<Real(const Vec& p)> distance;
    bool isFlat = false;
    bool isConvexSolid = false; ///< a ray that goes in comes out
};

namespace analytic {

inline constexpr double partialRadius = 0.9, zLow = -0.4, zHigh = 0.6, phiMaxDegrees = 250, ringInner = 0.3;

inline Real minimum(std::initializer_list<Real> values) {
    return std::min(values);
}

/// Distance along the circle from the ends of the sector [0, phiMaxDegrees].
inline Real sectorMargin(const Vec& p) {
    const Real end = Real(phiMaxDegrees) * acosl(-1) / 180, turn = 2 * acosl(-1);
    Real phi = atan2l(p.y, p.x);
    if (phi < 0) phi += turn;
    const Real radius = sqrtl(p.x * p.x + p.y * p.y);
    if (phi <= end) return radius * std::min(phi, end - phi);
    return -radius * std::min(phi - end, turn - phi);
}

/// Roots of a s^2 + 2 b s + c; `tangency` from the distance of the line from the centre.
inline LineCrossings quadric(const Vec& o, const Vec& d, const Vec& axes, Real radius,
                             const std::function<Real(const Vec&)>& margin) {
    const Vec oo(o.x * axes.x, o.y * axes.y, o.z * axes.z), dd(d.x * axes.x, d.y * axes.y, d.z * axes.z);
    LineCrossings result;
    const Real a = dd.dot(dd);
    if (a == 0) return result;
    const Real h = -oo.dot(dd) / a;
    const Vec closest = oo + dd * h;
    const Real distance2 = closest.dot(closest);
    result.tangency = 1 - sqrtl(distance2) / radius;
    if (result.tangency < 0) return result;
    const Real half = sqrtl((radius * radius - distance2) / a);
    for (const Real s : {h - half, h + half})
        result.all.push_back({s, margin(o + d * s)});
    return result;
}

inline LineCrossings flat(const Vec& o, const Vec& d, Real z, const std::function<Real(const Vec&)>& margin) {
    LineCrossings result;
    if (d.z == 0) return result;
    result.tangency = fabsl(d.z) / sqrtl(d.dot(d));
    const Real s = (z - o.z) / d.z;
    result.all.push_back({s, margin(o + d * s)});
    return result;
}

inline AnalyticShape sphere() {
    AnalyticShape shape;
    shape.name = "sphere";
    shape.make = [](const Transform& t, bool r) { return std::make_shared<Sphere>(t, r, 1., -1., 1., 360.); };
    shape.cross = [](const Vec& o, const Vec& d) {
        return quadric(o, d, Vec(1, 1, 1), 1, [](const Vec&) { return Real(1); });
    };
    shape.pointOf = [](double u, double v) {
        const double theta = piD * (1 - v), phi = 2 * piD * u;
        return V3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    };
    shape.distance = [](const Vec& p) { return sqrtl(p.dot(p)) - 1; };
    shape.isConvexSolid = true;
    return shape;
}

inline AnalyticShape partialSphere() {
    AnalyticShape shape;
    shape.name = "partial sphere";
    shape.make = [](const Transform& t, bool r) {
        return std::make_shared<Sphere>(t, r, partialRadius, zLow, zHigh, phiMaxDegrees);
    };
    shape.cross = [](const Vec& o, const Vec& d) {
        return quadric(o, d, Vec(1, 1, 1), partialRadius, [](const Vec& p) {
            return minimum({p.z - Real(zLow), Real(zHigh) - p.z, sectorMargin(p)});
        });
    };
    shape.pointOf = [](double u, double v) {
        const double theta = lerp(v, std::acos(zLow / partialRadius), std::acos(zHigh / partialRadius));
        const double phi = radians(phiMaxDegrees) * u;
        return V3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)) * partialRadius;
    };
    shape.distance = [](const Vec& p) { return sqrtl(p.dot(p)) - Real(partialRadius); };
    return shape;
}

inline AnalyticShape disk() {
    AnalyticShape shape;
    shape.name = "disk";
    shape.make = [](const Transform& t, bool r) { return std::make_shared<Disk>(t, r, 0.25, 1., 0., 360.); };
    shape.cross = [](const Vec& o, const Vec& d) {
        return flat(o, d, 0.25, [](const Vec& p) { return 1 - sqrtl(p.x * p.x + p.y * p.y); });
    };
    shape.pointOf = [](double u, double v) {
        return V3d(std::cos(2 * piD * u) * (1 - v), std::sin(2 * piD * u) * (1 - v), 0.25);
    };
    shape.distance = [](const Vec& p) { return p.z - Real(0.25); };
    shape.isFlat = true;
    return shape;
}

inline AnalyticShape ring() {
    AnalyticShape shape;
    shape.name = "ring sector";
    shape.make = [](const Transform& t, bool r) {
        return std::make_shared<Disk>(t, r, 0., 1., ringInner, phiMaxDegrees);
    };
    shape.cross = [](const Vec& o, const Vec& d) {
        return flat(o, d, 0, [](const Vec& p) {
            const Real r = sqrtl(p.x * p.x + p.y * p.y);
            return minimum({1 - r, r - Real(ringInner), sectorMargin(p)});
        });
    };
    shape.pointOf = [](double u, double v) {
        const double r = lerp(v, 1., ringInner), phi = radians(phiMaxDegrees) * u;
        return V3d(std::cos(phi) * r, std::sin(phi) * r, 0);
    };
    shape.distance = [](const Vec& p) { return p.z; };
    shape.isFlat = true;
    return shape;
}

inline AnalyticShape cylinder(bool partial) {
    const double radius = partial ? partialRadius : 1., low = partial ? zLow : -1., high = partial ? zHigh : 1.;
    const double phiMax = partial ? phiMaxDegrees : 360;
    AnalyticShape shape;
    shape.name = partial ? "partial cylinder" : "cylinder";
    shape.make = [=](const Transform& t, bool r) {
        return std::make_shared<Cylinder>(t, r, radius, low, high, phiMax);
    };
    shape.cross = [=](const Vec& o, const Vec& d) {
        return quadric(o, d, Vec(1, 1, 0), radius, [=](const Vec& p) {
            const Real ends = std::min(p.z - Real(low), Real(high) - p.z);
            return partial ? std::min(ends, sectorMargin(p)) : ends;
        });
    };
    shape.pointOf = [=](double u, double v) {
        return V3d(radius * std::cos(radians(phiMax) * u), radius * std::sin(radians(phiMax) * u), lerp(v, low, high));
    };
    shape.distance = [=](const Vec& p) { return sqrtl(p.x * p.x + p.y * p.y) - Real(radius); };
    return shape;
}

inline constexpr double boxLow[] = {-0.5, -0.7, -0.3}, boxHigh[] = {0.6, 0.4, 0.9};

inline AnalyticShape box() {
    AnalyticShape shape;
    shape.name = "box";
    shape.mirrorsInsideOut = false;
    shape.make = [](const Transform& t, bool r) {
        return std::make_shared<Box>(t, r, V3d(boxLow[0], boxLow[1], boxLow[2]),
                                     V3d(boxHigh[0], boxHigh[1], boxHigh[2]));
    };
    shape.cross = [](const Vec& o, const Vec& d) {
        LineCrossings result;
        for (int axis = 0; axis < 3; ++axis)
            for (const Real side : {Real(boxLow[axis]), Real(boxHigh[axis])}) {
                if (d[axis] == 0) continue;
                const Real s = (side - o[axis]) / d[axis];
                const Vec p = o + d * s;
                const int i = (axis + 1) % 3, j = (axis + 2) % 3;
                result.all.push_back({s, minimum({p[i] - Real(boxLow[i]), Real(boxHigh[i]) - p[i],
                                                  p[j] - Real(boxLow[j]), Real(boxHigh[j]) - p[j]})});
            }
        std::sort(result.all.begin(), result.all.end(), [](const auto& a, const auto& b) { return a.s < b.s; });
        return result;
    };
    // Near a face; what is farther away than the nearest edge is of no concern here.
    shape.distance = [](const Vec& p) {
        Real result = -10;
        for (int axis = 0; axis < 3; ++axis)
            result = std::max({result, p[axis] - Real(boxHigh[axis]), Real(boxLow[axis]) - p[axis]});
        return result;
    };
    shape.isConvexSolid = true;
    return shape;
}

inline AnalyticShape plane() {
    AnalyticShape shape;
    shape.name = "plane";
    shape.make = [](const Transform& t, bool r) { return std::make_shared<Plane>(t, r, V3d(0, 0, 2), 0.5); };
    shape.cross = [](const Vec& o, const Vec& d) { return flat(o, d, 0.25, [](const Vec&) { return Real(1); }); };
    shape.pointOf = [](double u, double v) { return V3d(u, v, 0.25); };
    shape.distance = [](const Vec& p) { return p.z - Real(0.25); };
    shape.isFlat = true;
    return shape;
}

} // namespace analytic

/// Full and partial sphere, disk, ring, full and partial cylinder, box.
inline std::vector<AnalyticShape> boundedAnalyticShapes() {
    using namespace analytic;
    return {sphere(), partialSphere(), disk(), ring(), cylinder(false), cylinder(true), box()};
}

/// These and the plane.
inline std::vector<AnalyticShape> allAnalyticShapes() {
    std::vector<AnalyticShape> shapes = boundedAnalyticShapes();
    shapes.push_back(analytic::plane());
    return shapes;
}

/// A rotation about no particular axis.
inline M44d tiltedRotation() {
    M44d rotation;
    rotation.setEulerAngles(V3d(0.4, -1.1, 2.3));
    return rotation;
}

struct NamedTransform {
    std::string name;
    Transform worldFromObject;
};

/// A similarity, a mirrored one and a sheared, non-uniform map, each scaled and then moved by `distance`.
inline std::vector<NamedTransform> placements(double scale, double distance) {
    M44d scaling, mirrored, uneven, sheared, translation;
    scaling.setScale(V3d(scale, scale, scale));
    mirrored.setScale(V3d(-scale, scale, scale));
    uneven.setScale(V3d(scale, 3 * scale, 0.4 * scale));
    sheared.setShear(V3d(0.5, -0.2, 0.3));
    translation.setTranslation(V3d(0.48, -0.64, 0.6) * distance);
    const M44d rest = tiltedRotation() * translation;
    return {{"similarity", Transform(scaling * rest)},
            {"mirrored", Transform(mirrored * rest)},
            {"uneven", Transform(sheared * uneven * rest)}};
}

inline V3d randomUnit(RandomStream& rng) {
    const double z = rng.uniform(-1, 1), phi = rng.uniform(0, 2 * piD), r = std::sqrt(1 - z * z);
    return V3d(r * std::cos(phi), r * std::sin(phi), z);
}

inline Vec toLong(const V3d& v) {
    return Vec(v.x, v.y, v.z);
}

/// The line of a world ray in object space, without the rounding of double.
inline void toObject(const Transform& worldFromObject, const Ray& ray, Vec& o, Vec& d) {
    // One step of Newton's iteration makes the double inverse good to long double: X (2 I - M X).
    const M44d m = worldFromObject.matrix(), x = worldFromObject.inverse().matrix();
    Real refined[3][3] = {};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) {
                Real product = 0;
                for (int l = 0; l < 3; ++l)
                    product += Real(m[k][l]) * Real(x[l][j]);
                refined[i][j] += Real(x[i][k]) * ((k == j ? 2 : 0) - product);
            }
    const auto apply = [&](const Vec& v) {
        Vec result(0, 0, 0);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                result[j] += v[i] * refined[i][j];
        return result;
    };
    o = apply(Vec(Real(ray.o.x) - Real(m[3][0]), Real(ray.o.y) - Real(m[3][1]), Real(ray.o.z) - Real(m[3][2])));
    d = apply(toLong(ray.d));
}

} // namespace vitrine::test
