// The double ray beside Embree's single-precision one, and the way between their distances.
#pragma once

#include "accel/embree_device.h"
#include "accel/instance.h"

#include <span>

namespace vitrine::embree {

/// Bits of a geometry's and a ray's mask.
inline constexpr unsigned maskAll = 1, maskShadow = 2;

/// Relative slack of Embree's distances: what is nearer than this to another surface is told apart in double.
inline constexpr double distanceSlack = 0x1p-20;

/// One primitive as Embree's tables know it.
struct PrimitiveRef {
    const Shape* shape = nullptr;
    std::uint32_t id = 0;
    std::uint32_t prim = 0;
    /// The second triangle of a quad that was split: its (u,v) count from the far corner.
    std::uint32_t farHalf : 1 = 0;
    /// Which of Group::coincident() lies in the same place, if any; else 0.
    std::uint32_t rivals : 31 = 0;
    const Cutout* cutout = nullptr; ///< null: no holes
};

/// A ray under way. Embree hands it to the callbacks as its context.
struct Query {
    RTCIntersectContext context; ///< must be the first member
    const Ray* ray = nullptr;
    std::span<const Placed> placed;
    std::uint32_t firstInstance = 0; ///< Embree's number of instance 0
    CasterHit* best = nullptr;       ///< null when only occlusion is asked
    /// Embree's distance t is (s - start) * scale; both are chosen so that it neither overflows nor loses digits.
    double start = 0, scale = 1;
    double originSlack = 0; ///< bound of what rounding the origin does to t, seen along the ray
    /// Of a shadow ray: its end in Embree's distances, and what rounding does to those of surfaces across the ray.
    float end = infinity, endSlack = 0;

    float farEnd(double s) const {
        const double t = ((s - start) * scale + originSlack) * (1 + distanceSlack);
        return t < std::numeric_limits<float>::max() ? float(t) : infinity;
    }
    /// The s that a hit at Embree's t surely does not exceed.
    double upperEnd(float t) const { return (t * (1 + distanceSlack) + originSlack) / scale + start; }

    std::uint32_t instanceOf(unsigned instID) const {
        return instID == RTC_INVALID_GEOMETRY_ID ? CasterHit::noInstance : instID - firstInstance;
    }
    /// The double ray in the instance's space; kept, since a group's primitives come one after the other.
    const Ray& rayIn(std::uint32_t instance) {
        if (instance == CasterHit::noInstance) return *ray;
        if (instance != cachedInstance_) {
            cachedInstance_ = instance;
            cachedRay_ = placed[instance].toInstance(*ray);
        }
        return *cachedRay_;
    }

  private:
    std::uint32_t cachedInstance_ = CasterHit::noInstance;
    std::optional<Ray> cachedRay_; ///< left alone where there are no instances
};

} // namespace vitrine::embree
