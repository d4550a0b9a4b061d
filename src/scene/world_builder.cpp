#include "scene/world_builder.h"

#include "accel/moving_shape.h"
#include "lights/scene_sphere.h"
#include "scene/undivided_lights.h"
#include "shapes/revolution/profile_crossing.h"
#include "shapes/revolution/revolution.h"

#include <fmt/format.h>

namespace vitrine {

namespace {

/// Embree takes coordinates from 1.8e18 for invalid, and rays start some way outside of what they meet.
constexpr double farthest = 1e15;

bool isFar(const Box3d& box) {
    return !box.isEmpty() && !(std::max(maxAbs(box.min), maxAbs(box.max)) <= farthest);
}

class WorldBuilder {
  public:
    WorldBuilder(BuildContext& context, const LightUse& lightUse, const Shutter& shutter)
        : context_(context), lightUse_(lightUse) {
        world_.shutter = shutter;
    }

    World build() {
        refuseMedia();
        materials_ = buildMaterials(context_);
        context_.textures().buildRest();
        checkUnusedAreaLights();
        for (const auto& node : context_.nodes().shapes)
            addShape(node, input_.shapes, true);
        for (const auto& object : context_.nodes().objects) {
            auto& group = input_.groups.emplace_back();
            for (const auto& node : object.shapes)
                addShape(node, group, false);
        }
        for (const auto& instance : context_.nodes().instances)
            addInstance(instance);
        refuseFarInstances();
        for (const auto& node : context_.nodes().lights)
            addLight(node);

        // A scene that is wrong is never rendered: no need to build the tree.
        if (context_.diagnostics().hasErrors()) return {};
        const bool unbounded = hasUnbounded();
        if (lightUse_.startsPaths && !world_.moves)
            world_.undividedLights = findUndividedLights(input_, world_.surfaces, lights_);
        world_.caster = makeCaster(std::move(input_));
        placeLights(unbounded);
        return std::move(world_);
    }

  private:
    void refuseMedia() {
        for (const auto& medium : context_.nodes().media)
            if (medium.place) // else it was named, but is not there
                context_.diagnostics().error(medium.place, "participating media are not yet supported");
    }

    /// Those are never built, but what stands in them shall be right.
    void checkUnusedAreaLights() {
        std::vector<bool> used(context_.nodes().areaLights.size());
        const auto use = [&](const std::vector<ShapeNode>& shapes) {
            for (const auto& shape : shapes)
                if (shape.areaLight >= 0) used[std::size_t(shape.areaLight)] = true;
        };
        use(context_.nodes().shapes);
        for (const auto& object : context_.nodes().objects)
            use(object.shapes);
        for (std::size_t i = 0; i < used.size(); ++i)
            if (!used[i]) buildAreaLights(context_, context_.nodes().areaLights[i], {});
    }

    void addShape(const ShapeNode& node, std::vector<CasterShape>& to, bool mayShine) {
        const ShapeAlpha alpha = findShapeAlpha(context_, node.parameters);
        auto shapes = buildShape(context_, node);
        const MaterialPtr& material = materials_[std::size_t(node.material)];
        warnOfOpenGlass(node, shapes, material);
        warnOfHoles(node, alpha, material);
        const Motion motion = motionOf(context_, node.worldFromObject, node.place);
        for (auto& shape : shapes) {
            context_.countPrimitives(shape->primitiveCount());
            if (motion.moves()) shape = moving(shape, motion.sinceStart());
            if (shape->kind() != GeometryKind::Unbounded && isFar(shape->bounds()))
                context_.diagnostics().error(
                    node.place, fmt::format("this {} reaches too far: coordinates go up to {:g}", node.type, farthest));
        }
        std::vector<std::shared_ptr<AreaLight>> lights;
        if (node.areaLight >= 0) {
            if (mayShine)
                lights =
                    buildAreaLights(context_, context_.nodes().areaLights[std::size_t(node.areaLight)], shapes, alpha);
            else
                context_.diagnostics().error(node.place, "area lights in object definitions are not yet supported");
        }
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            Surface surface{material, i < lights.size() ? lights[i].get() : nullptr};
            if (i < lights.size()) lights_.push_back(lights[i]);
            if (alpha.isUnseen) continue;
            to.push_back(
                {shapes[i], std::uint32_t(world_.surfaces.size()), material && !material->isInterface(), alpha.cutout});
            world_.surfaces.push_back(std::move(surface));
        }
    }

