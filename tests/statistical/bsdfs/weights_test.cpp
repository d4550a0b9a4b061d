// Are the weights f cos / pdf right? What is sampled must agree with f() and pdf(), point by point and on average.
#include "bsdf_cases.h"
#include "support/chi_squared.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

constexpr TransportMode modes[] = {TransportMode::Radiance, TransportMode::Importance};

/// Reflected and transmitted share of lane 1, by quadrature of f cos.
double albedo(const Bsdf& bsdf, const V3f& wo, TransportMode mode) {
    return integrateSphere([&](const V3f& wi) { return double(bsdf.f(wo, wi, mode)[1]) * std::abs(wi.z); });
}

TEST(BsdfWeights, SampledValuesAreThoseOfFAndPdf) {
    RandomStream random(5, 1);
    int compared = 0;
    for (const auto& [name, bsdf] : roughCases())
        for (const V3f& wo : outgoingDirections())
            for (TransportMode mode : modes)
                for (int i = 0; i < 200; ++i) {
                    const auto s = draw(bsdf, wo, mode, random);
                    if (!s) continue;
                    ++compared;
                    const SampledSpectrum f = bsdf.f(wo, s->wi, mode);
                    // The halfway vector of f and pdf is formed from rounded directions.
                    EXPECT_NEAR(f[0] / s->f[0], 1, 5e-3) << name << ", wo " << wo << ", wi " << s->wi;
                    EXPECT_NEAR(bsdf.pdf(wo, s->wi, mode) / s->pdf, 1, 5e-3)
                        << name << ", wo " << wo << ", wi " << s->wi;
                    EXPECT_NEAR(s->wi.length(), 1, 1e-5);
                    EXPECT_EQ(s->isReflection(), wo.z * s->wi.z > 0);
                    EXPECT_NE(s->isReflection(), s->isTransmission());
                    EXPECT_FALSE(s->isSpecular());
                    EXPECT_EQ(s->lobes & ~bsdf.lobes(), 0u);
                }
    EXPECT_GT(compared, 50000);
}

TEST(BsdfWeights, TheirMeanIsTheAlbedo) {
    const auto cases = roughCases();
    const auto directions = outgoingDirections();
    const double threshold = sidakThreshold(0.01, int(cases.size() * directions.size()));
    constexpr int samples = 20000;
    std::uint64_t seed = 0;
    for (const auto& [name, bsdf] : cases)
        for (const V3f& wo : directions) {
            const TransportMode mode = ++seed % 2 ? TransportMode::Importance : TransportMode::Radiance;
            RandomStream random(6, seed);
            double sum = 0, squares = 0;
            for (int i = 0; i < samples; ++i) {
                const auto s = draw(bsdf, wo, mode, random);
                const double weight = s ? double(s->f[1]) * std::abs(s->wi.z) / s->pdf : 0;
                sum += weight;
                squares += weight * weight;
            }
            const double expected = albedo(bsdf, wo, mode), mean = sum / samples;
            const double error = std::sqrt(std::max(0., squares / samples - mean * mean) / samples);
            // The quadrature's own error, about 1e-4, counts where the weights hardly vary.
            const double z = (mean - expected) / std::hypot(error, 1e-4 * expected);
            EXPECT_GT(normalPValue(z), threshold)
                << name << ", wo " << wo << ": sampled " << mean << " +- " << error << ", quadrature " << expected;
        }
}

} // namespace
} // namespace vitrine::test
