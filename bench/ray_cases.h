// Shapes to be cast at, and the rays: fixed by seeds, the same in every run.
#pragma once

#include "accel/caster.h"
#include "core/random.h"
#include "nodes/parser.h"
#include "shapes/box.h"
#include "shapes/cylinder.h"
#include "shapes/disk.h"
#include "shapes/mesh.h"
#include "shapes/plane.h"
#include "shapes/revolution/revolution.h"
#include "shapes/sphere.h"

#include <stdexcept>

namespace vitrine::bench {

/// About [-1,1]^3 each, so that rays aimed there are alike for all.
struct ShapeCase {
    std::string name;
    ShapePtr (*make)();
    /// Whether primitives are so many that only the caster can find the one that is met.
    bool casterOnly = false;
};

inline ShapePtr onlyShape(MeshInput input) {
    auto shapes = makeMeshShapes(std::move(input), Transform(), false);
    if (shapes.size() != 1) throw std::logic_error("the mesh makes more or less than one shape");
    return shapes.front();
}

/// A sphere with waves of `side` x `side` cells of two triangles; at its poles they are slivers.
inline ShapePtr wavySphere(std::uint32_t side) {
    MeshInput mesh;
    for (std::uint32_t j = 0; j <= side; ++j)
        for (std::uint32_t i = 0; i <= side; ++i) {
            const double theta = pi * j / side, phi = 2 * pi * i / side;
            const double r = 0.9 + 0.1 * std::cos(8 * phi) * sqr(std::sin(theta));
            mesh.p.push_back(
                toFloat(V3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)) * r));
        }
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            const std::uint32_t a = j * (side + 1) + i, b = a + side + 1;
            mesh.triangles.insert(mesh.triangles.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    return onlyShape(std::move(mesh));
}

inline ShapePtr patch(float lift) {
    MeshInput mesh;
    mesh.p = {V3f(-1, -1, 0), V3f(1, -1, lift), V3f(-1, 1, lift), V3f(1, 1, 0)};
    mesh.quads = {0, 1, 2, 3};
    return onlyShape(std::move(mesh));
}

/// One curve from (0,-1) to (0,1) whose inner control points have radii at random.
template <int Degree>
ShapePtr turnedCurve() {
    RandomStream random(Degree);
    std::vector<V2d> points;
    for (int i = 0; i <= Degree; ++i)
        points.emplace_back(i == 0 || i == Degree ? 0 : random.uniform(0.2, 1.4), -1 + 2. * i / Degree);
    return std::make_shared<Revolution>(Transform(), false, Profile(points, Degree));
}

/// The goblet of scenes/goblet, brought to [-1,1] in height.
inline ShapePtr goblet() {
    const SceneNodes nodes = parseSceneFile(VITRINE_SOURCE_DIR "/scenes/goblet/goblet.pbrt");
    for (const ShapeNode& node : nodes.shapes)
        if (node.type == "revolution") {
            std::vector<V2d> points = node.parameters.getPoint2s("P");
            const int degree = node.parameters.getInteger("degree", int(points.size()) - 1);
            for (V2d& p : points)
                p = V2d(p.x, p.y - 0.66) / 0.66;
            return std::make_shared<Revolution>(Transform(), false, Profile(points, degree));
        }
    throw std::runtime_error("scenes/goblet has no revolution");
}

inline const ShapeCase shapeCases[] = {
    {"sphere", [] { return ShapePtr(std::make_shared<Sphere>(Transform(), false, 1, -1, 1, 360)); }},
    {"partial_sphere", [] { return ShapePtr(std::make_shared<Sphere>(Transform(), false, 1, -0.5, 0.7, 250)); }},
    {"disk", [] { return ShapePtr(std::make_shared<Disk>(Transform(), false, 0, 1, 0, 360)); }},
    {"cylinder", [] { return ShapePtr(std::make_shared<Cylinder>(Transform(), false, 1, -1, 1, 360)); }},
    {"box", [] { return ShapePtr(std::make_shared<Box>(Transform(), false, V3d(-1), V3d(1))); }},
    {"plane", [] { return ShapePtr(std::make_shared<Plane>(Transform(), false, V3d(0, 0, 1), 0)); }},
    {"mesh_100k", [] { return wavySphere(224); }, true},
    {"bilinear_planar", [] { return patch(0); }},
    {"bilinear_bent", [] { return patch(0.8f); }},
    {"revolution_3", turnedCurve<3>},
    {"revolution_8", turnedCurve<8>},
    {"revolution_20", turnedCurve<20>},
    {"goblet", goblet},
};

/// How neighbours in the list of rays belong together.
enum class RayOrder {
    Coherent, ///< a camera's, block by block of 8 x 8 pixels
    Random    ///< from anywhere in [-2,2]^3 outside the shape's box to anywhere in it
};

inline constexpr int rayCount = 4096; ///< 56 bytes each: they stay in the second-level cache

inline std::vector<Ray> makeRays(RayOrder order) {
    std::vector<Ray> rays;
    RandomStream random(7);
    const auto any = [&](double half) {
        return V3d(random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half));
    };
    for (int i = 0; i < rayCount; ++i) {
        Ray ray;
        if (order == RayOrder::Coherent) {
            const int block = i / 64, within = i % 64;
            const double x = (block % 8 * 8 + within % 8 + 0.5) / 64, y = (block / 8 * 8 + within / 8 + 0.5) / 64;
            ray.o = V3d(1.5, 2, 3.2);
            ray.d = V3d(2.4 * x - 1.2, 0, 0) + V3d(0, 2.4 * y - 1.2, 1.2 - 2.4 * y) * std::sqrt(0.5) - ray.o;
        } else {
            do
                ray.o = any(2);
            while (maxAbs(ray.o) < 1.1);
            ray.d = any(1) - ray.o;
        }
        ray.d = ray.d.normalized();
        rays.push_back(ray);
    }
    return rays;
}

} // namespace vitrine::bench