    ShapePtr moving(const ShapePtr& shape, const Motion& motion) {
        world_.moves = true;
        const auto [caster, isNew] = insideCasters_.try_emplace(shape.get());
        if (isNew) caster->second = MovingShape::casterFor(shape);
        return std::make_shared<MovingShape>(shape, motion, world_.shutter, caster->second);
    }

    /// What moves is copied out of its group: each shape by itself, in its own bounds.
    void addInstance(const InstanceNode& node) {
        const Motion motion = motionOf(context_, node.worldFromInstance, node.place);
        if (!motion.moves()) {
            input_.instances.push_back({std::uint32_t(node.object), motion.start()});
            instancePlaces_.push_back(node.place);
            return;
        }
        for (CasterShape entry : input_.groups[std::size_t(node.object)]) {
            entry.shape = moving(entry.shape, motion);
            if (entry.shape->kind() != GeometryKind::Unbounded && isFar(entry.shape->bounds()))
                context_.diagnostics().error(
                    node.place, fmt::format("this instance reaches too far: coordinates go up to {:g}", farthest));
            input_.shapes.push_back(std::move(entry));
        }
    }

    void addLight(const LightNode& node) {
        auto light = buildLight(context_, node, world_.shutter);
        if (!light) return;
        world_.moves |= node.worldFromLight->isMoving();
        lights_.push_back(std::move(light));
    }

    static void extend(Box3d& box, const std::vector<CasterShape>& shapes) {
        for (const auto& entry : shapes)
            if (entry.shape->kind() != GeometryKind::Unbounded) box.extendBy(entry.shape->bounds());
    }

    /// Neither may an instance reach too far, nor the world as it is seen from a tiny instance.
    void refuseFarInstances() {
        if (input_.instances.empty()) return;
        std::vector<Box3d> groups(input_.groups.size());
        for (std::size_t i = 0; i < groups.size(); ++i)
            extend(groups[i], input_.groups[i]);
        Box3d world;
        extend(world, input_.shapes);
        for (const auto& instance : input_.instances)
            if (const Box3d& group = groups[instance.group]; !group.isEmpty())
                world.extendBy(instance.worldFromInstance.box(group));
        for (std::size_t i = 0; i < input_.instances.size(); ++i) {
            const CasterInstance& instance = input_.instances[i];
            const Box3d& group = groups[instance.group];
            const Place& place = instancePlaces_[i];
            if (group.isEmpty()) continue;
            if (isFar(instance.worldFromInstance.box(group)))
                context_.diagnostics().error(
                    place, fmt::format("this instance reaches too far: coordinates go up to {:g}", farthest));
            else if (isFar(instance.worldFromInstance.inverse().box(world)))
                context_.diagnostics().error(
                    place,
                    fmt::format("this instance is too small: seen from it, the scene reaches beyond {:g}", farthest));
        }
    }

    /// Solids that absorb or are nested need an inside and an outside; a plain interface works without (pbrt's), but a
    /// turned profile that is drawn for glass and does not close is most likely a slip.
    void warnOfOpenGlass(const ShapeNode& node, const std::vector<ShapePtr>& shapes, const MaterialPtr& material) {
        const Interior* interior = material ? material->interior() : nullptr;
        if (!interior) return;
        const bool needsSolid = interior->priority || interior->absorption;
        // A solid may be put together from several open shapes: only a shape that cannot be a part of one is named.
        for (const auto& shape : shapes) {
            const auto* turned = dynamic_cast<const Revolution*>(shape.get());
            if (turned && !turned->whyOpen().empty())
                context_.diagnostics().warning(
                    node.place, fmt::format("this revolution is open: {}; its dielectric needs other shapes of the "
                                            "same material to bound a solid",
                                            turned->whyOpen()));
            else if (turned && warnOfCrossing(node, turned->profile()))
                continue;
            else if (needsSolid && shape->kind() == GeometryKind::User && !shape->isClosed())
                context_.diagnostics().warning(
                    node.place,
                    fmt::format("the normals of this {} do not point out of a closed solid (it is open, reversed or "
                                "mirrored): its dielectric needs other shapes of the same material to bound one",
                                node.type));
        }
    }

    void warnOfHoles(const ShapeNode& node, const ShapeAlpha& alpha, const MaterialPtr& material) {
        const Interior* interior = material ? material->interior() : nullptr;
        if (!alpha.cutout || !interior || !(interior->priority || interior->absorption)) return;
        context_.diagnostics().warning(node.parameters.place("alpha"),
                                       fmt::format("rays pass through the holes of this {} without entering or leaving "
                                                   "the solid that its dielectric bounds",
                                                   node.type));
    }

