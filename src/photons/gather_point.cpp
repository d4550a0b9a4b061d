#include "photons/gather_point.h"

namespace vitrine {

SampledSpectrum gatheredLight(const GatherPoint& point, std::span<const Photon> photons,
                              std::span<const NearPhoton> near, float radius, Kernel kernel, std::uint64_t paths,
                              int maxDepth) {
    const V3f wo = point.frame.toLocal(point.wo);
    const V3f& ng = point.disk.normal;
    const float radius2 = sqr(radius);
    SampledSpectrum sum(0.f);
    for (const NearPhoton& n : near) {
        const Photon& photon = photons[n.index];
        if (point.depth + 1 + photon.depth() > maxDepth) continue;
        const V3f w = photon.w(), wi = point.frame.toLocal(w);
        const SampledSpectrum f = point.bsdf.f(wo, wi, TransportMode::Radiance);
        if (f.isBlack()) continue;
        // Photons lie as densely as the geometric cosine says; the light reflected goes by the shading cosine.
        constexpr float grazing = 1e-2f; // bounds what a single photon can do
        const float cosines = std::abs(wi.z) / std::max(absDot(w, ng), grazing);
        sum += f * rotated(photon.power(), point.hero) * (cosines * kernelShape(kernel, n.distance2, radius2));
    }
    return sum * point.beta / (pi * radius2 * float(paths));
}

} // namespace vitrine
