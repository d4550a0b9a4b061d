#include "paths/world.h"

namespace vitrine {

void World::prepare() {
    infiniteLights.clear();
    for (const auto& light : lights.lights())
        if (light->isInfinite()) infiniteLights.push_back(light.get());

    bool hasInteriors = false;
    for (const Surface& surface : surfaces) {
        const Interior* interior = surface.material ? surface.material->interior() : nullptr;
        if (!interior) continue;
        hasInteriors = true;
        hasNestedDielectrics |= interior->priority.has_value();
        hasAbsorption |= interior->absorption != nullptr;
    }
    if (hasInteriors && camera) cameraInterior = interiorAt(*this, camera->position());
}

InteriorStack interiorAt(const World& world, const V3d& p) {
    InteriorStack stack;
    const Box3d box = world.caster->bounds();
    if (box.isEmpty() || !box.intersects(p)) return stack;

    // Any direction serves for closed solids; one that no modeller aligns things with avoids edges and tangents.
    const V3d direction = V3d(0.36174, 0.75312, 0.54947).normalized();
    const double far = 2 * box.size().length();
    Ray ray{p + direction * far, -direction, far};
    constexpr int maxSurfaces = 10000;
    for (int i = 0; i < maxSurfaces; ++i) {
        CasterHit hit;
        if (!world.caster->intersect(ray, hit)) break;
        const V3f d = toFloat(ray.d);
        const auto& material = world.surfaces[hit.id].material;
        if (const Interior* interior = material ? material->interior() : nullptr) {
            if (hit.point.ng.dot(d) < 0)
                stack.enter(*interior);
            else
                stack.leave(*interior);
        }
        const V3d next = offsetOrigin(hit.point, d);
        const double left = (p - next).dot(ray.d);
        if (left <= 0) break;
        ray = Ray{next, ray.d, left};
    }
    return stack;
}

} // namespace vitrine
