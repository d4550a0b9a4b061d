// Do samples fall as pdf() says? Every BSDF that is not a mirror, from both sides, in both modes.
#include "bsdf_cases.h"
#include "support/chi_squared.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

TEST(BsdfChiSquared, SamplesFollowThePdf) {
    const auto cases = roughCases();
    const auto directions = outgoingDirections();
    const double threshold = sidakThreshold(0.01, int(cases.size() * directions.size()));
    std::uint64_t seed = 0;
    for (const auto& [name, bsdf] : cases)
        for (const V3f& wo : directions) {
            const TransportMode mode = ++seed % 2 ? TransportMode::Radiance : TransportMode::Importance;
            const auto sample = [&](RandomStream& random) -> std::optional<V3f> {
                const auto s = draw(bsdf, wo, mode, random);
                return s ? std::optional(s->wi) : std::nullopt;
            };
            const auto pdf = [&](const V3f& wi) { return bsdf.pdf(wo, wi, mode); };
            const auto result = chiSquaredSphere(sample, pdf, {.seed = seed});
            EXPECT_GT(result.pValue, threshold) << name << ", wo " << wo << ": " << result.report;
            EXPECT_GT(result.dof, 5) << name << ", wo " << wo;
        }
}

// Lobes too narrow for cells on the sphere: the slopes of the halfway vectors, in units of the roughness.
TEST(BsdfChiSquared, NarrowLobesFollowThePdfInSlopes) {
    const std::vector<V2f> alphas = {{1e-3f, 1e-3f}, {5e-3f, 5e-3f}, {1e-4f, 0.02f}, {0.2f, 1e-3f}};
    const std::vector<V3f> directions = {directionAt(0, 0), directionAt(50, 30), directionAt(150, 70)};
    const double threshold = sidakThreshold(0.01, int(alphas.size() * directions.size()));
    for (const V2f& alpha : alphas)
        for (const V3f& wo : directions) {
            const TrowbridgeReitz facets(alpha.x, alpha.y);
            // (s, t) in (0,1)^2 -> slope = alpha tan(pi (s - 1/2)); d(slope)/ds = alpha pi (1 + tan^2).
            const auto sample = [&](RandomStream& random) -> std::optional<V2f> {
                const float u = random.uniform();
                const V3f m = facets.sampleVisible(wo, V2f(u, random.uniform()));
                return V2f(float(std::atan(m.x / (m.z * alpha.x)) / piD + 0.5),
                           float(std::atan(m.y / (m.z * alpha.y)) / piD + 0.5));
            };
            const auto pdf = [&](const V2f& st) {
                const double x = std::tan(piD * (st.x - 0.5)), y = std::tan(piD * (st.y - 0.5));
                const V3d slope(x * alpha.x, y * alpha.y, 1);
                const V3f m = toFloat(slope / slope.length());
                // Facets turned away are not seen, though the density's |w.m| does not say so: sampleVisible never
                // returns them.
                if (wo.dot(m) * wo.z <= 0) return 0.;
                const double solidAngle = std::pow(double(m.z), 3);
                return facets.visiblePdf(wo, m) * solidAngle * alpha.x * alpha.y * sqr(piD) * (1 + x * x) * (1 + y * y);
            };
            const auto result = chiSquaredSquare(sample, pdf, {.rows = 20, .columns = 20, .seed = 77});
            EXPECT_GT(result.pValue, threshold) << nameOf(alpha) << ", wo " << wo << ": " << result.report;
            EXPECT_NEAR(result.mass, 1, 2e-3) << nameOf(alpha) << ", wo " << wo;
        }
}

} // namespace
} // namespace vitrine::test
