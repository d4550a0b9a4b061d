// The layered model against a walk between two planes without its tricks, and f, pdf and sample against each other: all in
// the mean over seeds, as single answers are estimates.
#include "core/sampling.h"
#include "layered_cases.h"
#include "support/chi_squared.h"
#include "support/estimate.h"
#include "support/long_run.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

constexpr int rows = 6, columns = 4, bins = rows * columns;
/// Particles and samples cost less than values, and vary more.
constexpr int draws = 20000, particlesPerDraw = 4;

/// Means over all draws of what falls into each bin of the upper hemisphere, of equal solid angle.
class Histogram {
  public:
    void add(const V3f& w, double value) {
        const double phi = std::atan2(w.y, w.x) / (2 * piD) + 0.5;
        const int row = std::min(int(double(w.z) * rows), rows - 1);
        const int column = std::min(int(phi * columns), columns - 1);
        bins_[std::size_t(row * columns + column)].add(value);
    }
    /// Draws that fell nowhere count as 0 in every bin.
    void countDraw() { ++all_; }
    Estimate bin(int i) const {
        Estimate e = bins_[std::size_t(i)];
        e.n = all_;
        return e;
    }
    Estimate total() const {
        Estimate e;
        for (const Estimate& bin : bins_) {
            e.sum += bin.sum;
            e.sum2 += bin.sum2;
        }
        e.n = all_;
        return e;
    }
    /// As many draws of one value would be as sure (Kish 1965).
    double effective(int i) const {
        const Estimate& e = bins_[std::size_t(i)];
        return e.sum2 > 0 ? sqr(e.sum) / e.sum2 : 0;
    }

  private:
    std::array<Estimate, bins> bins_;
    int all_ = 0;
};

/// The chance that both are of the same expectation: the smaller of bin by bin and as a whole.
double agreement(const Histogram& a, const Histogram& b) {
    double sum = 0;
    int used = 0;
    for (int i = 0; i < bins; ++i) {
        // With fewer the mean of draws is not normal.
        if (a.effective(i) < 50 || b.effective(i) < 50) continue;
        const Estimate x = a.bin(i), y = b.bin(i);
        const double variance = x.varianceOfMean() + y.varianceOfMean();
        if (variance > 0) sum += sqr(x.mean() - y.mean()) / variance, ++used;
    }
    if (used == 0) return 0;
    const Estimate x = a.total(), y = b.total();
    const double z = (x.mean() - y.mean()) / std::sqrt(x.varianceOfMean() + y.varianceOfMean());
    return std::min(chiSquaredPValue(sum, used), normalPValue(z));
}

struct Measurement {
    Histogram oracle, values, weights, samples, densities;
    Estimate oracleSpecular, specular;
};

Measurement measureCase(const LayeredCase& c, const V3f& wo, TransportMode mode, std::uint64_t key, int n) {
    Measurement m;
    RandomStream random(0x6c61796572ull, key);
    for (int i = 0; i < n * particlesPerDraw; ++i) {
        const auto wandered = c.isMetal ? wander(c, c.metal(), wo, random) : wander(c, c.matt(), wo, random);
        m.oracle.countDraw();
        m.oracleSpecular.add(wandered && wandered->specular ? double(wandered->weight[1]) : 0);
        if (wandered && !wandered->specular) m.oracle.add(wandered->wi, double(wandered->weight[1]));

        const auto s = draw(c.bsdf(std::uint32_t(random.bits())), wo, mode, random);
        const double weight = s ? double(s->f[1]) * std::abs(s->wi.z) / s->pdf : 0;
        m.weights.countDraw();
        m.samples.countDraw();
        m.specular.add(s && s->isSpecular() ? weight : 0);
        if (s && !s->isSpecular()) {
            m.weights.add(s->wi, weight);
            m.samples.add(s->wi, 1);
        }
    }
    // One walk now and then answers a hundred times the mean: of four, means of draws are near enough to normal.
    const LayeredCase surer = c.withWalks(4);
    for (int i = 0; i < n; ++i) {
        const Bsdf bsdf = surer.bsdf(std::uint32_t(random.bits()));
        const float u = random.uniform();
        const V3f wi = sampleCosineHemisphere(V2f(u, random.uniform()));
        m.values.countDraw();
        m.densities.countDraw();
        if (inSurface(wi)) continue;
        m.values.add(wi, double(bsdf.f(wo, wi, mode)[1]) * piD);
        m.densities.add(wi, double(bsdf.pdf(wo, wi, mode)) * piD / wi.z);
    }
    return m;
}

