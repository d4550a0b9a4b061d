#include "scene/registry.h"
#include "scene/revolution_builder.h"
#include "scene/world_builder.h"
#include "shapes/box.h"
#include "shapes/cylinder.h"
#include "shapes/disk.h"
#include "shapes/mesh.h"
#include "shapes/plane.h"
#include "shapes/ply.h"
#include "shapes/revolution/revolution.h"
#include "shapes/sphere.h"

#include <fmt/format.h>

namespace vitrine {

namespace {

struct ShapeInput {
    BuildContext& context;
    const ShapeNode& node;
    const ParameterSet& parameters;
    const Transform& worldFromObject;
    bool reverse;
};

using Shapes = std::vector<ShapePtr>;

Shapes sphere(const ShapeInput& in) {
    const ParameterSet& p = in.parameters;
    const double radius = p.getFloat("radius", 1);
    return {std::make_shared<Sphere>(in.worldFromObject, in.reverse, radius, p.getFloat("zmin", -radius),
                                     p.getFloat("zmax", radius), p.getFloat("phimax", 360))};
}

Shapes disk(const ShapeInput& in) {
    const ParameterSet& p = in.parameters;
    return {std::make_shared<Disk>(in.worldFromObject, in.reverse, p.getFloat("height", 0), p.getFloat("radius", 1),
                                   p.getFloat("innerradius", 0), p.getFloat("phimax", 360))};
}

Shapes cylinder(const ShapeInput& in) {
    const ParameterSet& p = in.parameters;
    return {std::make_shared<Cylinder>(in.worldFromObject, in.reverse, p.getFloat("radius", 1), p.getFloat("zmin", -1),
                                       p.getFloat("zmax", 1), p.getFloat("phimax", 360))};
}

Shapes box(const ShapeInput& in) {
    const ParameterSet& p = in.parameters;
    return {std::make_shared<Box>(in.worldFromObject, in.reverse, p.getPoint3("pmin", V3d(-1, -1, -1)),
                                  p.getPoint3("pmax", V3d(1, 1, 1)))};
}

Shapes plane(const ShapeInput& in) {
    const ParameterSet& p = in.parameters;
    const V3d n = p.getNormal("n", V3d(0, 1, 0));
    const auto on = p.findPoint3("p");
    const auto d = p.findFloat("d");
    if (on && d) p.error("d", "a plane takes \"d\" or \"p\", not both");
    return {std::make_shared<Plane>(in.worldFromObject, in.reverse, n, on ? n.dot(*on) : d.value_or(0))};
}

std::vector<std::uint32_t> vertexIndices(const ParameterSet& p, std::size_t perFace) {
    const auto given = p.getIntegers("indices");
    if (given.size() % perFace != 0)
        p.error("indices", fmt::format("{} indices are no multiple of {}", given.size(), perFace));
    const auto negative = std::find_if(given.begin(), given.end(), [](int index) { return index < 0; });
    if (negative != given.end())
        p.errorAtValue("indices", std::size_t(negative - given.begin()), "a vertex index must not be negative");
    // In place of negative ones stands 0, so that the mesh finds those that are too large.
    std::vector<std::uint32_t> indices(given.size() - given.size() % perFace);
    for (std::size_t i = 0; i < indices.size(); ++i)
        indices[i] = std::uint32_t(std::max(0, given[i]));
    return indices;
}

MeshInput meshInput(const ParameterSet& p) {
    MeshInput mesh;
    mesh.p = p.getPoint3s<V3f>("P");
    mesh.n = p.getNormals<V3f>("N");
    mesh.uv = p.getPoint2s<V2f>("uv");
    if (mesh.p.empty()) throw SceneError(p.place("P"), "a mesh needs vertices: \"point3 P\"");
    acceptWithoutEffect(p, {"faceIndices"});
    return mesh;
}

Shapes triangleMesh(const ShapeInput& in) {
    const ParameterSet& p = in.parameters;
    MeshInput mesh = meshInput(p);
    mesh.s = p.getVector3s<V3f>("S");
    mesh.triangles = vertexIndices(p, 3);
    if (!p.has("indices")) {
        if (mesh.p.size() != 3) throw SceneError(p.place("P"), "a triangle mesh needs \"integer indices\"");
        mesh.triangles = {0, 1, 2};
    }
    return makeMeshShapes(std::move(mesh), in.worldFromObject, in.reverse);
}

Shapes bilinearMesh(const ShapeInput& in) {
    const ParameterSet& p = in.parameters;
    refuse(p, {"emissionfilename"});
    MeshInput mesh = meshInput(p);
    mesh.quads = vertexIndices(p, 4);
    if (!p.has("indices")) {
        if (mesh.p.size() != 4) throw SceneError(p.place("P"), "a bilinear mesh needs \"integer indices\"");
        mesh.quads = {0, 1, 2, 3};
    }
    return makeMeshShapes(std::move(mesh), in.worldFromObject, in.reverse);
}

Shapes plyMesh(const ShapeInput& in) {
    const ParameterSet& p = in.parameters;
    refuse(p, {"displacement"});
    acceptWithoutEffect(p, {"edgelength"}); // of displacement
    const auto name = p.findString("filename");
    if (!name) throw SceneError(in.node.place, "a plymesh needs \"string filename\"");
    return makeMeshShapes(readPly(in.context.file(p, "filename", *name)), in.worldFromObject, in.reverse);
}

Shapes revolution(const ShapeInput& in) {
    const ParameterSet& p = in.parameters;
    Profile profile = buildProfile(in.context, in.node);
    const bool byLength = p.getChoice("vmap", "parameter", {"parameter", "arclength"}) == "arclength";
    return {std::make_shared<Revolution>(in.worldFromObject, in.reverse, std::move(profile), p.getFloat("phimax", 360),
                                         byLength ? VMap::ArcLength : VMap::Parameter)};
}

using ShapeBuilder = Shapes (*)(const ShapeInput&);
constexpr RegistryEntry<ShapeBuilder> shapeTypes[] = {{"sphere", sphere},
                                                      {"disk", disk},
                                                      {"cylinder", cylinder},
                                                      {"box", box},
                                                      {"plane", plane},
                                                      {"trianglemesh", triangleMesh},
                                                      {"bilinearmesh", bilinearMesh},
                                                      {"plymesh", plyMesh},
                                                      {"revolution", revolution},
                                                      {"curve"},
                                                      {"loopsubdiv"}};

} // namespace

std::vector<ShapePtr> buildShape(BuildContext& context, const ShapeNode& node) {
    return context.guarded(node, [&]() -> Shapes {
        const auto build = findBuilder<ShapeBuilder>(shapeTypes, node, "shape");
        const ParameterSet& p = node.parameters;
        acceptWithoutEffect(p, {"alpha"}); // findShapeAlpha's
        return build({context, node, p, node.worldFromObject->start, node.reverseOrientation});
    });
}

} // namespace vitrine