    bool warnOfCrossing(const ShapeNode& node, const Profile& profile) {
        const auto wrong = findWrongSide(profile);
        if (!wrong) return false;
        const std::string where = fmt::format("near radius {:.4g}, height {:.4g}", wrong->p.x, wrong->p.y);
        if (wrong->winding < 1)
            context_.diagnostics().warning(node.place,
                                           fmt::format("the profile of this revolution crosses itself: the lobe {} is "
                                                       "wound the other way, so that its dielectric is inside out",
                                                       where),
                                           "draw each lobe as a shape of its own");
        else
            context_.diagnostics().warning(
                node.place,
                fmt::format("the profile of this revolution crosses itself: the line {} "
                            "lies inside of its own solid, where a dielectric has no surface",
                            where),
                "draw only the outline of what it covers");
        return true;
    }

    bool hasUnbounded() const {
        const auto any = [](const std::vector<CasterShape>& shapes) {
            return std::any_of(shapes.begin(), shapes.end(),
                               [](const CasterShape& entry) { return entry.shape->kind() == GeometryKind::Unbounded; });
        };
        return any(input_.shapes) || std::any_of(input_.groups.begin(), input_.groups.end(), any);
    }

    /// Beams from infinity fill the sphere round all that is bounded. For the choice of a light the sphere reaches to
    /// the lamps: what parallel light brings into it is to what lamps give as their brightness in the scene. Where
    /// planes are, the camera tells, better than the bounded shapes, how large the scene is.
    void placeLights(bool unbounded) {
        Box3d lit = world_.caster->bounds();
        if (unbounded) lit.extendBy(context_.nodes().camera.worldFromCamera->start.point(V3d(0, 0, 0)));
        Box3d chosenBy = lit;
        for (const auto& light : lights_)
            if (const Box3d box = light->bounds(); !box.isEmpty() && isFinite(box.size())) chosenBy.extendBy(box);
        const SceneSphere beams = SceneSphere::around(unbounded ? chosenBy : lit);
        if (unbounded && lightUse_.startsPaths) warnOfBeams(beams);
        for (const auto& light : lights_)
            light->preprocess(beams.center, beams.radius);
        SceneSphere sphere = SceneSphere::around(chosenBy);
        // Of no size, it still tells lights at infinity from each other.
        sphere.radius = sphere.radius > 0 ? std::min(sphere.radius, farthest) : 1;
        warnOfDarkness(sphere);
        world_.lights = LightSampler(std::move(lights_), sphere, lightUse_.choice);
    }

    void warnOfDarkness(const SceneSphere& lit) {
        const auto isDark = [&](const LightPtr& light) {
            return isFinite(light->bounds().size()) && LightSampler::isDark(*light, lit);
        };
        if (lights_.empty() || !std::all_of(lights_.begin(), lights_.end(), isDark)) return;
        const SceneNodes& nodes = context_.nodes();
        const Node& first = nodes.lights.empty() ? nodes.areaLights.front() : nodes.lights.front();
        context_.diagnostics().warning(first.place, "no light of this scene shines: they are black");
    }

    /// No density over a plane without end keeps the noise of what it reflects finite (docs/decisions.md, "Photon mapping").
    void warnOfBeams(const SceneSphere& beams) {
        const auto isFromInfinity = [](const LightPtr& light) { return light->bounds().isEmpty(); };
        if (std::none_of(lights_.begin(), lights_.end(), isFromInfinity)) return;
        context_.diagnostics().warning(
            lightUse_.integrator,
            fmt::format("photons of lights at infinity reach surfaces without end only within {:.4g} units of "
                        "({:.4g}, {:.4g}, {:.4g}): what lies further out sends no light on",
                        beams.radius, beams.center.x, beams.center.y, beams.center.z),
            "a disk in place of the plane is lit all over; the path integrator knows no such bound");
    }

    BuildContext& context_;
    LightUse lightUse_;
    World world_;
    CasterInput input_;
    std::vector<MaterialPtr> materials_;
    std::vector<LightPtr> lights_;
    std::vector<Place> instancePlaces_; ///< of input_.instances
    std::map<const Shape*, std::shared_ptr<const Caster>> insideCasters_;
};

} // namespace

World buildWorld(BuildContext& context, const LightUse& lightUse, const Shutter& shutter) {
    return WorldBuilder(context, lightUse, shutter).build();
}

} // namespace vitrine
