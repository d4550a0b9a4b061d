// Every crossing of random rays with random profiles, against oracles that share no code with the root finder. The same
// campaigns at length: bench/revolution_oracle.cpp.
#include "support/long_run.h"
#include "support/revolution_campaign.h"
#include "support/revolution_exact.h"
#include "support/revolution_slow.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace vitrine {
namespace {

using namespace test;

void fail(const std::string& text) {
    ADD_FAILURE() << text;
}

void expectClean(const CampaignTally& t) {
    std::printf(
        "%ld pairs, %ld with hits, %ld crossings, %ld in the band and not alike, worst backward error %.2f n eps\n",
        t.pairs, t.pairsWithHits, t.crossings, t.excused, t.worstPoint);
    EXPECT_EQ(t.missed, 0);
    EXPECT_EQ(t.spurious, 0);
    EXPECT_EQ(t.offSurface, 0);
    EXPECT_EQ(t.wrongInInterval, 0);
    EXPECT_EQ(t.overruled, 0);
    // Most rays must meet something, and the band must not swallow the test.
    EXPECT_GT(t.pairsWithHits, t.pairs / 2);
    EXPECT_LT(t.excused, t.pairs / 10);
    EXPECT_LE(t.excusedByKind[std::size_t(RayKind::Generic)], t.pairs / 10000);
}

TEST(RevolutionRoots, RandomPairsAgreeWithExactIntegers) {
    const Campaign campaign(OracleKind::Exact, 20190612, 20, fail);
    CampaignTally tally;
    for (int i = 0; i < 200 * longRun(); ++i)
        tally.add(campaign.runBlock(std::uint64_t(i)));
    expectClean(tally);
}

TEST(RevolutionRoots, RandomPairsAgreeWithASlowSolverInLongDouble) {
    const Campaign campaign(OracleKind::Slow, 20190611, 200, fail);
    CampaignTally tally;
    for (int i = 0; i < 150 * longRun(); ++i)
        tally.add(campaign.runBlock(std::uint64_t(i)));
    expectClean(tally);
}

TEST(RevolutionRoots, RaysEnterAndLeaveTheGoblet) {
    ParityTally tally;
    for (int i = 0; i < 10 * longRun(); ++i)
        tally.add(runParityBlock(20190613, std::uint64_t(i), 10000, fail));
    EXPECT_EQ(tally.odd, 0);
    EXPECT_EQ(tally.wrongWalk, 0);
    EXPECT_EQ(tally.wrongNormal, 0);
    EXPECT_GT(tally.raysWithHits, tally.rays / 2);
    EXPECT_LT(tally.grazing, tally.rays / 10);
}

} // namespace
} // namespace vitrine
