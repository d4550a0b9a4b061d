#include "lights/light_bounds.h"

namespace vitrine {

namespace {

/// Cosines are taken for so much more than they are, so that no rounding hides a light that shines: a cosine near 1 tells
/// the angle, and with it the sine, no better than to some 4e-4.
constexpr float slack = 1e-3f;
/// Nearer than this, squared, all is alike: numbers stay finite.
constexpr double leastDistance2 = 1e-280;

struct Angle {
    float cos, sin;

    static Angle ofCos(float c) {
        c = std::clamp(c, -1.f, 1.f);
        return {c, safeSqrt(1 - c * c)};
    }
    /// The difference, but not less than none.
    Angle less(const Angle& other) const {
        if (cos >= other.cos) return {1, 0};
        return {cos * other.cos + sin * other.sin, sin * other.cos - cos * other.sin};
    }
};

} // namespace

LightBounds unite(const LightBounds& a, const LightBounds& b) {
    LightBounds both = a;
    both.box.extendBy(b.box);
    both.normals = unite(a.normals, b.normals);
    both.cosReach = std::min(a.cosReach, b.cosReach);
    both.twoSided |= b.twoSided;
    both.intensity += b.intensity;
    return both;
}

LightImportance::LightImportance(const LightBounds& bounds)
    : center_(bounds.box.center()), radius2_(bounds.box.size().length2() / 4), intensity_(bounds.intensity),
      axis_(toFloat(bounds.normals.axis)), cosNormals_(float(bounds.normals.cosAngle)),
      sinNormals_(safeSqrt(1 - cosNormals_ * cosNormals_)), cosReach_(float(bounds.cosReach)),
      twoSided_(bounds.twoSided) {}

double LightImportance::at(const LightReceiver& receiver) const {
    const V3d toCenter = center_ - receiver.p;
    const double distance2 = toCenter.length2();
    // Within the sphere light may come from anywhere, and it is as near as the lights lie apart.
    if (distance2 <= radius2_) return radius2_ > 0 ? intensity_ / std::max(radius2_, leastDistance2) : 0;
    const V3f w = toFloat(toCenter * (1 / std::sqrt(distance2)));
    const float sinSeen2 = float(radius2_ / distance2);
    const Angle seen{safeSqrt(1 - sinSeen2), std::sqrt(sinSeen2)};
    double importance = intensity_ / std::max(distance2, leastDistance2);
    if (cosNormals_ > -1) {
        const float cosAxis = -axis_.dot(w);
        const Angle off = Angle::ofCos(twoSided_ ? std::abs(cosAxis) : cosAxis);
        const float c = off.less({cosNormals_, sinNormals_}).less(seen).cos + slack;
        if (c <= cosReach_) return 0;
        importance *= std::max(c, slack);
    }
    if (receiver.n.x != 0 || receiver.n.y != 0 || receiver.n.z != 0) {
        const float c = Angle::ofCos(receiver.n.dot(w)).less(seen).cos + slack;
        if (c <= 0) return 0;
        importance *= c;
    }
    return importance;
}

} // namespace vitrine
