// Inputs at the edge of what can come: grazing, in the surface, extreme roughness and indices. Nothing may turn into a
// NaN or an infinity, and what is sampled must be usable.
#include "bsdfs/bsdf.h"
#include "core/random.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

std::vector<Bsdf> extremeBsdfs() {
    std::vector<Bsdf> bsdfs = {DiffuseBsdf(SampledSpectrum(1)), DiffuseBsdf(SampledSpectrum(0)),
                               ThinDielectricBsdf(1.5f), ThinDielectricBsdf(0.75f), ThinDielectricBsdf(1)};
    for (float alphaX : {0.f, 1e-4f, 1e-3f, 0.1f, 1.f})
        for (float alphaY : {0.f, 1e-4f, 1e-3f, 1.f}) {
            const TrowbridgeReitz facets(alphaX, alphaY);
            for (float eta : {1e-8f, 0.3f, 0.99989f, 0.9999999f, 1.f, 1.0000001f, 1.00011f, 1.5f, 4.f, 1e8f})
                bsdfs.push_back(DielectricBsdf(eta, facets));
            for (float k : {0.f, 3.f, 200.f})
                bsdfs.push_back(ConductorBsdf(facets, SampledSpectrum(0.1f), SampledSpectrum(k)));
            bsdfs.push_back(ConductorBsdf(facets, SampledSpectrum(0), SampledSpectrum(0)));
        }
    return bsdfs;
}

std::vector<V3f> extremeDirections() {
    std::vector<V3f> result;
    for (float z : {0.f, 1e-45f, 1e-38f, 1e-20f, 1e-10f, 1e-6f, 1e-3f, 0.1f, 0.7f, 0.99999994f, 1.f, 1.0000001f})
        for (float angle : {0.f, 0.4f, 1.5707964f, 3.f})
            for (float side : {1.f, -1.f}) {
                const float r = std::sqrt(std::max(0.f, 1 - z * z));
                result.push_back(V3f(r * std::cos(angle), r * std::sin(angle), side * z));
            }
    return result;
}

bool usable(const SampledSpectrum& f, float pdf) {
    return f.isFinite() && f.min() >= 0 && std::isfinite(pdf) && pdf >= 0;
}

TEST(Extremes, ValuesAndDensitiesAreFinite) {
    const auto directions = extremeDirections();
    for (const Bsdf& bsdf : extremeBsdfs())
        for (const V3f& wo : directions)
            for (const V3f& wi : directions)
                for (TransportMode mode : {TransportMode::Radiance, TransportMode::Importance}) {
                    const SampledSpectrum f = bsdf.f(wo, wi, mode);
                    const float pdf = bsdf.pdf(wo, wi, mode);
                    ASSERT_TRUE(usable(f, pdf)) << wo << wi << " f " << f[0] << " pdf " << pdf;
                    ASSERT_TRUE((wo.z != 0 && wi.z != 0) || (f.isBlack() && pdf == 0)) << wo << wi;
                }
}

TEST(Extremes, SamplesAreUsable) {
    constexpr float last = 0x1.fffffep-1f;
    RandomStream random(4);
    for (const Bsdf& bsdf : extremeBsdfs())
        for (const V3f& wo : extremeDirections())
            for (float uc : {0.f, random.uniform(), last})
                for (float u : {0.f, random.uniform(), last})
                    for (float v : {0.f, random.uniform(), last}) {
                        const auto s = bsdf.sample(wo, uc, V2f(u, v), TransportMode::Radiance);
                        if (!s) continue;
                        ASSERT_NE(wo.z, 0);
                        ASSERT_TRUE(usable(s->f, s->pdf)) << wo << s->wi << " f " << s->f[0] << " pdf " << s->pdf;
                        ASSERT_GT(s->pdf, 0);
                        ASSERT_FALSE(s->f.isBlack());
                        ASSERT_NE(s->wi.z, 0);
                        ASSERT_NEAR(s->wi.length(), 1, 1e-4) << wo << s->wi;
                        ASSERT_EQ(s->isReflection(), wo.z * s->wi.z > 0) << wo << s->wi;
                        const float weight = s->f[0] * std::abs(s->wi.z) / s->pdf;
                        // Radiance grows by 1/eta^2 at most, here 1/0.3^2 going in and 4^2 coming out.
                        ASSERT_LE(weight, 16.01f) << wo << s->wi;
                    }
}

// Narrow lobes lose most: a mirror's weight is the Fresnel factor, and so must be that of facets next to a mirror's.
TEST(Extremes, NarrowLobesApproachTheMirror) {
    const V3f wo = V3f(0.5f, 0.2f, 0.6f).normalized();
    const SampledSpectrum eta(0.2f), k(3.9f);
    const Bsdf rough = ConductorBsdf(TrowbridgeReitz(1e-3f, 1e-3f), eta, k), mirror = ConductorBsdf({}, eta, k);
    RandomStream random(6);
    const auto ideal = mirror.sample(wo, 0, V2f(0, 0), TransportMode::Radiance);
    for (int i = 0; i < 1000; ++i) {
        const float u = random.uniform();
        const auto s = rough.sample(wo, 0, V2f(u, 0.9f * random.uniform()), TransportMode::Radiance);
        ASSERT_TRUE(s);
        EXPECT_NEAR((s->wi - ideal->wi).length(), 0, 0.01);
        EXPECT_NEAR(s->f[0] * s->wi.z / s->pdf, ideal->f[0] * ideal->wi.z, 1e-3);
    }
}

} // namespace
} // namespace vitrine
