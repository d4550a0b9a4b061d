#include "scene/plain_scene.h"

#include "film/imageio.h"
#include "nodes/parser.h"
#include "scene/plain_resources.h"
#include "scene/plain_settings.h"
#include "scene/plain_shapes.h"
#include "scene/scene.h"
#include "scene/world_builder.h"
#include "shapes/revolution/revolution.h"
#include "shapes/revolution/tessellate.h"

#include <fmt/format.h>

namespace vitrine {

namespace {

bool isSameSurface(const Revolution& a, const Revolution& b) {
    const auto &s = a.profile().segments(), &t = b.profile().segments();
    if (s.size() != t.size() || a.phiMaxDegrees() != b.phiMaxDegrees()) return false;
    for (std::size_t i = 0; i < s.size(); ++i)
        if (s[i].points() != t[i].points()) return false;
    for (const double v : {0.1, 0.37, 0.81}) // the (u, v) may differ
        if (a.textureV(v) != b.textureV(v)) return false;
    return true;
}

class Translator {
  public:
    Translator(const std::string& file, const MeshOptions& options)
        : options_(options), bounds_(boundsOf(file)), context_(source_, diagnostics_) {
        source_ = parseSceneFile(file);
        scene_.nodes = source_;
    }

    PlainScene translate() {
        SceneNodes& nodes = scene_.nodes;
        if (!options_.onlyRevolutions) {
            addViewers();
            warnOfNestedSolids();
            const bool hasMedia = interiorsAsMedia(nodes, diagnostics_);
            nodes.integrator = plainIntegrator(nodes.integrator, hasMedia || usesInterfaces(), diagnostics_);
            refuseLatLongMaps();
        }
        for (auto& shape : nodes.shapes)
            shape = plainShape(shape, bounds_);
        for (std::size_t i = 0; i < nodes.objects.size(); ++i)
            for (auto& shape : nodes.objects[i].shapes)
                shape = plainShape(shape, seenFrom(int(i)));
        diagnostics_.throwIfErrors();
        gatherResources(scene_);
        scene_.warnings = diagnostics_.all();
        return std::move(scene_);
    }

  private:
    /// Of everything but infinite planes. Loading the scene finds what is wrong with it, as `render` would.
    static Box3d boundsOf(const std::string& file) { return loadScene(file).world.caster->bounds(); }

    /// A plane must reach beyond the camera and the lights too.
    void addViewers() {
        bounds_.extendBy(source_.camera.worldFromCamera->start.point(V3d(0, 0, 0)));
        for (const auto& light : source_.lights)
            if (light.type != "infinite" && light.type != "distant")
                bounds_.extendBy(light.worldFromLight->start.point(light.parameters.getPoint3("from", V3d(0, 0, 0))));
    }

    /// The bounds as they lie in an object definition, for all of its instances.
    Box3d seenFrom(int object) const {
        Box3d box;
        for (const auto& instance : source_.instances)
            if (instance.object == object) box.extendBy(instance.worldFromInstance->start.inverse().box(bounds_));
        return box;
    }

    bool usesInterfaces() const {
        const auto& materials = scene_.nodes.materials;
        const auto any = [&](const std::vector<ShapeNode>& shapes) {
            return std::any_of(shapes.begin(), shapes.end(), [&](const ShapeNode& shape) {
                return materials[std::size_t(shape.material)].type == "interface";
            });
        };
        return any(scene_.nodes.shapes) || std::any_of(scene_.nodes.objects.begin(), scene_.nodes.objects.end(),
                                                       [&](const ObjectNode& object) { return any(object.shapes); });
    }

    /// pbrt-v4 is told of each surface what lies on both sides; the outside of a solid is written as empty.
    void warnOfNestedSolids() {
        struct Solid {
            const ShapeNode* node;
            Box3d box;
            bool absorbs;
        };
        std::vector<Solid> solids;
        for (const auto& node : source_.shapes) {
            const MaterialNode& material = source_.materials[std::size_t(node.material)];
            if (material.type != "dielectric") continue;
            Solid solid{&node, {}, material.parameters.has("absorption")};
            for (const auto& shape : buildShape(context_, node))
                solid.box.extendBy(shape->bounds());
            solids.push_back(solid);
        }
        for (const Solid& a : solids)
            for (const Solid& b : solids)
                if (a.absorbs && &a != &b && (!b.absorbs || &a < &b) && a.box.intersects(b.box)) {
                    diagnostics_.warning(b.node->place,
                                         "if this solid touches, holds or lies in another one that absorbs, pbrt-v4's "
                                         "picture will differ: what is around it is written as empty space");
                    return;
                }
    }

