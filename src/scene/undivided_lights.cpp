#include "scene/undivided_lights.h"

namespace vitrine {

namespace {

/// By so much of its coordinates a lamp's box is padded: rays start off its surface by the error of their points, 1e-6 of
/// the coordinates on meshes.
constexpr double padding = 1e-5;

/// A shape that bounds a solid, or a part of one.
struct SolidShape {
    const Shape* shape;
    const Transform* worldFromShape; ///< of an instance; null: the shape lies in the world
    Box3d box;                       ///< in the world

    Box3d inWorld(const Box3d& own) const { return worldFromShape ? worldFromShape->box(own) : own; }

    bool comesNear(const Box3d& lamp) const {
        if (shape->kind() == GeometryKind::Unbounded) return true;
        if (!box.intersects(lamp)) return false;
        for (unsigned prim = 0; prim < shape->primitiveCount(); ++prim)
            if (inWorld(shape->bounds(prim)).intersects(lamp)) return true;
        return false;
    }
};

std::vector<SolidShape> solidShapes(const CasterInput& input, const std::vector<Surface>& surfaces) {
    std::vector<SolidShape> solids;
    const auto add = [&](const std::vector<CasterShape>& shapes, const Transform* worldFromShape) {
        for (const CasterShape& entry : shapes) {
            if (!surfaces[entry.id].interior()) continue;
            SolidShape solid{entry.shape.get(), worldFromShape, {}};
            if (entry.shape->kind() != GeometryKind::Unbounded) solid.box = solid.inWorld(entry.shape->bounds());
            solids.push_back(solid);
        }
    };
    add(input.shapes, nullptr);
    for (const CasterInstance& instance : input.instances)
        add(input.groups[instance.group], &instance.worldFromInstance);
    return solids;
}

} // namespace

std::vector<bool> findUndividedLights(const CasterInput& input, const std::vector<Surface>& surfaces,
                                      const std::vector<LightPtr>& lights) {
    const std::vector<SolidShape> solids = solidShapes(input, surfaces);
    const bool hasUnbounded = std::any_of(solids.begin(), solids.end(), [](const SolidShape& solid) {
        return solid.shape->kind() == GeometryKind::Unbounded;
    });
    std::vector<bool> undivided;
    for (const LightPtr& light : lights) {
        const Box3d box = light->bounds();
        if (box.isEmpty()) { // at infinity: its rays start outside of all that is bounded
            undivided.push_back(!hasUnbounded);
            continue;
        }
        const V3d pad(padding * std::max(maxAbs(box.min), maxAbs(box.max)));
        const Box3d near(box.min - pad, box.max + pad);
        const auto meets = [&](const SolidShape& solid) { return solid.comesNear(near); };
        undivided.push_back(box.min == box.max || std::none_of(solids.begin(), solids.end(), meets));
    }
    return undivided;
}

} // namespace vitrine
