#include "lights/light_tree.h"

#include <array>

namespace vitrine {

namespace {

constexpr int bucketCount = 12;
/// Below this the lights are halved by number, so that paths of 64 steps lead to all.
constexpr unsigned balancedDepth = 32;
/// Of lights that are not in the tree.
constexpr std::uint64_t noTrail = ~std::uint64_t(0);

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

LightTree::LightTree(const std::vector<LightBounds>& lights) : trails_(lights.size(), noTrail) {
    std::vector<Item> items;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].intensity > 0) items.push_back({lights[i], lights[i].box.center(), unsigned(i)});
    if (items.empty()) return;
    nodes_.reserve(2 * items.size() - 1);
    build(items, 0, items.size(), 0, 0);
}

LightBounds LightTree::build(std::vector<Item>& items, std::size_t begin, std::size_t end, std::uint64_t trail,
                             unsigned depth) {
    const std::size_t node = nodes_.size();
    nodes_.emplace_back();
    if (end - begin == 1) {
        const Item& item = items[begin];
        nodes_[node] = {LightImportance(item.bounds), item.light, true};
        trails_[item.light] = trail;
        return item.bounds;
    }
    const std::size_t middle = partition(items, begin, end, depth);
    const LightBounds first = build(items, begin, middle, trail, depth + 1);
    const auto second = std::uint32_t(nodes_.size());
    const LightBounds both = unite(first, build(items, middle, end, trail | std::uint64_t(1) << depth, depth + 1));
    nodes_[node] = {LightImportance(both), second, false};
    return both;
}

/// Puts those below the cheapest cut first (sec. 4.2): the weight of an axis is how much shorter than the longest it is.
std::size_t LightTree::partition(std::vector<Item>& items, std::size_t begin, std::size_t end, unsigned depth) {
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
    for (int axis = 0; axis < 3 && depth < balancedDepth; ++axis) {
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

double LightTree::shareOfFirst(std::size_t node, const LightReceiver& receiver) const {
    const double first = nodes_[node + 1].importance.at(receiver);
    const double second = nodes_[nodes_[node].next].importance.at(receiver);
    return first + second > 0 ? first / (first + second) : -1;
}

std::optional<LightTree::Choice> LightTree::sample(const LightReceiver& receiver, double u) const {
    if (empty()) return {};
    double probability = 1;
    std::size_t node = 0;
    while (!nodes_[node].isLeaf) {
        const double share = shareOfFirst(node, receiver);
        if (share < 0) return {};
        const bool isFirst = u < share;
        u = std::min(isFirst ? u / share : (u - share) / (1 - share), 1 - 0x1p-53);
        probability *= isFirst ? share : 1 - share;
        node = isFirst ? node + 1 : nodes_[node].next;
    }
    return Choice{nodes_[node].next, probability};
}

double LightTree::probability(const LightReceiver& receiver, unsigned leaf) const {
    std::uint64_t trail = trails_[leaf];
    if (trail == noTrail) return 0;
    double probability = 1;
    for (std::size_t node = 0; !nodes_[node].isLeaf; trail >>= 1) {
        const double share = shareOfFirst(node, receiver);
        const bool isFirst = !(trail & 1);
        probability *= isFirst ? share : 1 - share;
        if (share < 0 || !(probability > 0)) return 0;
        node = isFirst ? node + 1 : nodes_[node].next;
    }
    return probability;
}

} // namespace vitrine