    ShapeNode plainShape(const ShapeNode& node, const Box3d& seen) {
        ShapeNode result = node;
        if (options_.onlyRevolutions && node.type != "revolution") return result;
        if (node.type == "plane") {
            diagnostics_.warning(
                node.place, "pbrt-v4 has no infinite plane: written as a disk of 10000 times the scene's radius",
                "its (u, v) are those of a disk, and photons of a sky or distant light will miss the scene");
            return planeAsDisk(node, seen);
        }
        const bool isOurs = node.type == "revolution" || node.type == "box";
        const bool isMesh = isOurs || node.type.ends_with("mesh");
        const bool hasPower = isMesh && node.areaLight >= 0 && powerOf(node) > 0;
        std::vector<ShapePtr> built;
        if (isOurs || hasPower) built = buildShape(context_, node);
        if (isOurs && built.empty()) return result; // reported
        if (node.type == "revolution")
            result = asPlyMesh(node, meshFor(node, std::dynamic_pointer_cast<const Revolution>(built.front())));
        else if (node.type == "box")
            result = boxAsMesh(node);
        if (hasPower) {
            double area = 0;
            for (const auto& shape : built)
                area += shape->area();
            const Node light = powerAsScale(scene_.nodes.areaLights[std::size_t(node.areaLight)], area);
            result.areaLight = int(scene_.nodes.areaLights.size());
            scene_.nodes.areaLights.push_back(light);
        }
        return result;
    }

    double powerOf(const ShapeNode& node) const {
        return source_.areaLights[std::size_t(node.areaLight)].parameters.getFloat("power", -1);
    }

    /// \throws std::invalid_argument that speaks of relative tolerances, as they are given
    double absoluteTolerance(const Profile& profile) const {
        const double size = turnedSize(profile), finest = finestTolerance(profile) / size;
        if (!(finest < 1))
            throw std::invalid_argument("the shape is too small for the single precision of a mesh's vertices");
        if (!(options_.tolerance > finest))
            throw std::invalid_argument(
                fmt::format("the tolerance {:g} is finer than the single precision of a mesh's vertices keeps; for "
                            "this shape it must "
                            "be at least {:.2g} (of the shape's diameter or height, whichever is larger)",
                            options_.tolerance, 1.06 * finest));
        return options_.tolerance * size;
    }

    /// The file of the shape's mesh: a new one, or that of an equal shape.
    std::string meshFor(const ShapeNode& node, std::shared_ptr<const Revolution> shape) {
        for (const auto& mesh : scene_.meshes)
            if (isSameSurface(*mesh.shape, *shape)) return mesh.fileName;
        try {
            PlainScene::Mesh mesh;
            mesh.fileName = fmt::format("meshes/revolution-{}.ply", scene_.meshes.size() + 1);
            const Profile& profile = shape->profile();
            const double phiMax = shape->phiMaxDegrees();
            mesh.tolerance = options_.triangles ? toleranceForTriangles(profile, phiMax, *options_.triangles)
                                                : absoluteTolerance(profile);
            mesh.triangles = RevolutionTessellation(profile, phiMax, mesh.tolerance).triangleCount();
            mesh.shape = std::move(shape);
            scene_.meshes.push_back(std::move(mesh));
            return scene_.meshes.back().fileName;
        } catch (const std::invalid_argument& e) {
            diagnostics_.error(node.place, e.what());
            return "";
        }
    }

    /// Maps of latitude and longitude are ours alone.
    void refuseLatLongMaps() {
        for (const auto& light : source_.lights) {
            const auto file = light.type == "infinite" ? light.parameters.findString("filename") : std::nullopt;
            if (!file) continue;
            const Place place = light.parameters.place("filename");
            const Image image = readImage(resolveFile(source_, place, *file));
            if (image.width != image.height)
                diagnostics_.error(place,
                                   "pbrt-v4 reads environments as square equal-area maps only, not by latitude and "
                                   "longitude",
                                   "its tool makes one: imgtool makeequiarea");
        }
    }

    MeshOptions options_;
    Box3d bounds_;
    SceneNodes source_;
    Diagnostics diagnostics_;
    BuildContext context_;
    PlainScene scene_;
};

} // namespace

MeshInput PlainScene::Mesh::make() const {
    MeshInput mesh = RevolutionTessellation(shape->profile(), shape->phiMaxDegrees(), tolerance).mesh();
    for (V2f& uv : mesh.uv)
        uv.y = float(shape->textureV(double(uv.y)));
    return mesh;
}

PlainScene makePlainScene(const std::string& file, const MeshOptions& options) {
    return Translator(file, options).translate();
}

} // namespace vitrine
