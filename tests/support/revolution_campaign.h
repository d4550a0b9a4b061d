// Many random (profile, ray) pairs: every crossing that the shape reports against an oracle's, its backward error, and
// the first-hit and any-hit forms against the list of all.
#pragma once

#include "support/revolution_cases.h"

#include <array>
#include <functional>
#include <string>

namespace vitrine {
class Revolution;
}

namespace vitrine::test {

enum class OracleKind { Exact, Slow };

/// In parts of the profile's size; see Judgement.
inline constexpr double tangencyBand = 1e-9;
/// Of a hit: in units of n eps of the profile's size.
inline constexpr double maxBackwardError = 64;

struct CampaignTally {
    long pairs = 0, pairsWithHits = 0, crossings = 0;
    long judged = 0;       ///< pairs whose lists were not alike at first sight
    long excused = 0;      ///< of these, pairs within the tangency band
    long noisyTouches = 0; ///< of these, pairs with more than one pair of crossings too many at one touch
    int mostAtATouch = 0;  ///< the most too many
    long overruled = 0;    ///< pairs in which the slow solver, not the shape, erred outside the band
    long missed = 0, spurious = 0, offSurface = 0; ///< crossings
    long wrongPairs = 0;                           ///< with one of the first two
    long intervals = 0, wrongInInterval = 0; ///< first-hit and any-hit calls that differ from the list of all hits
    long refused = 0;                        ///< random profiles that the shape refuses
    double worstPoint = 0;                   ///< backward error of pointAt(), in n eps of the profile's size
    double worstOnRay = 0; ///< of the ray's point at s, in n eps of the larger of the profile's size and |o|
    std::array<long, rayKinds> pairsByKind{}, excusedByKind{};
    std::array<long, 21> pairsByDegree{}, hitsByDegree{};

    void add(const CampaignTally& other);
    bool isClean() const { return missed + spurious + offSurface + wrongInInterval == 0; }
};

struct CampaignPair {
    const ProfilePoints& profile;
    const std::vector<SlowCurve>& curves; ///< of its segments
    double phiMax;
    RayKind kind;
    const Ray& ray;
};
std::string describe(const CampaignPair& pair, const std::vector<OracleHit>& exact, const std::vector<OracleHit>& ours);

class Campaign {
  public:
    using Report = std::function<void(const std::string&)>;

    /// \param raysEach to one profile; pairs are a pure function of (seed, block number)
    Campaign(OracleKind oracle, std::uint64_t seed, int raysEach, Report report)
        : oracle_(oracle), seed_(seed), raysEach_(raysEach), report_(std::move(report)) {}
    /// One profile and its rays.
    CampaignTally runBlock(std::uint64_t block) const;

  private:
    void runPair(const CampaignPair& pair, const Revolution& shape,
                 const std::function<std::vector<OracleHit>()>& oracle, CampaignTally& tally) const;
    void checkIntervals(const CampaignPair& pair, const Revolution& shape, const std::vector<OracleHit>& ours,
                        RandomStream& random, CampaignTally& tally) const;

    OracleKind oracle_;
    std::uint64_t seed_;
    int raysEach_;
    Report report_;
};

struct ParityTally {
    long rays = 0, raysWithHits = 0, crossings = 0;
    long odd = 0;         ///< rays whose list of crossings is odd
    long wrongWalk = 0;   ///< rays on which stepping from hit to hit finds another number
    long wrongNormal = 0; ///< crossings that do not alternate between entering and leaving
    long rounded = 0;     ///< rays not stepped along: two crossings that differ by less than 16 eps
    long grazing = 0;     ///< rays not looked at for that: |cos| at a crossing below 1e-4, or two within 1e-7

    void add(const ParityTally& other);
    bool isClean() const { return odd + wrongWalk + wrongNormal == 0; }
};

/// Rays of drawKind() at the closed goblet.
ParityTally runParityBlock(std::uint64_t seed, std::uint64_t block, int rays, const Campaign::Report& report);

} // namespace vitrine::test
