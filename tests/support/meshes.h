// Meshes for tests.
#pragma once

#include "core/random.h"
#include "shapes/mesh.h"

#include <map>

namespace vitrine::test {

inline ShapePtr onlyShape(MeshInput input, const Transform& worldFromObject = {}, bool reverseOrientation = false) {
    auto shapes = makeMeshShapes(std::move(input), worldFromObject, reverseOrientation);
    if (shapes.size() != 1) throw std::logic_error("the mesh makes more or less than one shape");
    return shapes.front();
}

/// The cube [-1,1]^3 about `center`, faces outwards, as quads.
inline MeshInput cubeMesh(const V3d& center = V3d(0, 0, 0), double half = 1) {
    MeshInput mesh;
    for (int i = 0; i < 8; ++i)
        mesh.p.push_back(toFloat(center + V3d(i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half)));
    // In pbrt's order 00 10 01 11, du x dv outwards.
    mesh.quads = {0, 2, 1, 3, 4, 5, 6, 7, 0, 1, 4, 5, 2, 6, 3, 7, 0, 4, 2, 6, 1, 3, 5, 7};
    return mesh;
}

/// Every quad of the mesh as two triangles.
inline MeshInput asTriangles(MeshInput mesh) {
    for (std::size_t i = 0; i < mesh.quads.size(); i += 4) {
        const std::uint32_t* q = &mesh.quads[i];
        for (const int k : {0, 1, 3, 0, 3, 2})
            mesh.triangles.push_back(q[k]);
    }
    mesh.quads.clear();
    return mesh;
}

/// A sphere of triangles: an icosahedron subdivided `levels` times, vertices at `radius`, faces outwards.
inline MeshInput icosphere(int levels, const V3d& center = V3d(0, 0, 0), double radius = 1) {
    const double t = (1 + std::sqrt(5.)) / 2;
    std::vector<V3d> p{{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                       {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    std::vector<std::uint32_t> faces{0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                     4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                     6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [at, isNew] = middles.try_emplace(std::minmax(a, b), std::uint32_t(p.size()));
            if (isNew) p.push_back((p[a] + p[b]) / 2);
            return at->second;
        };
        std::vector<std::uint32_t> finer;
        for (std::size_t i = 0; i < faces.size(); i += 3) {
            const std::uint32_t a = faces[i], b = faces[i + 1], c = faces[i + 2];
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
        }
        faces = std::move(finer);
    }
    MeshInput mesh;
    for (const V3d& vertex : p)
        mesh.p.push_back(toFloat(center + vertex.normalized() * radius));
    mesh.triangles = std::move(faces);
    return mesh;
}

/// One patch.
inline MeshInput patch(const V3d& p00, const V3d& p10, const V3d& p01, const V3d& p11) {
    MeshInput mesh;
    mesh.p = {toFloat(p00), toFloat(p10), toFloat(p01), toFloat(p11)};
    mesh.quads = {0, 1, 2, 3};
    return mesh;
}

/// Triangles or patches at random in [-1,1]^3, of all sizes down to slivers.
inline MeshInput soup(std::uint64_t seed, int faces, unsigned perFace) {
    RandomStream random(seed);
    MeshInput mesh;
    const auto any = [&] { return V3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)); };
    for (int i = 0; i < faces; ++i) {
        const V3d center = any();
        const double size = std::exp(random.uniform(-5, 0));
        for (unsigned k = 0; k < perFace; ++k) {
            (perFace == 3 ? mesh.triangles : mesh.quads).push_back(std::uint32_t(mesh.p.size()));
            mesh.p.push_back(toFloat(center + any() * size));
        }
    }
    return mesh;
}

} // namespace vitrine::test