TEST(LayeredBsdf, AgreesWithTheWalkWithoutTricks) {
    const auto cases = layeredCases();
    const std::vector<V3f> directions = {directionAt(0, 0), directionAt(40, 25), directionAt(75, 130)};
    // One in a thousand: at 0.01 this very draw fails by a total 4.1 deviations off (densities under the first case's polished
    // coat), which eight times the draws bring to 0.3. A wrong density in a weight of the walks is seen with 1e-8 or less.
    const double threshold = sidakThreshold(0.001, int(cases.size() * directions.size()) * 7);
    const int n = draws * longRun();
    std::uint64_t key = 0;
    for (const LayeredCase& c : cases)
        for (const V3f& wo : directions) {
            const TransportMode mode = ++key % 2 ? TransportMode::Radiance : TransportMode::Importance;
            const Measurement m = measureCase(c, wo, mode, key, n);
            const std::string where = c.name + ", cosine " + std::to_string(wo.z);
            EXPECT_GT(agreement(m.oracle, m.values), threshold) << where << ": f";
            EXPECT_GT(agreement(m.oracle, m.weights), threshold) << where << ": weights of samples";
            EXPECT_GT(agreement(m.samples, m.densities), threshold) << where << ": densities";
            const double variance = m.oracleSpecular.varianceOfMean() + m.specular.varianceOfMean();
            const double apart = m.oracleSpecular.mean() - m.specular.mean();
            // Where nothing varies both are the same number.
            EXPECT_GT(normalPValue(apart / std::max(std::sqrt(variance), 1e-6)), threshold) << where << ": delta lobe";
        }
}

TEST(LayeredBsdf, SamplesNeverGainAndAnswersStayTheSame) {
    RandomStream random(77, 1);
    for (const LayeredCase& c : layeredCases())
        for (const V3f& wo : outgoingDirections())
            for (int i = 0; i < 300; ++i) {
                const Bsdf bsdf = c.bsdf(std::uint32_t(random.bits()));
                const auto mode = i % 2 ? TransportMode::Radiance : TransportMode::Importance;
                const auto s = draw(bsdf, wo, mode, random);
                if (!s) continue;
                EXPECT_LE((s->f * (std::abs(s->wi.z) / s->pdf)).max(), 1 + 1e-4f) << c.name << ", wo " << wo;
                EXPECT_NEAR(s->wi.length(), 1, 1e-4);
                EXPECT_TRUE(s->isReflection() && s->wi.z * wo.z > 0);
                EXPECT_EQ(s->lobes & ~bsdf.lobes(), 0u) << c.name;
                if (s->isSpecular()) continue;
                EXPECT_EQ(bsdf.pdf(wo, s->wi, mode), s->pdf) << c.name;
                EXPECT_EQ(bsdf.f(wo, s->wi, mode)[0], bsdf.f(wo, s->wi, mode)[0]);
                EXPECT_TRUE(bsdf.f(wo, s->wi, mode).isFinite());
                EXPECT_TRUE(bsdf.f(wo, -s->wi, mode).isBlack()) << "nothing passes";
                EXPECT_EQ(bsdf.pdf(wo, -s->wi, mode), 0);
            }
}

// Both sides are alike, and importance and radiance travel the same ways.
TEST(LayeredBsdf, IsReciprocalInTheMean) {
    const auto cases = layeredCases();
    const std::vector<std::pair<V3f, V3f>> pairs = {{directionAt(20, 10), directionAt(60, 170)},
                                                    {directionAt(70, -30), directionAt(45, 120)},
                                                    {directionAt(110, 0), directionAt(150, 200)}};
    const double threshold = sidakThreshold(0.01, int(cases.size() * pairs.size()) * 2);
    std::uint64_t key = 0;
    for (const LayeredCase& c : cases)
        for (const auto& [wo, wi] : pairs) {
            RandomStream random(78, ++key);
            Estimate there, back, importance;
            for (int i = 0; i < 20000 * longRun(); ++i) {
                // Seeds of their own: with common ones the three would not be independent.
                there.add(double(c.bsdf(std::uint32_t(random.bits())).f(wo, wi, TransportMode::Radiance)[1]));
                back.add(double(c.bsdf(std::uint32_t(random.bits())).f(wi, wo, TransportMode::Radiance)[1]));
                importance.add(double(c.bsdf(std::uint32_t(random.bits())).f(wo, wi, TransportMode::Importance)[1]));
            }
            for (const Estimate& other : {back, importance}) {
                const double error = std::sqrt(there.varianceOfMean() + other.varianceOfMean());
                const double apart = there.mean() - other.mean();
                EXPECT_GT(normalPValue(apart / std::max(error, 1e-5 * there.mean() + 1e-12)), threshold)
                    << c.name << ", wo " << wo << ", wi " << wi << ": " << there.mean() << ", " << other.mean();
            }
        }
}

