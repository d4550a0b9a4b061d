#include "shapes/bilinear_patches.h"

#include "shapes/bilinear.h"
#include "shapes/placement.h"
#include "shapes/quadrature.h"

namespace vitrine {

namespace {

/// Lengths of dp/du x dp/dv at the corners, in the order 00 10 01 11: weights of the sampling density.
struct CornerWeights {
    double w[4];

    /// Density per unit of (u,v).
    double pdf(const V2d& at) const {
        const double value = (w[0] * (1 - at.x) + w[1] * at.x) * (1 - at.y) + (w[2] * (1 - at.x) + w[3] * at.x) * at.y;
        return 4 * value / (w[0] + w[1] + w[2] + w[3]);
    }
    V2d sample(const V2f& u) const {
        V2d at;
        at.y = sampleLinear(u.y, w[0] + w[1], w[2] + w[3]);
        at.x = sampleLinear(u.x, w[0] * (1 - at.y) + w[2] * at.y, w[1] * (1 - at.y) + w[3] * at.y);
        return at;
    }

  private:
    /// Inverts the distribution on [0,1] whose density goes linearly from a to b.
    static double sampleLinear(double u, double a, double b) {
        if (u == 0) return 0;
        return std::min(u * (a + b) / (a + std::sqrt((1 - u) * sqr(a) + u * sqr(b))), 1.);
    }
};

template <class Corners>
CornerWeights cornerWeights(const Corners& c) {
    return {{(c.p10 - c.p00).cross(c.p01 - c.p00).length(), (c.p10 - c.p00).cross(c.p11 - c.p10).length(),
             (c.p11 - c.p01).cross(c.p01 - c.p00).length(), (c.p11 - c.p01).cross(c.p11 - c.p10).length()}};
}

template <class Corners>
V3d areaVector(const Corners& c, const V2d& at) {
    return bilinearDu(c.p00, c.p10, c.p01, c.p11, at).cross(bilinearDv(c.p00, c.p10, c.p01, c.p11, at));
}

} // namespace

BilinearPatches::Corners BilinearPatches::corners(unsigned prim) const {
    const std::uint32_t* v = face(prim);
    return {corner(v[0]), corner(v[1]), corner(v[2]), corner(v[3])};
}

void BilinearPatches::outline(unsigned prim, std::uint32_t corners[4]) const {
    const std::uint32_t* v = face(prim);
    corners[0] = v[0];
    corners[1] = v[1];
    corners[2] = v[3];
    corners[3] = v[2];
}

bool BilinearPatches::intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const {
    // Neighbours overlap by this much of a patch, so that rounding opens no gap at their common edge.
    constexpr double overlap = 1e-12;
    const Corners c = corners(prim);
    const V3d& d = ray.d;
    const V3d q00 = c.p00 - ray.o, q10 = c.p10 - ray.o;
    const V3d e10 = c.p10 - c.p00, e11 = c.p11 - c.p10, e00 = c.p01 - c.p00;
    // Coefficients of a + b u + c u^2 = 0: the ray is coplanar with the patch's line at u.
    const double a0 = q00.cross(d).dot(e00), a2 = e10.cross(c.p01 - c.p11).dot(d);
    const double a1 = q10.cross(d).dot(e11) - (a0 + a2);
    const double discriminant = sqr(a1) - 4 * a0 * a2;
    if (!(discriminant >= 0)) return false;
    const double q = -(a1 + std::copysign(std::sqrt(discriminant), a1)) / 2;
    bool found = false;
    for (const double root : {q / a2, a0 / q}) {
        if (!(root >= -overlap && root <= 1 + overlap)) continue;
        const double u = std::clamp(root, 0., 1.);
        const V3d pa = q00 + e10 * u, line = e00 + (e11 - e00) * u;
        const V3d n = d.cross(line), m = n.cross(pa);
        const double n2 = n.length2(), s = m.dot(line) / n2, v = m.dot(d) / n2;
        if (!(s > sMin && s < sMax && v >= -overlap && v <= 1 + overlap)) continue;
        sMax = s;
        hit = PrimitiveHit{s, u, std::clamp(v, 0., 1.), prim};
        found = true;
    }
    return found;
}

SurfacePoint BilinearPatches::pointAt(const Ray&, const PrimitiveHit& hit) const {
    const Corners c = corners(hit.prim);
    const std::uint32_t* v = face(hit.prim);
    const V2d at(hit.u, hit.v);
    const V3d dpdu = bilinearDu(c.p00, c.p10, c.p01, c.p11, at), dpdv = bilinearDv(c.p00, c.p10, c.p01, c.p11, at);
    V3d normal = dpdu.cross(dpdv);
    // At a corner where two vertices fell together the normal is that of the patch's middle.
    if (!(normal.length2() > 0)) normal = areaVector(c, V2d(0.5, 0.5));
    const double sign = mesh().flips ? -1 : 1;
    const V3d n = normal.normalized();
    SurfacePoint point;
    point.p = bilinear(c.p00, c.p10, c.p01, c.p11, at);
    const double size = std::max((c.p11 - c.p00).length(), (c.p01 - c.p10).length());
    // Rounding in double is far below the slope of directions that leave only by their own rounding.
    point.error = 0x1p-44 * maxAbs(point.p) + 2 * grazingSlope * size;
    point.ng = point.ns = toFloat(n * sign);
    // Weingarten's equations; only the mixed second derivative is not zero.
    const double e = dpdu.length2(), f = dpdu.dot(dpdv), g = dpdv.length2(), area2 = e * g - f * f;
    const double twist = n.dot((c.p11 - c.p10) - (c.p01 - c.p00));
    const double scale = area2 > 0 ? sign * twist / area2 : 0;
    const V3d dndu = (dpdu * f - dpdv * e) * scale, dndv = (dpdv * f - dpdu * g) * scale;
    const auto& uv = mesh().uv;
    std::optional<BilinearTexture> texture;
    if (uv.empty()) {
        point.uv = V2f(at);
        point.dpdu = toFloat(dpdu);
        point.dpdv = toFloat(dpdv);
        point.dndu = toFloat(dndu);
        point.dndv = toFloat(dndv);
    } else {
        texture.emplace(uv[v[0]], uv[v[1]], uv[v[2]], uv[v[3]], at);
        point.uv = texture->st();
        texture->derivatives(dpdu, dpdv, point.dpdu, point.dpdv);
        texture->derivatives(dndu, dndv, point.dndu, point.dndv);
    }
    if (const auto& given = mesh().n; !given.empty()) {
        const V3f normals[4] = {given[v[0]], given[v[1]], given[v[2]], given[v[3]]};
        shadeBilinear(normals, at, texture ? &*texture : nullptr, point);
    }
    return point;
}

double BilinearPatches::primitiveArea(unsigned prim) const {
    const Corners c = corners(prim);
    const auto element = [&](double u, double v) { return areaVector(c, V2d(u, v)).length(); };
    return refinePanels(
        [&](int panels) {
            return integratePanels(
                [&](double u) { return integratePanels([&](double v) { return element(u, v); }, 0, 1, panels); }, 0, 1,
                panels);
        },
        16);
}

PrimitiveHit BilinearPatches::drawPoint(unsigned prim, const V2f& u) const {
    const V2d at = cornerWeights(corners(prim)).sample(u);
    PrimitiveHit hit;
    hit.prim = prim;
    hit.u = at.x;
    hit.v = at.y;
    return hit;
}

double BilinearPatches::density(double probability, const PrimitiveHit& hit) const {
    const Corners c = corners(hit.prim);
    const V2d at(hit.u, hit.v);
    return probability * cornerWeights(c).pdf(at) / areaVector(c, at).length();
}

} // namespace vitrine
