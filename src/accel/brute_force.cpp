// The oracle: every primitive in turn.
#include "accel/instance.h"

namespace vitrine {

namespace {

class BruteForceCaster final : public Caster {
  public:
    explicit BruteForceCaster(CasterInput input) : input_(std::move(input)) {
        bounds_ = boundsOf(input_.shapes);
        for (const CasterInstance& instance : input_.instances) {
            placed_.emplace_back(instance);
            bounds_.extendBy(instance.worldFromInstance.box(boundsOf(input_.groups.at(instance.group))));
        }
    }

    bool intersect(const Ray& ray, CasterHit& hit) const override {
        hit = CasterHit{};
        if (!canHit(ray)) return false;
        intersectShapes(input_.shapes, CasterHit::noInstance, ray, hit);
        for (std::uint32_t i = 0; i < placed_.size(); ++i)
            intersectShapes(input_.groups[placed_[i].group()], i, placed_[i].toInstance(ray), hit);
        if (!hit.shape) return false;
        const bool instanced = hit.instance != CasterHit::noInstance;
        hit.point = hit.shape->pointAt(instanced ? placed_[hit.instance].toInstance(ray) : ray, hit.primitive);
        if (instanced) placed_[hit.instance].toWorld(hit.point);
        return true;
    }

    bool occluded(const Ray& ray) const override {
        if (!canHit(ray)) return false;
        if (shapesOcclude(input_.shapes, ray)) return true;
        return std::any_of(placed_.begin(), placed_.end(), [&](const Placed& placed) {
            return shapesOcclude(input_.groups[placed.group()], placed.toInstance(ray));
        });
    }

    Box3d bounds() const override { return bounds_; }
    std::size_t memoryBytes() const override { return sizeof(*this); }

  private:
    static void intersectShapes(const std::vector<CasterShape>& shapes, std::uint32_t instance, const Ray& ray,
                                CasterHit& best) {
        for (const CasterShape& entry : shapes)
            for (unsigned prim = 0; prim < entry.shape->primitiveCount(); ++prim)
                tryPrimitive(*entry.shape, entry.id, prim, instance, ray, ray.tMax, best);
    }

    static bool shapesOcclude(const std::vector<CasterShape>& shapes, const Ray& ray) {
        for (const CasterShape& entry : shapes)
            if (entry.castsShadow)
                for (unsigned prim = 0; prim < entry.shape->primitiveCount(); ++prim)
                    if (entry.shape->occludes(prim, ray, 0, ray.tMax)) return true;
        return false;
    }

    CasterInput input_;
    std::vector<Placed> placed_;
    Box3d bounds_;
};

} // namespace

std::unique_ptr<Caster> makeBruteForceCaster(CasterInput input) {
    return std::make_unique<BruteForceCaster>(std::move(input));
}

} // namespace vitrine
