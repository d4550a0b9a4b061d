// The oracles and the judge of crossings: they must see what is planted.
#include "support/newton2018.h"
#include "support/revolution_band.h"
#include "support/revolution_cases.h"
#include "support/revolution_exact.h"
#include "support/revolution_slow.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

constexpr double band = 1e-9;

std::vector<OracleHit> without(std::vector<OracleHit> hits, std::size_t first, std::size_t count) {
    hits.erase(hits.begin() + long(first), hits.begin() + long(first + count));
    return hits;
}

Judgement judged(const ProfilePoints& profile, const Ray& ray, const std::vector<OracleHit>& ours,
                 double phiMax = 360) {
    return judge(profile, phiMax, ray, ExactOracle(profile).hits(ray), ours, band);
}

const ProfilePoints pipe{{{1, 0}, {1, 2}}};
const Ray acrossGoblet{{-3, 0.9, 0.1}, {1, 0.01, 0}};

TEST(RevolutionOracle, KnownCrossings) {
    const ProfilePoints can{{{0, 0}, {1, 0}}, {{1, 0}, {1, 2}}, {{1, 2}, {0, 2}}};
    struct Case {
        Ray ray;
        std::vector<double> expected;
    };
    const Case cases[] = {{{{-3, 1, 0}, {1, 0, 0}}, {2, 4}},          {{{-3, 1, 0}, {1, 1e-9, 0}}, {2, 4}},
                          {{{0.5, -3, 0.25}, {0, 2, 0}}, {1.5, 2.5}}, {{{0, -3, 0}, {0, 1, 0}}, {3, 5}},
                          {{{-2, 1, 0}, {1, 0.25, 0}}, {1, 3}},       {{{-3, 1, 1.5}, {1, 0, 0}}, {}}};
    const ExactOracle exact(can);
    const SlowSolver slow(can);
    for (const Case& c : cases)
        for (const std::vector<OracleHit>& hits : {exact.hits(c.ray), slow.hits(c.ray)}) {
            ASSERT_EQ(hits.size(), c.expected.size()) << c.ray.o << c.ray.d;
            for (std::size_t i = 0; i < hits.size(); ++i)
                EXPECT_NEAR(hits[i].s, c.expected[i], 1e-15) << c.ray.o << c.ray.d;
        }
}

TEST(RevolutionOracle, RootsThatDoubleCannotPart) {
    // x(t) bulges by 2^-53, half of what a double next to 1 can say.
    const ExactOracle wall(ProfilePoints{{{1, -1}, {1 + 0x1p-52, 0}, {1, 1}}});
    EXPECT_EQ(wall.hits({{1, -3, 0}, {0, 1, 0}}).size(), 2u);
    EXPECT_EQ(wall.hits({{1 + 0x1p-52, -3, 0}, {0, 1, 0}}).size(), 0u);
    // y(t) rises by 2^-53 between its ends: a ray that climbs 2^-60 a unit goes in and out twice.
    const ExactOracle dome(ProfilePoints{{{0.2, 1}, {0.5, 1 + 0x1p-52}, {0.8, 1}}});
    EXPECT_EQ(dome.hits({{0.5, 5, 0}, {0, -1, 0}}).size(), 1u);
    EXPECT_EQ(dome.hits({{-3, 1, 0}, {1, 0x1p-60, 0}}).size(), 4u);
    EXPECT_EQ(dome.hits({{-3, 1, 0}, {1, 0x1p-53, 0}}).size(), 0u);
}

TEST(RevolutionJudge, PlantedErrorsAreFound) {
    const ProfilePoints goblet = gobletProfile();
    const std::vector<OracleHit> exact = ExactOracle(goblet).hits(acrossGoblet);
    ASSERT_EQ(exact.size(), 4u);
    EXPECT_TRUE(judged(goblet, acrossGoblet, exact).isClean());
    EXPECT_FALSE(judged(goblet, acrossGoblet, exact).excused);
    EXPECT_EQ(judged(goblet, acrossGoblet, without(exact, 1, 1)).missed, 1);
    EXPECT_EQ(judged(goblet, acrossGoblet, without(exact, 0, 2)).missed, 2);
    EXPECT_EQ(judged(goblet, acrossGoblet, {}).missed, 4);
    std::vector<OracleHit> doubled = exact;
    doubled.push_back(exact[2]);
    EXPECT_EQ(judged(goblet, acrossGoblet, doubled).spurious, 1);
    doubled.push_back(exact[2]);
    EXPECT_EQ(judged(goblet, acrossGoblet, doubled).spurious, 2) << "three times what is no touch";
    std::vector<OracleHit> moved = exact;
    moved[1].t += 1e-6;
    EXPECT_EQ(judged(goblet, acrossGoblet, moved).missed, 1);
    EXPECT_EQ(judged(goblet, acrossGoblet, moved).spurious, 1);
}

TEST(RevolutionJudge, OnlyTouchesWithinTheBandAreExcused) {
    for (const double depth : {1e-12, 5e-10, 2e-9, 1e-6}) {
        const Ray ray{{1 - depth, -0.5, -3}, {0, 0.5, 1}};
        const std::vector<OracleHit> exact = ExactOracle(pipe).hits(ray);
        ASSERT_EQ(exact.size(), 2u) << depth;
        EXPECT_EQ(judged(pipe, ray, {}).excused, depth < band) << depth;
        EXPECT_EQ(judged(pipe, ray, {}).missed, depth < band ? 0 : 2) << depth;
        EXPECT_EQ(judged(pipe, ray, without(exact, 0, 1)).missed, 1) << "one of a pair is never excused: " << depth;
    }
}

