// From what a scene file says to the shapes of a mesh.
#include "shapes/bilinear_patches.h"
#include "shapes/quad_mesh.h"
#include "shapes/triangle_mesh.h"

#include <fmt/format.h>

#include <stdexcept>

namespace vitrine {

namespace {

bool isFinite(const V3f& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void checkIndices(const std::vector<std::uint32_t>& indices, unsigned perFace, std::size_t vertexCount) {
    if (indices.size() % perFace != 0)
        throw std::invalid_argument(
            fmt::format("the number of indices ({}) is not a multiple of {}", indices.size(), perFace));
    if (indices.size() > std::numeric_limits<std::uint32_t>::max())
        throw std::invalid_argument(fmt::format("{} indices are more than a mesh can hold", indices.size()));
    for (const std::uint32_t index : indices)
        if (index >= vertexCount)
            throw std::invalid_argument(
                fmt::format("index {} is out of range: there are {} vertices", std::int32_t(index), vertexCount));
}

template <class V>
void checkCount(const std::vector<V>& values, const char* name, std::size_t vertexCount) {
    if (!values.empty() && values.size() != vertexCount)
        throw std::invalid_argument(
            fmt::format("there are {} values of \"{}\", but {} vertices", values.size(), name, vertexCount));
}

void toWorld(std::vector<V3f>& values, const char* name, const auto& map) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = toFloat(map(toDouble(values[i])));
        if (!isFinite(values[i]))
            throw std::invalid_argument(fmt::format("value {} of \"{}\" is not finite in world space", i, name));
    }
}

/// Keeps the triangles with area, in their order. In place: the indices may be most of the memory there is.
void dropFlatTriangles(const MeshVertices& mesh, std::vector<std::uint32_t>& indices) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const V3d p0 = toDouble(mesh.p[indices[i]]);
        const V3d n = (toDouble(mesh.p[indices[i + 1]]) - p0).cross(toDouble(mesh.p[indices[i + 2]]) - p0);
        if (!(n.length2() > 0)) continue;
        std::copy_n(&indices[i], 3, &indices[kept]);
        kept += 3;
    }
    indices.resize(kept);
}

/// Leaves the flat patches in `quads`, in order around the quad; returns those that are bent, in pbrt's order.
std::vector<std::uint32_t> splitQuads(const MeshVertices& mesh, std::vector<std::uint32_t>& quads) {
    std::vector<std::uint32_t> bent;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < quads.size(); i += 4) {
        const std::uint32_t v[4] = {quads[i], quads[i + 1], quads[i + 2], quads[i + 3]};
        const V3d p00 = toDouble(mesh.p[v[0]]), p10 = toDouble(mesh.p[v[1]]);
        const V3d p01 = toDouble(mesh.p[v[2]]), p11 = toDouble(mesh.p[v[3]]);
        if (isPlanarQuad(p00, p10, p11, p01)) {
            quads[kept++] = v[0];
            quads[kept++] = v[1];
            quads[kept++] = v[3];
            quads[kept++] = v[2];
        } else if ((p10 - p00).cross(p01 - p00).length2() > 0 || (p10 - p11).cross(p01 - p11).length2() > 0) {
            bent.insert(bent.end(), v, v + 4);
        }
    }
    quads.resize(kept);
    return bent;
}

/// Vectors whose squares would leave single precision, brought back. All by one factor, as they are interpolated: only
/// their ratios count.
void bringIntoRange(std::vector<V3f>& vectors) {
    constexpr float smallest = 1e-15f, greatest = 1e15f;
    float largest = 0;
    for (const V3f& v : vectors)
        largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest == 0 || (largest > smallest && largest < greatest)) return;
    for (V3f& v : vectors)
        v /= largest;
}

} // namespace

std::vector<ShapePtr> makeMeshShapes(MeshInput input, const Transform& worldFromObject, bool reverseOrientation) {
    const std::size_t count = input.p.size();
    checkCount(input.n, "N", count);
    checkCount(input.s, "S", count);
    checkCount(input.uv, "uv", count);
    checkIndices(input.triangles, 3, count);
    checkIndices(input.quads, 4, count);
    for (const V2f& uv : input.uv)
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y))
            throw std::invalid_argument("a value of \"uv\" is not finite");

    auto vertices = std::make_shared<MeshVertices>();
    vertices->p = std::move(input.p);
    vertices->n = std::move(input.n);
    vertices->s = std::move(input.s);
    vertices->uv = std::move(input.uv);
    vertices->flips = reverseOrientation != worldFromObject.swapsHandedness();
    toWorld(vertices->p, "P", [&](const V3d& p) { return worldFromObject.point(p); });
    toWorld(vertices->n, "N", [&](const V3d& n) { return worldFromObject.normal(n) * (reverseOrientation ? -1 : 1); });
    toWorld(vertices->s, "S", [&](const V3d& s) { return worldFromObject.vector(s); });
    bringIntoRange(vertices->n);
    bringIntoRange(vertices->s);
    vertices->p.emplace_back(0.f, 0.f, 0.f);

    std::vector<ShapePtr> shapes;
    dropFlatTriangles(*vertices, input.triangles);
    if (!input.triangles.empty())
        shapes.push_back(std::make_shared<TriangleMesh>(vertices, std::move(input.triangles)));
    std::vector<std::uint32_t> bent = splitQuads(*vertices, input.quads);
    if (!input.quads.empty()) shapes.push_back(std::make_shared<QuadMesh>(vertices, std::move(input.quads)));
    if (!bent.empty()) shapes.push_back(std::make_shared<BilinearPatches>(vertices, std::move(bent)));
    return shapes;
}

} // namespace vitrine
