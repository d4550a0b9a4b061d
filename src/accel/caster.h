// The ray caster's face: closest hit and any hit over shapes and instances of groups of shapes.
#pragma once

#include "accel/cutout.h"

#include <vector>

namespace vitrine {

/// A shape in the caster, with the number the caller knows it by.
struct CasterShape {
    ShapePtr shape;
    std::uint32_t id = 0;
    /// Whether shadow rays stop here (false for surfaces with an "interface" material).
    bool castsShadow = true;
    CutoutPtr cutout = nullptr; ///< null: no holes
};

/// A group of shapes that lies where worldFromInstance puts it (pbrt's ObjectInstance).
struct CasterInstance {
    std::uint32_t group = 0; ///< index into CasterInput::groups
    Transform worldFromInstance;
};

struct CasterInput {
    std::vector<CasterShape> shapes;
    std::vector<std::vector<CasterShape>> groups;
    std::vector<CasterInstance> instances;
};

/// A hit in world space. Ties in distance go to the lower (instance, id, prim), shapes outside instances first.
struct CasterHit {
    static constexpr std::uint32_t noInstance = 0xffffffffu;
    double s = infinityD;
    std::uint32_t id = 0;
    std::uint32_t instance = noInstance;
    const Shape* shape = nullptr;
    PrimitiveHit primitive;
    SurfacePoint point;
};

/// Immutable after construction; all calls may be made from any thread.
class Caster {
  public:
    virtual ~Caster() = default;
    /// The closest crossing with s in (0, ray.tMax). Rays with NaN, infinite or all-zero directions meet nothing. `hit` may
    /// hold anything before; after a miss its shape is null and its s infinite.
    virtual bool intersect(const Ray& ray, CasterHit& hit) const = 0;
    /// Whether anything that casts a shadow is met with s in (0, ray.tMax).
    virtual bool occluded(const Ray& ray) const = 0;
    /// Of everything bounded.
    virtual Box3d bounds() const = 0;
    virtual std::size_t memoryBytes() const = 0;
};

/// The quickest one for what there is. \throws as makeEmbreeCaster
std::unique_ptr<Caster> makeCaster(CasterInput input);
/// \throws std::bad_alloc, std::runtime_error (Embree's own message)
std::unique_ptr<Caster> makeEmbreeCaster(CasterInput input);
/// Up to so many primitives, a bit each, a list of boxes is quicker than a tree (docs/benchmarks.md).
inline constexpr unsigned maxFlatPrimitives = 32;
/// For that many primitives without instances. \throws std::invalid_argument for more
std::unique_ptr<Caster> makeFlatCaster(const CasterInput& input);
/// Every primitive tried in turn by Shape::intersect: the slow oracle.
std::unique_ptr<Caster> makeBruteForceCaster(CasterInput input);

} // namespace vitrine