/// Where the ray is closest to the axis both its halves touch the flat top; the profile goes there only after a turn away.
TEST(RevolutionJudge, TouchesOfBothHalvesAreOneWhereverTheyMeet) {
    // y = 1 - t^12; x(t) rises from 0.2 to 0.67 at t = 0.06, and falls.
    ProfilePoints top{{}, {{0.5, 0}, {0.2, 1}}};
    for (const double x : {0.2, 2.0, -1.5, 1.2, 0.4, 0.6, 0.6, 0.6, 0.6, 0.6, 0.6, 0.6})
        top[0].emplace_back(x, 1);
    top[0].emplace_back(0.5, 0);
    const Ray ray{{-3, 1, 0.3}, {1, 0, 0}};
    ASSERT_TRUE(ExactOracle(top).hits(ray).empty());
    const SlowCurve::Sample at = SlowCurve(top[0]).at(0.1L);
    const auto wide = double(std::sqrt(at.x * at.x - 0.09L));
    const std::vector<OracleHit> both{{3 - wide, 0, 0.1, false}, {3 + wide, 0, 0.1, true}};
    EXPECT_TRUE(judged(top, ray, both).isClean());
    EXPECT_TRUE(judged(top, ray, both).excused);
    EXPECT_EQ(judged(top, ray, without(both, 0, 1)).spurious, 1) << "one of a pair";
    // Seen from 2e-9 above it is no touch.
    EXPECT_EQ(judged(top, {{-3, 1 + 2e-9, 0.3}, {1, 0, 0}}, both).spurious, 2);
}

/// A wall that turns back upon itself just beyond the tip: its two sheets are met on one half of the ray, and hang together
/// by way of the other.
TEST(RevolutionJudge, ATouchOfAFoldedWallIsOne) {
    const double x = 0.75;
    const ProfilePoints wall{{{x, 0.4}, {x, 0}, {x, 0.4}}}; // turns at y = 0.2, t = 0.5
    const auto rayAt = [&](double depth) { return Ray{{x - depth, 0.2 + 1e-6, 0}, {0, -1, 0x1p-9}}; };
    const Ray ray = rayAt(0x1p-53);
    const std::vector<OracleHit> exact = ExactOracle(wall).hits(ray);
    ASSERT_EQ(exact.size(), 2u);
    EXPECT_EQ(exact[0].forward, exact[1].forward);
    EXPECT_TRUE(judged(wall, ray, {}).isClean());
    EXPECT_TRUE(judged(wall, ray, {}).excused);
    EXPECT_EQ(judged(wall, ray, without(exact, 0, 1)).missed, 1) << "one of a pair";
    const Ray deeper = rayAt(2e-9);
    EXPECT_EQ(judged(wall, deeper, {}).missed, int(ExactOracle(wall).hits(deeper).size()));
}

TEST(RevolutionJudge, RimsAreExcusedWithinTheBand) {
    for (const double aside : {1e-10, 1e-8}) {
        const Ray ray{{-1 - 3, 2 - aside - 3, 0}, {1, 1, 0}}; // at the upper ring from within, coming up
        const std::vector<OracleHit> exact = ExactOracle(pipe).hits(ray);
        ASSERT_GE(exact.size(), 1u);
        EXPECT_EQ(judged(pipe, ray, {}).missed, aside < band ? 0 : int(exact.size())) << aside;
        // phimax 180 keeps z >= 0: the ray passes beside that edge.
        const Ray edge{{-3, 1, aside}, {1, 0.01, 0}};
        EXPECT_EQ(judged(pipe, edge, {}, 180).missed, aside < band ? 0 : 2) << aside;
    }
}

TEST(Newton2018, FindsASphereAndMissesRootsOfHighDegree) {
    constexpr double k = 0.5522847498307936;
    const ProfilePoints ball{{{0, -1}, {k, -1}, {1, -k}, {1, 0}}, {{1, 0}, {1, k}, {k, 1}, {0, 1}}};
    const Newton2018 newton(ball);
    for (const Ray& ray :
         {Ray{{-3, 0.2, 0.1}, {1, 0, 0}}, Ray{{-3, 0.2, 0.1}, {1, 0.05, 0}}, Ray{{0.3, -4, 0}, {0, 1, 0}}}) {
        const auto hit = newton.closest(ray, 0, infinityD);
        ASSERT_TRUE(hit) << ray.d;
        EXPECT_NEAR(hit->s, ExactOracle(ball).hits(ray)[0].s, 1e-9);
    }
    int rays = 0, missed = 0;
    for (int i = 0; i < 40; ++i) {
        RandomStream random(20260303, i);
        const ProfilePoints points = randomProfile(random, 12);
        const ExactOracle oracle(points);
        const Newton2018 baseline(points);
        for (int m = 0; m < 50; ++m) {
            const Ray ray = randomRay(random, RayKind::Generic, points);
            for (const OracleHit& hit : oracle.hits(ray)) {
                if (hit.s < 1e-6) continue;
                const auto found = baseline.closest(ray, 1e-6, infinityD);
                missed += !found || std::abs(found->s - hit.s) > 1e-6;
                ++rays;
                break;
            }
        }
    }
    EXPECT_GT(missed, 0) << "of " << rays;
    EXPECT_LT(missed, rays / 10);
}

} // namespace
} // namespace vitrine::test
