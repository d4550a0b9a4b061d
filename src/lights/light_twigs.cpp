#include "lights/light_twigs.h"

#include <array>
#include <optional>

namespace vitrine {

namespace {

constexpr int bucketCount = 12;
/// From here on lights are halved by number: the recursion stays shallow whatever they are.
constexpr int balancedDepth = 64;

/// Eq. 2 of the paper, over 2 pi: how much there is of directions that lights of these bounds shine into.
double directionMeasure(const LightBounds& bounds) {
    const double normals = std::acos(std::clamp(bounds.normals.cosAngle, -1., 1.));
    const double reach = std::min(std::acos(std::clamp(bounds.cosReach, -1., 1.)), piD - normals);
    return 1 - std::cos(normals) +
           (2 * reach * std::sin(normals) - std::cos(normals - 2 * reach) - 2 * normals * std::sin(normals) +
            std::cos(normals)) /
               4;
}

double surfaceArea(const V3d& size) {
    return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

/// Where along the axis the centre lies, of `bucketCount` slices.
struct Slices {
    int axis;
    double begin, perSlice;

    int operator()(const V3d& center) const {
        return std::clamp(int((center[axis] - begin) * perSlice), 0, bucketCount - 1);
    }
};

struct Bucket {
    std::optional<LightBounds> bounds;

    void add(const LightBounds& more) { bounds = bounds ? unite(*bounds, more) : more; }
    void add(const Bucket& more) {
        if (more.bounds) add(*more.bounds);
    }
    /// Eq. 1: intensity, directions and area. Flat and thin boxes count by their other sizes.
    double cost(const V3d& whole) const {
        const double least = 1e-3 * std::max({whole.x, whole.y, whole.z});
        const V3d size = bounds->box.size();
        return bounds->intensity * directionMeasure(*bounds) *
               surfaceArea(V3d(std::max(size.x, least), std::max(size.y, least), std::max(size.z, least)));
    }
};

/// The cheapest cut along one axis: buckets below it, and its cost.
std::pair<int, double> cheapestCut(const std::array<Bucket, bucketCount>& buckets, const V3d& whole) {
    std::array<double, bucketCount> above{};
    Bucket sum;
    for (int i = bucketCount - 1; i > 0; --i) {
        sum.add(buckets[std::size_t(i)]);
        above[std::size_t(i)] = sum.bounds ? sum.cost(whole) : infinityD;
    }
    std::pair<int, double> best{0, infinityD};
    sum = {};
    for (int i = 1; i < bucketCount; ++i) {
        sum.add(buckets[std::size_t(i) - 1]);
        const double cost = sum.bounds ? sum.cost(whole) + above[std::size_t(i)] : infinityD;
        if (cost < best.second) best = {i, cost};
    }
    return best;
}

} // namespace

LightTwigs::LightTwigs(const std::vector<LightBounds>& lights) {
    std::vector<Item> items;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].intensity > 0) items.push_back({lights[i], lights[i].box.center(), std::uint32_t(i)});
    if (items.empty()) return;
    twigs_.reserve(2 * items.size() - 1);
    build(items, 0, items.size(), 0);
}

std::uint32_t LightTwigs::build(std::vector<Item>& items, std::size_t begin, std::size_t end, int depth) {
    const auto twig = std::uint32_t(twigs_.size());
    twigs_.emplace_back();
    if (end - begin == 1) {
        twigs_[twig].bounds = items[begin].bounds;
        twigs_[twig].light = items[begin].light;
        return twig;
    }
    const std::size_t middle = depth < balancedDepth ? partition(items, begin, end) : begin + (end - begin) / 2;
    const std::uint32_t first = build(items, begin, middle, depth + 1);
    const std::uint32_t second = build(items, middle, end, depth + 1);
    twigs_[twig] = {unite(twigs_[first].bounds, twigs_[second].bounds), first, second, 0};
    return twig;
}

/// Puts those below the cheapest cut first (sec. 4.2): the weight of an axis is how much shorter than the longest it is.
std::size_t LightTwigs::partition(std::vector<Item>& items, std::size_t begin, std::size_t end) {
    const auto first = items.begin() + std::ptrdiff_t(begin), last = items.begin() + std::ptrdiff_t(end);
    Box3d box, centers;
    for (auto item = first; item != last; ++item) {
        box.extendBy(item->bounds.box);
        centers.extendBy(item->center);
    }
    const V3d whole = box.size(), spread = centers.size();
    const double longest = std::max({whole.x, whole.y, whole.z});
    std::optional<Slices> best;
    int cut = 0;
    double cheapest = infinityD;
    for (int axis = 0; axis < 3; ++axis) {
        const Slices slices{axis, centers.min[axis], bucketCount / spread[axis]};
        if (!std::isfinite(slices.perSlice)) continue;
        std::array<Bucket, bucketCount> buckets;
        for (auto item = first; item != last; ++item)
            buckets[std::size_t(slices(item->center))].add(item->bounds);
        const auto [at, cost] = cheapestCut(buckets, whole);
        if (const double weighed = cost * longest / whole[axis]; at > 0 && weighed < cheapest) {
            cheapest = weighed;
            cut = at;
            best = slices;
        }
    }
    if (best)
        return std::size_t(std::partition(first, last, [&](const Item& item) { return (*best)(item.center) < cut; }) -
                           items.begin());
    // All at one place, or all alike: halves.
    return begin + (end - begin) / 2;
}

} // namespace vitrine
