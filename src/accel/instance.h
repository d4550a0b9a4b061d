// An instance's place, and what its transformation does to points and errors.
#pragma once

#include "accel/caster.h"

namespace vitrine {

/// The placed group of a CasterInstance.
class Placed {
  public:
    explicit Placed(const CasterInstance& instance);

    std::uint32_t group() const { return group_; }
    const Transform& worldFromInstance() const { return worldFromInstance_; }
    const Transform& instanceFromWorld() const { return instanceFromWorld_; }
    /// Largest stretch of a vector, at most sqrt(3) too large.
    double stretch() const { return stretch_; }
    /// The same of the inverse.
    double inverseStretch() const { return inverseStretch_; }

    Ray toInstance(const Ray& ray) const { return instanceFromWorld_.ray(ray); }
    /// Takes a point of the group to the world. Normals go by the inverse transpose, so the outside stays the outside
    /// when the instance mirrors, as in pbrt.
    void toWorld(SurfacePoint& point) const;

  private:
    std::uint32_t group_;
    Transform worldFromInstance_, instanceFromWorld_;
    double stretch_, inverseStretch_;
};

/// Whether a ray can meet anything at all.
inline bool canHit(const Ray& ray) {
    return isFinite(ray.o) && isFinite(ray.d) && ray.tMax > 0 && maxAbs(ray.d) > 0;
}

/// Whether a hit at (s, instance, id, prim) comes before `other`, ties broken by the numbers.
inline bool comesBefore(double s, std::uint32_t instance, std::uint32_t id, unsigned prim, const CasterHit& other) {
    if (s != other.s) return s < other.s;
    if (!other.shape) return true;
    // noInstance is the largest number but comes first: adding one makes it zero.
    if (instance != other.instance) return instance + 1 < other.instance + 1;
    if (id != other.id) return id < other.id;
    return prim < other.primitive.prim;
}

/// A distance that a hit at exactly `s` still lies below.
inline double justAbove(double s) {
    return std::nextafter(s, infinityD);
}

/// Bounds of all bounded shapes of the list.
Box3d boundsOf(const std::vector<CasterShape>& shapes);
/// Of the shapes themselves: tables of profiles, vertices of meshes.
std::size_t memoryOf(const std::vector<CasterShape>& shapes);

} // namespace vitrine
