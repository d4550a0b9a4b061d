// Energy and symmetry: nothing gains, mirrors lose nothing, and swapping the directions changes what theory says.
#include "bsdf_cases.h"
#include "support/chi_squared.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

/// Reflected and transmitted share of flux arriving from wo (importance: no eta^2).
double flux(const Bsdf& bsdf, const V3f& wo) {
    return integrateSphere(
        [&](const V3f& wi) { return double(bsdf.f(wo, wi, TransportMode::Importance)[0]) * std::abs(wi.z); });
}

// Lossless metal of alpha 1 seen straight on keeps the least: with x = cos(wi), the integral of x / (1 + x) over [0, 1].
const double leastAlbedo = 1 - std::log(2.);

TEST(BsdfEnergy, RoughestMetalStraightOn) {
    EXPECT_NEAR(flux(losslessCase(V2f(1, 1)).bsdf, V3f(0, 0, 1)), leastAlbedo, 1e-4);
}

TEST(BsdfEnergy, RoughSurfacesGainNothing) {
    for (const V2f& alpha : roughnesses())
        for (const V3f& wo : outgoingDirections())
            for (const auto& [name, bsdf] : {losslessCase(alpha), dielectricCase(1.5f, alpha),
                                             dielectricCase(1 / 1.5f, alpha), dielectricCase(2.4f, alpha)}) {
                const double total = flux(bsdf, wo);
                EXPECT_LE(total, 1 + 2e-4) << name << ", wo " << wo;
                EXPECT_GT(total, leastAlbedo - 1e-3) << name << ", wo " << wo;
            }
}

/// Smith's Lambda in the textbook's form (Heitz 2014, eq. 72 and 80).
double lambda(const V3d& w, const V2d& alpha) {
    const double tan2 = (w.x * w.x + w.y * w.y) / (w.z * w.z);
    const double phi = std::atan2(w.y, w.x);
    return (std::sqrt(1 + tan2 * (sqr(alpha.x * std::cos(phi)) + sqr(alpha.y * std::sin(phi)))) - 1) / 2;
}

// What scatters a second time between facets is lost. The share that is kept, as an integral over the facets in the
// textbook's formulas: of D(m) (wo.m) / cos(wo) G2(wo, wi), where wi is above the horizon.
TEST(BsdfEnergy, LossOfARoughMetalIsThatOfTheTextbook) {
    for (const V2f& a : roughnesses())
        for (const V3f& direction : {directionAt(0, 0), directionAt(50, 30), directionAt(80, 100)}) {
            const V2d alpha(a.x, a.y);
            const V3d wo = toDouble(direction);
            const double expected = integrateSphere([&](const V3f& facet) {
                const V3d m = toDouble(facet);
                if (m.z <= 0 || wo.dot(m) <= 0) return 0.;
                const V3d wi = m * (2 * wo.dot(m)) - wo;
                if (wi.z <= 0) return 0.;
                const double tan2 = (m.x * m.x + m.y * m.y) / (m.z * m.z), phi = std::atan2(m.y, m.x);
                const double e = tan2 * (sqr(std::cos(phi) / alpha.x) + sqr(std::sin(phi) / alpha.y));
                const double d = 1 / (piD * alpha.x * alpha.y * sqr(sqr(m.z)) * sqr(1 + e));
                return d * wo.dot(m) / wo.z / (1 + lambda(wo, alpha) + lambda(wi, alpha));
            });
            const double kept = flux(losslessCase(a).bsdf, direction);
            EXPECT_NEAR(kept, expected, 1e-3) << nameOf(a) << ", wo " << direction;
            RecordProperty("albedo " + nameOf(a) + " at cosine " + std::to_string(direction.z), std::to_string(kept));
        }
}

TEST(BsdfEnergy, MirrorsAndPolishedGlassLoseNothing) {
    const std::vector<NamedBsdf> cases = {losslessCase(V2f(0, 0)),
                                          dielectricCase(1.5f, V2f(0, 0)),
                                          dielectricCase(0.7f, V2f(0, 0)),
                                          dielectricCase(1, V2f(0.5f, 0.5f)),
                                          {"thin", ThinDielectricBsdf(1.5f)}};
    RandomStream random(8, 8);
    for (const auto& [name, bsdf] : cases)
        for (const V3f& wo : outgoingDirections())
            for (int i = 0; i < 50; ++i) {
                const auto s = draw(bsdf, wo, TransportMode::Importance, random);
                ASSERT_TRUE(s) << name << ", wo " << wo;
                EXPECT_TRUE(s->isSpecular());
                for (int lane = 0; lane < spectrumSamples; ++lane)
                    EXPECT_NEAR(s->f[lane] * std::abs(s->wi.z) / s->pdf, 1, 1e-6) << name << ", wo " << wo;
            }
}

TEST(BsdfSymmetry, ReflectionIsReciprocalAndRefractionScalesByEtaSquared) {
    RandomStream random(9, 9);
    int reflected = 0, refracted = 0;
    for (const auto& [name, bsdf] : roughCases())
        for (int i = 0; i < 2000; ++i) {
            const V3f wo = directionAt(random.uniform(0, 180), random.uniform(0, 360));
            const V3f wi = directionAt(random.uniform(0, 180), random.uniform(0, 360));
            const float there = bsdf.f(wo, wi, TransportMode::Radiance)[0];
            const float back = bsdf.f(wi, wo, TransportMode::Radiance)[0];
            const float importance = bsdf.f(wo, wi, TransportMode::Importance)[0];
            EXPECT_NEAR(importance, back, 2e-3f * back + 1e-6f) << name << ", wo " << wo << ", wi " << wi;
            if (wo.z * wi.z > 0) {
                EXPECT_NEAR(there, back, 2e-3f * back + 1e-6f) << name << ", wo " << wo << ", wi " << wi;
                reflected += there > 0;
            } else {
                refracted += there > 0;
            }
        }
    EXPECT_GT(reflected, 10000);
    EXPECT_GT(refracted, 5000);
}

} // namespace
} // namespace vitrine::test
