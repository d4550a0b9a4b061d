// Looking for photons alone, on one thread: 10^6 photons on the surfaces of a room, as many disks as a picture has pixels,
// by the grid, by the tree over the disks and, where its header is installed, by nanoflann's k-d tree over the photons
// (Debian: libnanoflann-dev). All answer the same question; the sums printed must be equal.
#include "core/random.h"
#include "core/sampling.h"
#include "photons/naive_lookup.h"
#include "photons/photon_grid.h"
#include "photons/point_tree.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <ctime>
#include <functional>
#if __has_include(<nanoflann.hpp>)
#include <nanoflann.hpp>
#define HAS_NANOFLANN 1
#else
#define HAS_NANOFLANN 0
#endif

using namespace vitrine;

namespace {

constexpr int photonCount = 1'000'000, across = 300, rounds = 3;

struct Place {
    V3f p, n;
};

/// On a room of side 2 with a ball in it, evenly by area. \param u, v across the surface
Place placeOnSurface(float which, float u, float v) {
    constexpr float ballArea = 4 * pi * 0.25f, roomArea = 24;
    which *= roomArea + ballArea;
    if (which >= roomArea) {
        const V3f n = sampleUniformSphere(V2f(u, v));
        return {n * 0.5f, n};
    }
    const int face = std::min(int(which / 4), 5);
    Place place{V3f(0), V3f(0)};
    place.n[face % 3] = face < 3 ? 1.f : -1.f;
    place.p[face % 3] = -place.n[face % 3];
    place.p[(face + 1) % 3] = 2 * u - 1;
    place.p[(face + 2) % 3] = 2 * v - 1;
    return place;
}

std::vector<Photon> makePhotons() {
    RandomStream random(90);
    std::vector<Photon> photons;
    for (int i = 0; i < photonCount; ++i) {
        const float which = random.uniform(), u = random.uniform(), v = random.uniform();
        photons.emplace_back(placeOnSurface(which, u, v).p, V3f(0, 0, 1), true, 1, LightHistory::Scattered,
                             SampledSpectrum(1.f));
    }
    return photons;
}

/// The order in which disks come.
enum class Order {
    Coherent, ///< in tiles over each face, as eye paths come
    Random,   ///< anywhere, one after the other
    Sorted    ///< the same, but sorted along a curve that fills space (Morton 1966)
};

const char* nameOf(Order order) {
    return order == Order::Coherent ? "coherent" : order == Order::Random ? "random" : "sorted";
}

std::uint32_t mortonCode(const V3f& p) {
    std::uint32_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto cell = std::uint32_t(std::clamp((p[axis] + 1) * 512, 0.f, 1023.f));
        for (int bit = 0; bit < 10; ++bit)
            code |= (cell >> bit & 1) << (3 * bit + axis);
    }
    return code;
}

std::vector<GatherDisk> makeDisks(float radius, Order order) {
    const bool coherent = order == Order::Coherent;
    RandomStream random(91);
    std::vector<GatherDisk> disks;
    constexpr int tile = 15;
    for (int tileY = 0; tileY < across; tileY += tile)
        for (int tileX = 0; tileX < across; tileX += tile)
            for (int i = 0; i < tile * tile; ++i) {
                const float x = (float(tileX + i % tile) + random.uniform()) / across;
                const float y = (float(tileY + i / tile) + random.uniform()) / across;
                const float a = random.uniform(), b = random.uniform(), c = random.uniform();
                // Coherent: face by face in thirds of the picture, pixel by pixel.
                const Place at = coherent ? placeOnSurface(std::floor(x * 7) / 7.f, x * 7 - std::floor(x * 7), y)
                                          : placeOnSurface(a, b, c);
                disks.push_back({at.p, at.n, radius});
            }
    if (order == Order::Sorted)
        std::stable_sort(disks.begin(), disks.end(), [](const GatherDisk& a, const GatherDisk& b) {
            return mortonCode(a.center) < mortonCode(b.center);
        });
    return disks;
}

struct Found {
    std::size_t photons = 0;
    double distances = 0; ///< sum of squares

    bool operator==(const Found& o) const {
        return photons == o.photons && std::abs(distances - o.distances) <= 1e-9 * std::abs(distances);
    }
};

Found sumOf(const NearPhotons& near) {
    Found sum;
    for (std::size_t disk = 0; disk < near.disks(); ++disk)
        for (const NearPhoton& photon : near.of(disk)) {
            ++sum.photons;
            sum.distances += double(photon.distance2);
        }
    return sum;
}

/// As rendering asks: tile by tile.
Found askInTiles(const PhotonLookup& lookup, std::span<const GatherDisk> disks) {
    constexpr std::size_t tile = 256;
    NearPhotons near;
    Found sum;
    for (std::size_t i = 0; i < disks.size(); i += tile) {
        lookup.find(disks.subspan(i, std::min(tile, disks.size() - i)), near);
        const Found part = sumOf(near);
        sum.photons += part.photons;
        sum.distances += part.distances;
    }
    return sum;
}

