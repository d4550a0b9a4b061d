// The grid and the tree against trying every photon for every disk.
#include "core/random.h"
#include "core/sampling.h"
#include "photons/naive_lookup.h"
#include "photons/photon_grid.h"
#include "photons/point_tree.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <set>

namespace vitrine {
namespace {

/// Photons on the faces of a box of side 2 about `middle`, many of them in one place.
std::vector<Photon> somePhotons(int count, const V3f& middle, std::uint64_t seed) {
    RandomStream random(81, seed);
    std::vector<Photon> photons;
    for (int i = 0; i < count; ++i) {
        V3f p(random.uniform() * 2 - 1, random.uniform() * 2 - 1, random.uniform() * 2 - 1);
        p[i % 3] = i % 2 ? 1.f : -1.f;
        if (i % 7 == 0) p = V3f(0.25f, 0.25f, 1);
        photons.emplace_back(p + middle, V3f(0, 0, 1), true, i % 5, LightHistory::Scattered, SampledSpectrum(float(i)));
    }
    return photons;
}

PhotonBlocks inBlocks(const std::vector<Photon>& photons, std::size_t size = 777) {
    PhotonBlocks blocks;
    for (std::size_t i = 0; i < photons.size(); i += size)
        blocks.emplace_back(photons.begin() + std::ptrdiff_t(i),
                            photons.begin() + std::ptrdiff_t(std::min(photons.size(), i + size)));
    return blocks;
}

std::vector<GatherDisk> someDisks(int count, const V3f& middle, float radius, std::uint64_t seed) {
    RandomStream random(82, seed);
    std::vector<GatherDisk> disks;
    for (int i = 0; i < count; ++i) {
        V3f p(random.uniform() * 2 - 1, random.uniform() * 2 - 1, random.uniform() * 2 - 1);
        V3f n(0);
        p[i % 3] = n[i % 3] = i % 2 ? 1.f : -1.f;
        if (i % 4 == 0) n = sampleUniformSphere(V2f(random.uniform(), random.uniform()));
        disks.push_back({p + middle, n, radius * std::exp2(4 * random.uniform() - 2)});
    }
    return disks;
}

/// What identifies a photon: its power.
std::multiset<std::pair<float, float>> photonsOf(const PhotonLookup& lookup, const NearPhotons& found,
                                                 std::size_t disk) {
    std::multiset<std::pair<float, float>> result;
    for (const NearPhoton& n : found.of(disk))
        result.emplace(lookup.photons()[n.index].power()[0], n.distance2);
    return result;
}

void expectSame(const PhotonLookup& naive, const PhotonLookup& lookup, std::span<const GatherDisk> disks) {
    NearPhotons expected, found;
    naive.find(disks, expected);
    lookup.find(disks, found);
    ASSERT_EQ(expected.disks(), disks.size());
    ASSERT_EQ(found.disks(), disks.size());
    for (std::size_t i = 0; i < disks.size(); ++i)
        ASSERT_EQ(photonsOf(naive, expected, i), photonsOf(lookup, found, i)) << "disk " << i;
}

struct Place {
    V3f middle;
    float radius;
};

class Lookup : public testing::TestWithParam<Place> {};

TEST_P(Lookup, GridFindsWhatIsThere) {
    const auto [middle, radius] = GetParam();
    const auto photons = somePhotons(5000, middle, 1);
    const auto disks = someDisks(300, middle, radius, 2);
    const NaiveLookup naive(photons);
    NearPhotons found;
    naive.find(disks, found);
    ASSERT_GT(found.size(), 100u);
    for (const float cellSize : {0.3f * radius, radius, 3 * radius, 100 * radius})
        expectSame(naive, PhotonGrid(inBlocks(photons), cellSize), disks);
}

TEST_P(Lookup, CollidingCellsAreKeptApart) {
    const auto [middle, radius] = GetParam();
    const auto photons = somePhotons(3000, middle, 3);
    const auto disks = someDisks(200, middle, radius, 4);
    const NaiveLookup naive(photons);
    for (const unsigned bits : {1u, 2u, 5u, 9u})
        expectSame(naive, PhotonGrid(inBlocks(photons), radius, bits), disks);
}

TEST_P(Lookup, TreeFindsWhatIsThereAlsoAfterRadiiChange) {
    const auto [middle, radius] = GetParam();
    const auto photons = somePhotons(5000, middle, 5);
    auto disks = someDisks(300, middle, radius, 6);
    const NaiveLookup naive(photons);
    PointTree tree;
    expectSame(naive, TreeLookup(photons, tree), disks);
    for (std::size_t i = 0; i < disks.size(); ++i)
        disks[i].radius *= i % 2 ? 0.5f : 1.5f;
    expectSame(naive, TreeLookup(photons, tree), disks);
    disks.resize(123);
    expectSame(naive, TreeLookup(photons, tree), disks);
    disks[7].center.x += radius;
    expectSame(naive, TreeLookup(photons, tree), disks);
}

INSTANTIATE_TEST_SUITE_P(Places, Lookup,
                         testing::Values(Place{V3f(0), 0.1f}, Place{V3f(0), 0.02f}, Place{V3f(0), 3.f},
                                         Place{V3f(-700, 3, 41), 0.1f}));

TEST(Lookup, NothingToFind) {
    const auto disks = someDisks(10, V3f(0), 0.1f, 7);
    PointTree tree;
    const NaiveLookup naive({});
    expectSame(naive, PhotonGrid({}, 0.1f), disks);
    expectSame(naive, TreeLookup({}, tree), disks);
    expectSame(NaiveLookup(somePhotons(10, V3f(0), 8)), PhotonGrid({somePhotons(10, V3f(0), 8)}, 1), {});
    expectSame(NaiveLookup(somePhotons(10, V3f(0), 8)), TreeLookup(somePhotons(10, V3f(0), 8), tree), {});
}

TEST(Lookup, GridDoesNotDependOnThreads) {
    const auto photons = somePhotons(100000, V3f(0), 9);
    std::vector<std::vector<float>> orders;
    for (const int threads : {1, 2, 7}) {
        const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 7);
        tbb::task_arena arena(threads);
        arena.execute([&] {
            const PhotonGrid grid(inBlocks(photons), 0.05f);
            orders.emplace_back();
            for (const Photon& p : grid.photons())
                orders.back().push_back(p.power()[0]);
        });
    }
    EXPECT_EQ(orders[0], orders[1]);
    EXPECT_EQ(orders[0], orders[2]);
}

TEST(GatherDisk, IsFlat) {
    const GatherDisk disk{V3f(0, 0, 0), V3f(0, 0, 1), 1};
    EXPECT_FLOAT_EQ(distance2InDisk(disk, V3f(0.5f, 0, 0.1f)), 0.25f);
    EXPECT_LT(distance2InDisk(disk, V3f(0, 0, 0.3f)), 0) << "a ball would have it";
    EXPECT_LT(distance2InDisk(disk, V3f(0, 0, -0.3f)), 0);
    EXPECT_LT(distance2InDisk(disk, V3f(0.8f, 0.8f, 0)), 0);
}

TEST(GatherDisk, KernelsIntegrateToOne) {
    for (const Kernel kernel : {Kernel::Constant, Kernel::Epanechnikov}) {
        double sum = 0;
        constexpr int steps = 1000;
        for (int i = 0; i < steps; ++i) {
            const double d = (i + 0.5) / steps;
            sum += kernelShape(kernel, float(d * d * 4), 4) * 2 * d / steps; // times area 2 pi d over pi
        }
        EXPECT_NEAR(sum, 1, 1e-5);
    }
}

} // namespace
} // namespace vitrine