/// What comes back of light that the base reflects all of, and its standard error.
Estimate whiteAlbedo(const DielectricBsdf& coat, const CoatMedium& medium, const V3f& wo) {
    Estimate e;
    RandomStream random(79, medium.maxDepth);
    for (int i = 0; i < 40000; ++i) {
        const Bsdf bsdf =
            CoatedDiffuseBsdf(coat, DiffuseBsdf(SampledSpectrum(1)), medium, std::uint32_t(random.bits()));
        const auto s = draw(bsdf, wo, i % 2 ? TransportMode::Radiance : TransportMode::Importance, random);
        e.add(s ? double(s->f[2]) * std::abs(s->wi.z) / s->pdf : 0);
    }
    return e;
}

TEST(LayeredEnergy, PolishedCoatOverWhiteLosesNothing) {
    for (const CoatMedium& medium : {coatMedium(0, 0, 0, 2000), coatMedium(1, 1, 0.5f, 2000)})
        for (const V3f& wo : outgoingDirections())
            EXPECT_NEAR(whiteAlbedo(DielectricBsdf(1.5f), medium, wo).mean(), 1, 1e-4) << "wo " << wo;
}

// maxdepth n keeps (n + 1) / 2 reflections at the base: what is reflected back once more is lost, as in pbrt-v4.
TEST(LayeredEnergy, LossByMaxdepthIsThatOfTheSeries) {
    const double inside = integrateRectangle(
        [](double cosine, double) { return 2 * cosine * fresnelDielectric(float(cosine), 1 / 1.5f).reflectance; },
        V2d(0, 0), V2d(1, 1));
    for (const V3f& wo : {directionAt(0, 0), directionAt(70, 20)})
        for (int depth : {1, 2, 3, 10}) {
            const double entered = 1 - fresnelDielectric(wo.z, 1.5f).reflectance;
            const double expected = 1 - entered * std::pow(inside, (depth + 1) / 2);
            const Estimate e = whiteAlbedo(DielectricBsdf(1.5f), coatMedium(0, 0, 0, depth), wo);
            // 1e-3: adaptive quadrature across the critical angle.
            EXPECT_NEAR(e.mean(), expected, 5 * std::sqrt(e.varianceOfMean()) + 1e-3) << depth;
            RecordProperty("white under index 1.5, maxdepth " + std::to_string(depth) + ", cosine " +
                               std::to_string(wo.z),
                           std::to_string(e.mean()));
        }
}

// A rough coat loses what would scatter again between its own facets, each time that it is met: the first loss alone is a
// bound.
TEST(LayeredEnergy, RoughCoatsLoseWhatTheirFacetsDo) {
    for (float alpha : {0.1f, 0.3f, 0.6f, 1.f})
        for (const V3f& wo : {directionAt(0, 0), directionAt(60, 20), directionAt(85, 20)}) {
            const DielectricBsdf coat(1.5f, TrowbridgeReitz(alpha, alpha));
            const Estimate e = whiteAlbedo(coat, coatMedium(0, 0, 0, 2000), wo);
            const double coatAlone = integrateSphere(
                [&](const V3f& wi) { return double(coat.f(wo, wi, TransportMode::Importance)[0]) * std::abs(wi.z); });
            EXPECT_LE(e.mean(), coatAlone + 5 * std::sqrt(e.varianceOfMean()) + 1e-3) << alpha << ", wo " << wo;
            EXPECT_GT(e.mean(), 0.25) << alpha << ", wo " << wo;
            RecordProperty("white under index 1.5, coat alpha " + nameOf(V2f(alpha, alpha)) + ", cosine " +
                               std::to_string(wo.z),
                           std::to_string(e.mean()));
        }
}

} // namespace
} // namespace vitrine::test