#if HAS_NANOFLANN
/// Places alone, apart from what else photons are: quicker than the photons as they are.
struct Cloud {
    std::vector<V3f> places;
    std::size_t kdtree_get_point_count() const { return places.size(); }
    float kdtree_get_pt(std::size_t i, std::size_t axis) const { return places[i][int(axis)]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};
using Flann = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3>;

/// The ball round each disk, then the disk's own test.
Found askFlann(const Flann& index, const Cloud& cloud, std::span<const GatherDisk> disks) {
    std::vector<std::pair<std::uint32_t, float>> inBall;
    const nanoflann::SearchParams unsorted(32, 0, false);
    Found sum;
    for (const GatherDisk& disk : disks) {
        const float ball2 = disk.radius2() * (1 + sqr(GatherDisk::thickness)) * 1.00001f;
        index.radiusSearch(&disk.center.x, ball2, inBall, unsorted);
        for (const auto& [i, ignored] : inBall)
            if (const float distance2 = distance2InDisk(disk, cloud.places[i]); distance2 >= 0) {
                ++sum.photons;
                sum.distances += double(distance2);
            }
    }
    return sum;
}
#endif

struct Contender {
    std::string name;
    std::function<Found(std::span<const GatherDisk>)> ask;
    std::vector<double> nanoseconds{};
};

double cpuSeconds() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

void compare(const std::vector<Photon>& photons, std::vector<Contender>& contenders, Order order, double wanted) {
    // Photons a unit of area times pi r^2.
    const float density = photonCount / (24 + pi), radius = std::sqrt(float(wanted) / (pi * density));
    const auto disks = makeDisks(radius, order);
    const PhotonGrid grid({photons}, 3 * radius), narrow({photons}, 2 * radius);
    PointTree tree;
    const TreeLookup byTree(photons, tree);
    auto all = contenders;
    all.insert(all.begin(), {"grid", [&](auto d) { return askInTiles(grid, d); }});
    all.push_back({"grid with narrower rows", [&](auto d) { return askInTiles(narrow, d); }});
    all.push_back({"tree over the disks", [&](auto d) {
                       NearPhotons near;
                       byTree.find(d, near);
                       return sumOf(near);
                   }});
    std::vector<Found> found(all.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double start = cpuSeconds();
            found[i] = all[i].ask(disks);
            all[i].nanoseconds.push_back((cpuSeconds() - start) * 1e9 / double(disks.size()));
        }
    const NaiveLookup naive(photons);
    constexpr std::size_t few = 20;
    const double start = cpuSeconds();
    const Found expected = askInTiles(naive, std::span(disks).first(few));
    const double naiveTime = (cpuSeconds() - start) * 1e9 / few;
    if (!(askInTiles(grid, std::span(disks).first(few)) == expected))
        throw std::runtime_error("the grid misses photons");

    fmt::print("{} disks, {}, {:.1f} photons each\n", disks.size(), nameOf(order),
               double(found[0].photons) / double(disks.size()));
    double first = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!(found[i] == found[0])) throw std::runtime_error(all[i].name + " finds others");
        auto& times = all[i].nanoseconds;
        std::nth_element(times.begin(), times.begin() + rounds / 2, times.end());
        if (i == 0) first = times[rounds / 2];
        fmt::print("  {:<28}{:>10.0f} ns a disk, {:>8.2f} x the grid's\n", all[i].name, times[rounds / 2],
                   times[rounds / 2] / first);
    }
    fmt::print("  {:<28}{:>10.0f} ns a disk\n", "naive", naiveTime);
}

template <class F>
auto timed(const char* what, F&& f) {
    const double start = cpuSeconds();
    auto result = f();
    fmt::print("building {}: {:.0f} ms\n", what, 1e3 * (cpuSeconds() - start));
    return result;
}

void run() {
    const auto photons = makePhotons();
    timed("the grid", [&] { return PhotonGrid({photons}, 0.02f).memoryBytes(); });
    std::vector<Contender> contenders;
#if HAS_NANOFLANN
    Cloud cloud;
    for (const Photon& photon : photons)
        cloud.places.push_back(photon.p());
    std::vector<std::unique_ptr<Flann>> indices;
    for (const std::size_t leaf : {10, 30}) {
        const std::string name = fmt::format("nanoflann, leaves of {}", leaf);
        indices.push_back(timed(name.c_str(), [&] {
            return std::make_unique<Flann>(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(leaf));
        }));
        contenders.push_back({name, [&index = *indices.back(), &cloud](auto d) { return askFlann(index, cloud, d); }});
    }
#endif
    for (const Order order : {Order::Coherent, Order::Random, Order::Sorted})
        for (const double wanted : {1.5, 10., 30., 100.})
            compare(photons, contenders, order, wanted);
}

} // namespace

int main() {
    try {
        tbb::task_arena(1).execute(run);
    } catch (const std::exception& e) {
        fmt::print(stderr, "{}\n", e.what());
        return 1;
    }
}
