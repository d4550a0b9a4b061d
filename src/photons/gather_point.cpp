#include "photons/gather_point.h"

namespace vitrine {

namespace {

/// How far a point may leave its surface by `step`: all of the way, or half of the way to what lies there.
double freeShare(const World& world, const V3d& from, const V3d& step, double time, double offset) {
    const double first = offset / step.length(); // off the surface itself
    if (!(first < 1)) return 1;
    CasterHit hit;
    if (!world.caster->intersect(Ray{from + step * first, step, 1 - first, time}, hit)) return 1;
    return (first + hit.s) / 2;
}

/// Whether the photon sees the disk's centre along the surface, on the side that it came from.
bool seen(const World& world, const PhotonSpace& space, const GatherDisk& disk, const Photon& photon, double time) {
    const V3f apart = photon.p() - disk.center;
    const float side = photon.w().dot(disk.normal) < 0 ? -1.f : 1.f;
    const float distance = apart.length();
    if (!(distance > 0)) return true;
    // Where a surface falls away by x between two points it bulges by x / 4 above the line between them.
    constexpr float leastLift = 1 / 64.f;
    const float lift = std::abs(apart.dot(disk.normal)) + leastLift * distance;
    const V3d up = toDouble(disk.normal * (side * lift));
    // The photon's end of the line lies off its own surface too, the way it came: a sheet without thickness has two sides.
    const V3d off = up + toDouble(photon.w() * (leastLift * distance));
    const V3d center = space.toWorld(disk.center), place = space.toWorld(photon.p());
    // A solid may stand closer than that: both ends stay in the gap before it, lest its own surface hide one from the other.
    const double share = std::min(freeShare(world, center, up, time, space.resolution(disk.center)),
                                  freeShare(world, place, off, time, space.resolution(photon.p())));
    const V3d from = center + up * share;
    return !world.caster->occluded(Ray{from, place + off * share - from, 1, time});
}

/// 0 below `from`, 1 above `to`, smooth between.
float rise(float x, float from, float to) {
    const float t = std::clamp((x - from) / (to - from), 0.f, 1.f);
    return t * t * (3 - 2 * t);
}

} // namespace

float gatherProbability(const Bsdf& bsdf, LightHistory history) {
    if (!bsdf.isNonSpecular()) return 0;
    const float roughness = bsdf.roughness();
    switch (history) {
    case LightHistory::Scattered:
        return rise(roughness, 0.15f, 0.45f);
    case LightHistory::Caustic:
        return rise(roughness, 0.02f, 0.1f);
    case LightHistory::Hidden:
        break;
    }
    return 1;
}

SampledSpectrum Gatherer::contribution(const GatherPoint& point, const V3f& wo, const Photon& photon, float distance2,
                                       float radius2) const {
    if (point.depth + 1 + photon.depth() > maxDepth || photon.history() < point.from) return SampledSpectrum(0.f);
    const V3f w = photon.w(), wi = point.frame.toLocal(w);
    // On the other side of its own surface: of a thin solid through which light passes it landed on the other face.
    if ((point.bsdf.lobes() & lobe::transmission) && photon.front() != (w.dot(point.disk.normal) > 0))
        return SampledSpectrum(0.f);
    const SampledSpectrum f = point.bsdf.f(wo, wi, TransportMode::Radiance);
    // Photons lie as densely as the geometric cosine says; the light reflected goes by the shading cosine.
    constexpr float grazing = 1e-2f; // bounds what a single photon can do
    const float cosines = std::abs(wi.z) / std::max(absDot(w, point.disk.normal), grazing);
    return f * rotated(photon.power(), point.hero) * (cosines * kernelShape(kernel, distance2, radius2));
}

SampledSpectrum Gatherer::light(const World& world, const PhotonSpace& space, const GatherPoint& point,
                                const GatherDisk& disk, std::span<const Photon> photons,
                                std::span<const NearPhoton> near, float u) const {
    const V3f wo = point.frame.toLocal(point.wo);
    const float radius2 = disk.radius2();
    SampledSpectrum sum(0.f);
    float weights = 0;
    std::uint32_t chosen = 0;
    for (const NearPhoton& n : near) {
        const SampledSpectrum c = contribution(point, wo, photons[n.index], n.distance2, radius2);
        const float weight = c.average();
        if (!(weight > 0)) continue;
        sum += c;
        weights += weight;
        // Reservoir of one (Chao 1982): each is kept with its share, and the number is stretched to be used again.
        const float share = weight / weights;
        if (u < share) {
            chosen = n.index;
            u /= share;
        } else {
            u = (u - share) / (1 - share);
        }
    }
    if (!(weights > 0) || !seen(world, space, disk, photons[chosen], time)) return SampledSpectrum(0.f);
    return sum * point.beta / (pi * radius2 * float(paths));
}

} // namespace vitrine
