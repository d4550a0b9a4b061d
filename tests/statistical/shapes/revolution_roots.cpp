// Every crossing of random rays with random profiles, against oracles that share no code with the root finder.
#include "shapes/revolution/revolution.h"
#include "support/revolution_cases.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace vitrine {
namespace {

using namespace test;

/// Where two crossings lie within this of merging, in parts of the profile's size, either count is right.
constexpr double tangencyBand = 1e-9;

struct Tally {
    long pairs = 0, hits = 0, inBand = 0, genericInBand = 0, wrongCount = 0, wrongPlace = 0, offSurface = 0;
    double worstResidual = 0; ///< over the bound
};

/// Hits that matter: of a ray that starts on the surface the start itself is in doubt.
std::vector<double> beyondStart(std::vector<double> s, RayKind kind) {
    if (kind == RayKind::FromSurface) std::erase_if(s, [](double x) { return std::abs(x) < 1e-6; });
    return s;
}

bool agree(const std::vector<double>& a, const std::vector<double>& b, double scale) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!(std::abs(a[i] - b[i]) <= 1e-4 * scale)) return false;
    return true;
}

template <class Oracle>
void compare(const ProfilePoints& points, const Revolution& shape, const Ray& ray, RayKind kind, Oracle&& oracle,
             Tally& tally) {
    ++tally.pairs;
    const double size = shape.profile().size(), length = ray.d.length();
    std::vector<double> ours, theirs;
    const int degree = int(points[0].size()) - 1;
    for (const PrimitiveHit& hit : shape.allHits(ray, -infinityD, infinityD)) {
        ours.push_back(hit.s);
        const double position = hit.v * double(points.size());
        const int segment = std::min(int(position), int(points.size()) - 1);
        const double distance = residual(points, ray, hit.s, segment, position - segment);
        // 64 n eps of the profile, as much of the ray's origin: the direction is rounded when it is made unit.
        const double bound = 0x1p-52 * (64 * degree * size + 16 * maxAbs(ray.o) + 16 * std::abs(hit.s) * length);
        tally.worstResidual = std::max(tally.worstResidual, distance / bound);
        if (distance > bound) ++tally.offSurface;
    }
    for (const OracleHit& hit : oracle(ray))
        theirs.push_back(hit.s);
    tally.hits += long(theirs.size());
    ours = beyondStart(ours, kind);
    theirs = beyondStart(theirs, kind);
    if (agree(ours, theirs, size / length)) return;
    // The scan may have overlooked a pair: 50 digits decide.
    theirs.clear();
    for (const OracleHit& hit : exactHits(points, ray))
        theirs.push_back(hit.s);
    theirs = beyondStart(theirs, kind);
    if (agree(ours, theirs, size / length)) return;
    if (isNearlyTangent(points, ray, tangencyBand * size)) {
        ++tally.inBand;
        if (kind == RayKind::Generic) ++tally.genericInBand;
        return;
    }
    ++(ours.size() == theirs.size() ? tally.wrongPlace : tally.wrongCount);
    if (tally.wrongPlace + tally.wrongCount > 5) return;
    std::ostringstream text;
    text.precision(17);
    text << "ray " << ray.o << " " << ray.d << " (" << toString(kind) << "), degree " << degree << "\n  ours:";
    for (const double s : ours)
        text << " " << s;
    text << "\n  exact:";
    for (const double s : theirs)
        text << " " << s;
    text << "\n  profile:";
    for (const auto& segment : points) {
        for (const V2d& p : segment)
            text << " {" << p.x << "," << p.y << "}";
        text << " |";
    }
    ADD_FAILURE() << text.str();
}

void expectClean(const Tally& tally, const char* name) {
    std::printf("%s: %ld pairs, %ld crossings, %ld pairs in the tangency band, worst residual %.3g of the bound\n",
                name, tally.pairs, tally.hits, tally.inBand, tally.worstResidual);
    EXPECT_EQ(tally.wrongCount, 0);
    EXPECT_EQ(tally.wrongPlace, 0);
    EXPECT_EQ(tally.offSurface, 0);
    // The band must not swallow the test.
    EXPECT_LE(tally.inBand, tally.pairs / 50);
    EXPECT_LE(tally.genericInBand, tally.pairs / 10000);
}

/// VITRINE_LONG=n multiplies the number of profiles, for a longer run than the suite has time for.
int repeats() {
    const char* text = std::getenv("VITRINE_LONG");
    return text ? std::max(1, std::atoi(text)) : 1;
}

TEST(RevolutionRoots, RandomPairsAgreeWithAScanInLongDouble) {
    Tally tally;
    const int profiles = 40 * repeats(), raysEach = 270;
    for (int i = 0; i < profiles; ++i) {
        RandomStream random(20190611, i);
        const ProfilePoints points = randomProfile(random, 1 + i % 20);
        const Revolution shape(Transform(), false, Profile(joined(points), int(points[0].size()) - 1));
        const ScanOracle oracle(points);
        for (int k = 0; k < raysEach; ++k) {
            const RayKind kind = RayKind(k % rayKinds);
            compare(
                points, shape, randomRay(random, kind, points), kind, [&](const Ray& r) { return oracle.hits(r); },
                tally);
        }
    }
    expectClean(tally, "scan");
}

TEST(RevolutionRoots, RandomPairsAgreeWithFiftyDigits) {
    Tally tally;
    const int profiles = 40 * repeats(), raysEach = 9;
    for (int i = 0; i < profiles; ++i) {
        RandomStream random(20190612, i);
        const ProfilePoints points = randomProfile(random, 1 + i % 20);
        const Revolution shape(Transform(), false, Profile(joined(points), int(points[0].size()) - 1));
        for (int k = 0; k < raysEach; ++k) {
            const RayKind kind = RayKind(k % rayKinds);
            compare(
                points, shape, randomRay(random, kind, points), kind,
                [&](const Ray& r) { return exactHits(points, r); }, tally);
        }
    }
    expectClean(tally, "fifty digits");
}

TEST(RevolutionRoots, GobletAndVaseAgreeWithAScanInLongDouble) {
    Tally tally;
    for (const ProfilePoints& points : {gobletProfile(), vaseProfile()}) {
        RandomStream random(20190613, points.size());
        const Revolution shape(Transform(), false, Profile(joined(points), int(points[0].size()) - 1));
        const ScanOracle oracle(points, 100);
        for (int k = 0; k < 2000 * repeats(); ++k) {
            const RayKind kind = RayKind(k % rayKinds);
            compare(
                points, shape, randomRay(random, kind, points), kind, [&](const Ray& r) { return oracle.hits(r); },
                tally);
        }
    }
    expectClean(tally, "goblet and vase");
}

} // namespace
} // namespace vitrine
