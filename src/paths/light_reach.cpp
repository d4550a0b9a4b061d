#include "paths/light_reach.h"

#include "core/slabs.h"

namespace vitrine {

namespace {

/// With more lights than this one box round all serves: to look at each would take as long as the scene.
constexpr std::size_t maxBoxes = 8;
/// By so much of its coordinates a box is padded: hits on what lies in it are rounded far less.
constexpr double padding = 1e-9;

} // namespace

LightReach::LightReach(const World& world) : everywhere_(!world.infiniteLights.empty()) {
    Box3d all;
    for (const LightPtr& light : world.lights.lights()) {
        if (light->isDelta() || light->isInfinite()) continue;
        Box3d box = light->bounds();
        const V3d pad(padding * std::max(maxAbs(box.min), maxAbs(box.max)));
        box = Box3d(box.min - pad, box.max + pad);
        boxes_.push_back(box);
        all.extendBy(box);
    }
    if (boxes_.size() > maxBoxes) boxes_.assign(1, all);
}

/// The slabs of Kay & Kajiya 1986.
bool LightReach::mayMeet(const Ray& ray) const {
    if (everywhere_) return true;
    const V3d perLength = slabInverse(ray.d);
    for (const Box3d& box : boxes_) {
        const V3d a = (box.min - ray.o) * perLength, b = (box.max - ray.o) * perLength;
        const double enter = std::max({0., std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)});
        const double leave = std::min({std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)});
        // Also where a box reaches to infinity and a difference is not a number.
        if (!(enter > leave)) return true;
    }
    return false;
}

} // namespace vitrine
