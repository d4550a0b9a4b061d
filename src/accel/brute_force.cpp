// The oracle: every primitive in turn.
#include "accel/candidate.h"

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
        intersectShapes(input_.shapes, CastRay(ray), hit);
        for (std::uint32_t i = 0; i < placed_.size(); ++i)
            intersectShapes(input_.groups[placed_[i].group()], CastRay(ray, placed_[i].toInstance(ray), i, placed_[i]),
                            hit);
        if (!hit.shape) return false;
        const bool instanced = hit.instance != CasterHit::noInstance;
        hit.point = hit.shape->pointAt(instanced ? placed_[hit.instance].toInstance(ray) : ray, hit.primitive);
        if (instanced) placed_[hit.instance].toWorld(hit.point);
        return true;
    }

    bool occluded(const Ray& ray) const override {
        if (!canHit(ray)) return false;
        if (shapesOcclude(input_.shapes, CastRay(ray))) return true;
        for (std::uint32_t i = 0; i < placed_.size(); ++i)
            if (shapesOcclude(input_.groups[placed_[i].group()],
                              CastRay(ray, placed_[i].toInstance(ray), i, placed_[i])))
                return true;
        return false;
    }

    Box3d bounds() const override { return bounds_; }
    std::size_t memoryBytes() const override {
        std::size_t bytes = sizeof(*this) + memoryOf(input_.shapes);
        for (const auto& group : input_.groups)
            bytes += memoryOf(group);
        return bytes;
    }

  private:
    static void intersectShapes(const std::vector<CasterShape>& shapes, const CastRay& ray, CasterHit& best) {
        for (const CasterShape& entry : shapes)
            for (unsigned prim = 0; prim < entry.shape->primitiveCount(); ++prim)
                tryPrimitive({entry, prim}, ray, ray.world.tMax, best);
    }

    static bool shapesOcclude(const std::vector<CasterShape>& shapes, const CastRay& ray) {
        for (const CasterShape& entry : shapes)
            if (entry.castsShadow)
                for (unsigned prim = 0; prim < entry.shape->primitiveCount(); ++prim)
                    if (occludes({entry, prim}, ray)) return true;
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
