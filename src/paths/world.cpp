#include "paths/world.h"

namespace vitrine {

void World::prepare() {
    infiniteLights.clear();
    for (const auto& light : lights.lights())
        if (light->isInfinite()) infiniteLights.push_back(light.get());

    moves |= camera && camera->moves();
    bool hasInteriors = false;
    for (const Surface& surface : surfaces) {
        filtersTextures |= surface.filtersTextures();
        const Interior* interior = surface.interior();
        if (!interior) continue;
        hasInteriors = true;
        hasNestedDielectrics |= interior->priority.has_value();
        hasAbsorption |= interior->absorption != nullptr;
    }
    if (!hasInteriors || !camera) return;
    cameraInterior = interiorAt(*this, camera->position(), shutter.open);
    raysStartApart = (moves || !camera->startsAtPosition()) && (hasNestedDielectrics || hasAbsorption);
}

namespace {

/// The solids that a ray leaves without having entered them: those around its origin, nearest exit first.
std::vector<const Interior*> leftAlong(const World& world, Ray ray) {
    std::vector<const Interior*> entered, left;
    constexpr int maxSurfaces = 10000;
    for (int i = 0; i < maxSurfaces; ++i) {
        CasterHit hit;
        if (!world.caster->intersect(ray, hit)) break;
        const V3f d = toFloat(ray.d);
        if (const Interior* interior = world.surfaces[hit.id].interior()) {
            const auto open = std::find(entered.rbegin(), entered.rend(), interior);
            if (hit.point.ng.dot(d) < 0)
                entered.push_back(interior);
            else if (open != entered.rend())
                entered.erase(std::next(open).base());
            else
                left.push_back(interior);
        }
        ray.o = offsetOrigin(hit.point, d);
    }
    return left;
}

} // namespace

InteriorStack interiorAt(const World& world, const V3d& p, double time) {
    // Any direction serves for closed solids; one that no modeller aligns things with avoids edges and tangents. The
    // solid below an infinite plane is left in one of two opposite directions only.
    const V3d direction = V3d(0.36174, 0.75312, 0.54947).normalized();
    std::vector<const Interior*> around = leftAlong(world, Ray{p, direction, infinityD, time});
    for (const Interior* other : leftAlong(world, Ray{p, -direction, infinityD, time}))
        if (std::find(around.begin(), around.end(), other) == around.end()) around.push_back(other);
    // What is left last was entered first.
    InteriorStack stack;
    for (auto it = around.rbegin(); it != around.rend(); ++it)
        stack.enter(**it);
    return stack;
}

} // namespace vitrine
