#include "shapes/quad_mesh.h"

#include "shapes/bilinear.h"

namespace vitrine {

namespace {

/// A rectangle counts as near within so many of its diagonals. Farther away it fills less than 1/8 steradian, and what a
/// sample by area weighs varies by a half at the most to either side.
constexpr double nearDiagonals = 2;
/// How far from right its angles may be (as a cosine).
constexpr double rectangleTolerance = 1e-5;

/// The quad's normal, as long as twice its area: the cross product of its diagonals.
V3d quadNormal(const V3d p[4]) {
    return (p[2] - p[0]).cross(p[3] - p[1]);
}

} // namespace

bool isPlanarQuad(const V3d& p0, const V3d& p1, const V3d& p2, const V3d& p3) {
    const V3d p[4] = {p0, p1, p2, p3};
    const V3d normal = quadNormal(p);
    const double length = normal.length();
    if (!(length > 0)) return false;
    const V3d n = normal / length;
    double reach = 0;
    for (const V3d& corner : p)
        reach = std::max(reach, maxAbs(corner));
    // Each corner may have moved by sqrt(3) 2^-24 of its coordinates; the distance of one from the plane of the other
    // three by four times that.
    if (std::abs((p2 - p0).dot(n)) + std::abs((p3 - p1).dot(n)) + std::abs((p1 - p0).dot(n)) > 8 * 0x1p-24 * reach)
        return false;
    for (int i = 0; i < 4; ++i) {
        const V3d in = p[i] - p[(i + 3) % 4], out = p[(i + 1) % 4] - p[i];
        if (in.cross(out).dot(n) < -1e-6 * in.length() * out.length()) return false;
    }
    // Opposite corners that coincide fold the quad onto itself.
    return p0 != p2 && p1 != p3;
}

QuadMesh::QuadMesh(std::shared_ptr<const MeshVertices> vertices, std::vector<std::uint32_t> indices)
    : MeshShape(std::move(vertices), std::move(indices)) {
    if (primitiveCount() > maxReadyFacets) return;
    facets_.reserve(primitiveCount());
    for (unsigned prim = 0; prim < primitiveCount(); ++prim)
        facets_.push_back(facet(prim));
    if (primitiveCount() != 1 || !facets_[0].isParallelogram || !mesh().n.empty()) return;
    const auto [p] = corners(0);
    const V3d ex = p[1] - p[0], ey = p[3] - p[0];
    if (!(std::abs(ex.dot(ey)) <= rectangleTolerance * ex.length() * ey.length())) return;
    center_ = (p[0] + p[2]) / 2;
    nearDistance2_ = sqr(nearDiagonals) * (p[2] - p[0]).length2();
    rectanglePdf_ = 1 / area();
}

QuadMesh::Corners QuadMesh::corners(unsigned prim) const {
    const std::uint32_t* v = face(prim);
    return {{corner(v[0]), corner(v[1]), corner(v[2]), corner(v[3])}};
}

QuadMesh::QuadFacet QuadMesh::facet(unsigned prim) const {
    const Corners c = corners(prim);
    const auto& p = c.p;
    QuadFacet result;
    SurfacePoint& common = result.common;
    common.ng = toFloat(quadNormal(p).normalized());
    if (mesh().flips) common.ng = -common.ng;
    common.ns = common.ng;
    common.dpdu = common.dpdv = common.dndu = common.dndv = V3f(0, 0, 0);
    for (int i = 0; i < 4; i += 2)
        if (const V3d& a = p[i], &b = p[i + 1], &d = p[(i + 3) % 4]; (b - a).cross(d - a).length2() > 0)
            common.error = std::max(common.error, triangleError(a, b, d));
    const double size = std::max((p[2] - p[0]).length(), (p[3] - p[1]).length());
    result.isParallelogram = (p[1] - p[0] + p[3] - p[2]).length() <= 0x1p-22 * size;
    if (result.isParallelogram) {
        addTexture(face(prim), V2d(0.5, 0.5), c, common);
        result.eu = p[1] - p[0];
        result.ev = p[3] - p[0];
        result.plane = Parallelogram(p[0], result.eu, result.ev);
    }
    return result;
}

bool QuadMesh::intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const {
    if (isReadyParallelogram(prim)) {
        hit = facets_[prim].plane.cross(ray, prim);
        if (!(hit.s > sMin && hit.s < sMax)) return false;
        const double within = std::min(std::min(hit.u, 1 - hit.u), std::min(hit.v, 1 - hit.v));
        if (std::abs(within) > Parallelogram::edge) return within > 0;
    }
    return intersectTriangles(prim, ray, sMin, sMax, hit);
}

bool QuadMesh::intersectTriangles(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const {
    const auto [p] = corners(prim);
    PrimitiveHit second;
    const bool inFirst = intersectTriangle(p[0], p[1], p[3], ray, sMin, sMax, hit);
    if (intersectTriangle(p[2], p[3], p[1], ray, sMin, sMax, second) && (!inFirst || second.s < hit.s)) {
        hit.s = second.s;
        hit.u = 1 - second.u;
        hit.v = 1 - second.v;
    } else if (!inFirst)
        return false;
    hit.prim = prim;
    return true;
}

bool QuadMesh::solve(unsigned prim, const Ray& ray, PrimitiveHit& hit) const {
    if (!isReadyParallelogram(prim)) return MeshShape::solve(prim, ray, hit);
    hit = facets_[prim].plane.cross(ray, prim);
    hit.u = std::clamp(hit.u, 0., 1.);
    hit.v = std::clamp(hit.v, 0., 1.);
    return hit.s > 0 && hit.s < infinityD;
}

V2d QuadMesh::patchParameters(const Corners& c, const V3d& p) const {
    return invertBilinear(c.p[0], c.p[1], c.p[3], c.p[2], quadNormal(c.p), p);
}

void QuadMesh::addTexture(const std::uint32_t* v, const V2d& at, const Corners& c, SurfacePoint& point) const {
    const V3d dpdu = bilinearDu(c.p[0], c.p[1], c.p[3], c.p[2], at);
    const V3d dpdv = bilinearDv(c.p[0], c.p[1], c.p[3], c.p[2], at);
    if (mesh().uv.empty()) {
        point.uv = V2f(at);
        point.dpdu = toFloat(dpdu);
        point.dpdv = toFloat(dpdv);
        return;
    }
    const auto& uv = mesh().uv;
    const BilinearTexture texture(uv[v[0]], uv[v[1]], uv[v[3]], uv[v[2]], at);
    point.uv = texture.st();
    texture.derivatives(dpdu, dpdv, point.dpdu, point.dpdv);
}

bool QuadMesh::isPlainParallelogram(unsigned prim) const {
    return isReadyParallelogram(prim) && mesh().uv.empty() && mesh().n.empty();
}

SurfacePoint QuadMesh::pointAt(const Ray&, const PrimitiveHit& hit) const {
    SurfacePoint point;
    if (isPlainParallelogram(hit.prim)) {
        facets_[hit.prim].fill(hit.u, hit.v, point);
        return point;
    }
    const std::uint32_t* v = face(hit.prim);
    const Corners c = corners(hit.prim);
    const auto& p = c.p;
    const QuadFacet facet = facets_.empty() ? this->facet(hit.prim) : facets_[hit.prim];
    point = facet.common;
    // In the plane that rays are solved with.
    if (isReadyParallelogram(hit.prim))
        point.p = p[0] + facet.eu * hit.u + facet.ev * hit.v;
    else
        point.p = hit.u + hit.v <= 1 ? p[0] + (p[1] - p[0]) * hit.u + (p[3] - p[0]) * hit.v
                                     : p[2] + (p[3] - p[2]) * (1 - hit.u) + (p[1] - p[2]) * (1 - hit.v);
    point.error += originError(point.p);
    V2d at(hit.u, hit.v);
    if (!facet.isParallelogram) at = patchParameters(c, point.p);
    addTexture(v, at, c, point);
    if (!mesh().n.empty()) {
        const auto& n = mesh().n;
        const V3f corners[4] = {n[v[0]], n[v[1]], n[v[3]], n[v[2]]};
        const BilinearTexture* texture = nullptr;
        std::optional<BilinearTexture> given;
        if (!mesh().uv.empty())
            texture = &given.emplace(mesh().uv[v[0]], mesh().uv[v[1]], mesh().uv[v[3]], mesh().uv[v[2]], at);
        shadeBilinear(corners, at, texture, point);
    }
    return point;
}

double QuadMesh::primitiveArea(unsigned prim) const {
    return quadNormal(corners(prim).p).length() / 2;
}

PrimitiveHit QuadMesh::drawPoint(unsigned prim, const V2f& u) const {
    PrimitiveHit hit;
    hit.prim = prim;
    hit.u = u.x;
    hit.v = u.y;
    if (facets_.empty() ? facet(prim).isParallelogram : facets_[prim].isParallelogram) return hit;
    // The two triangles by their areas.
    const auto [p] = corners(prim);
    const double first = (p[1] - p[0]).cross(p[3] - p[0]).length();
    const double second = (p[3] - p[2]).cross(p[1] - p[2]).length(), share = first / (first + second);
    const bool inFirst = u.x < share;
    const auto within = float(inFirst ? u.x / share : (u.x - share) / (1 - share));
    const V2f b = sampleUniformTriangle(V2f(std::min(within, 1 - 0x1p-24f), u.y));
    const double b1 = b.x, b2 = b.y;
    hit.u = inFirst ? b1 : 1 - b1;
    hit.v = inFirst ? b2 : 1 - b2;
    return hit;
}

std::vector<PrimitiveHit> QuadMesh::flatCorners(unsigned prim) const {
    return {{infinityD, 0, 0, prim}, {infinityD, 1, 0, prim}, {infinityD, 1, 1, prim}, {infinityD, 0, 1, prim}};
}

std::optional<SphericalRectangle> QuadMesh::seenRectangle(const V3d& from) const {
    if (!((from - center_).length2() < nearDistance2_)) return std::nullopt;
    const auto [p] = corners(0);
    const SphericalRectangle seen(from, p[0], p[1] - p[0], p[3] - p[0]);
    // In the rectangle's plane nothing is seen of it.
    if (!(seen.solidAngle() > 0)) return std::nullopt;
    return seen;
}

std::optional<ShapeSample> QuadMesh::sample(const V3d& from, const V2f& u) const {
    if (!(nearDistance2_ > 0)) return Shape::sample(from, u);
    const std::optional<SphericalRectangle> seen = seenRectangle(from);
    const V2d at = seen ? seen->sample(u) : V2d(u.x, u.y);
    // Built in place: this is called for every shadow ray.
    std::optional<ShapeSample> result(std::in_place);
    const SurfacePoint& point = result->point;
    facets_[0].fill(at.x, at.y, result->point);
    if (seen) {
        result->pdf = float(1 / seen->solidAngle());
        return result;
    }
    const V3d d = point.p - from;
    const double distance2 = d.length2();
    // The cosine is d.ng over the distance.
    result->pdf =
        areaToSolidAngle(rectanglePdf_, distance2 * std::sqrt(distance2), std::abs(d.dot(toDouble(point.ng))));
    if (!(result->pdf > 0) || !std::isfinite(result->pdf)) result.reset();
    return result;
}

float QuadMesh::pdf(const V3d& from, const PrimitiveHit& hit, const SurfacePoint& point) const {
    const std::optional<SphericalRectangle> seen = seenRectangle(from);
    return seen ? float(1 / seen->solidAngle()) : Shape::pdf(from, hit, point);
}

std::size_t QuadMesh::memoryBytes() const {
    return MeshShape::memoryBytes() + facets_.capacity() * sizeof(QuadFacet);
}

} // namespace vitrine
