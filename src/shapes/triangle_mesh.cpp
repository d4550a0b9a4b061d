#include "shapes/triangle_mesh.h"

#include "core/frame.h"

namespace vitrine {

namespace {

/// pbrt's bound of a determinant below which texture coordinates span nothing.
constexpr float degenerateUv = 1e-9f;

/// d(value)/du and d(value)/dv of something linear over the triangle, from its differences to the third corner.
struct UvGradient {
    explicit UvGradient(const V2f uv[3]) : d02(uv[0] - uv[2]), d12(uv[1] - uv[2]) {
        determinant = differenceOfProducts(d02.x, d12.y, d02.y, d12.x);
        exists = std::abs(determinant) >= degenerateUv;
    }
    V3f du(const V3f& v02, const V3f& v12) const { return (v02 * d12.y - v12 * d02.y) / determinant; }
    V3f dv(const V3f& v02, const V3f& v12) const { return (v12 * d02.x - v02 * d12.x) / determinant; }

    V2f d02, d12;
    float determinant;
    bool exists;
};

} // namespace

TriangleMesh::TriangleMesh(std::shared_ptr<const MeshVertices> vertices, std::vector<std::uint32_t> indices)
    : MeshShape(std::move(vertices), std::move(indices)) {
    if (primitiveCount() > maxReadyFacets) return;
    facets_.reserve(primitiveCount());
    for (unsigned prim = 0; prim < primitiveCount(); ++prim)
        facets_.push_back(facet(prim));
}

void TriangleMesh::textureCorners(const std::uint32_t* v, V2f uv[3]) const {
    constexpr float standard[3][2] = {{0, 0}, {1, 0}, {1, 1}};
    for (int i = 0; i < 3; ++i)
        uv[i] = mesh().uv.empty() ? V2f(standard[i][0], standard[i][1]) : mesh().uv[v[i]];
}

Facet TriangleMesh::facet(unsigned prim) const {
    const std::uint32_t* v = face(prim);
    const auto [p0, p1, p2] = corners(v);
    const V3d n = (p1 - p0).cross(p2 - p0);
    Facet result;
    result.ng = toFloat(n.normalized());
    result.error = float(triangleError(p0, p1, p2));
    V2f uv[3];
    textureCorners(v, uv);
    const UvGradient gradient(uv);
    const V3f p02 = toFloat(p0 - p2), p12 = toFloat(p1 - p2);
    if (gradient.exists) {
        result.dpdu = gradient.du(p02, p12);
        result.dpdv = gradient.dv(p02, p12);
    }
    // pbrt's rule, and its choice of the side: that of (p2 - p0) x (p1 - p0).
    if (!gradient.exists || !(result.dpdu.cross(result.dpdv).length2() > 0)) anyTangents(-n, result.dpdu, result.dpdv);
    return result;
}

bool TriangleMesh::intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const {
    const auto [p0, p1, p2] = corners(face(prim));
    if (!intersectTriangle(p0, p1, p2, ray, sMin, sMax, hit)) return false;
    hit.prim = prim;
    return true;
}

SurfacePoint TriangleMesh::pointAt(const Ray&, const PrimitiveHit& hit) const {
    const std::uint32_t* v = face(hit.prim);
    const auto [p0, p1, p2] = corners(v);
    const double b1 = hit.u, b2 = hit.v, b0 = 1 - b1 - b2;
    const Facet facet = facets_.empty() ? this->facet(hit.prim) : facets_[hit.prim];
    SurfacePoint point;
    point.p = p0 + (p1 - p0) * b1 + (p2 - p0) * b2;
    point.error = originError(point.p) + facet.error;
    point.ng = mesh().flips ? -facet.ng : facet.ng;
    point.ns = point.ng;
    if (mesh().uv.empty())
        point.uv = V2f(float(b1 + b2), float(b2));
    else
        point.uv = mesh().uv[v[0]] * float(b0) + mesh().uv[v[1]] * float(b1) + mesh().uv[v[2]] * float(b2);
    point.dpdu = facet.dpdu;
    point.dpdv = facet.dpdv;
    point.dndu = point.dndv = V3f(0, 0, 0);
    if (!mesh().n.empty() || !mesh().s.empty()) addShading(v, b0, b1, b2, point);
    return point;
}

void TriangleMesh::addShading(const std::uint32_t* v, double b0, double b1, double b2, SurfacePoint& point) const {
    const float b[3] = {float(b0), float(b1), float(b2)};
    const auto mixed = [&](const std::vector<V3f>& values) {
        return values[v[0]] * b[0] + values[v[1]] * b[1] + values[v[2]] * b[2];
    };
    if (!mesh().n.empty()) {
        const V3f ns = mixed(mesh().n);
        const float length = ns.length();
        if (length > 0) {
            point.ns = ns / length;
            // As in pbrt, given normals say which side is out.
            if (point.ng.dot(point.ns) < 0) point.ng = -point.ng;
            V2f uv[3];
            textureCorners(v, uv);
            const UvGradient gradient(uv);
            if (gradient.exists) {
                const V3f n02 = mesh().n[v[0]] - mesh().n[v[2]], n12 = mesh().n[v[1]] - mesh().n[v[2]];
                // The derivative of the normalised normal: without the part along it.
                const auto tangential = [&](const V3f& d) { return (d - point.ns * point.ns.dot(d)) / length; };
                point.dndu = tangential(gradient.du(n02, n12));
                point.dndv = tangential(gradient.dv(n02, n12));
            }
        }
    }
    if (!mesh().s.empty()) {
        const V3f s = mixed(mesh().s);
        if (!(s.length2() > 0)) return;
        const Frame frame(point.ns, s);
        point.dpdu = frame.s * point.dpdu.length();
        point.dpdv = frame.t * point.dpdv.length();
    }
}

double TriangleMesh::primitiveArea(unsigned prim) const {
    const auto [p0, p1, p2] = corners(face(prim));
    return (p1 - p0).cross(p2 - p0).length() / 2;
}

PrimitiveHit TriangleMesh::drawPoint(unsigned prim, const V2f& u) const {
    const V2f b = sampleUniformTriangle(u);
    PrimitiveHit hit;
    hit.prim = prim;
    hit.u = b.y;
    hit.v = 1 - double(b.x) - double(b.y);
    return hit;
}

std::vector<PrimitiveHit> TriangleMesh::flatCorners(unsigned prim) const {
    return {{infinityD, 0, 0, prim}, {infinityD, 1, 0, prim}, {infinityD, 0, 1, prim}};
}

std::size_t TriangleMesh::memoryBytes() const {
    return MeshShape::memoryBytes() + facets_.capacity() * sizeof(Facet);
}

} // namespace vitrine
