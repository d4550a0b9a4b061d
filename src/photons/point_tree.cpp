#include "photons/point_tree.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <atomic>
#include <numeric>

namespace vitrine {

bool PointTree::moved(std::span<const GatherDisk> disks) const {
    if (disks.size() != disks_.size()) return true;
    std::atomic<bool> any = false;
    tbb::parallel_for(std::size_t(0), disks_.size(), [&](std::size_t i) {
        const GatherDisk &before = disks_[i], &now = disks[order_[i]];
        if (before.center != now.center || before.normal != now.normal) any.store(true, std::memory_order_relaxed);
    });
    return any;
}

void PointTree::fit(std::span<const GatherDisk> disks) {
    if (moved(disks)) {
        order_.resize(disks.size());
        std::iota(order_.begin(), order_.end(), 0u);
        disks_.assign(disks.begin(), disks.end());
        nodes_.assign(disks.empty() ? 0 : nodesFor(std::uint32_t(disks.size())), Node{});
        if (!disks.empty()) build(0, 0, std::uint32_t(disks.size()));
        tbb::parallel_for(std::size_t(0), order_.size(), [&](std::size_t i) { disks_[i] = disks[order_[i]]; });
    }
    updateRadii(disks);
}

std::uint32_t PointTree::nodesFor(std::uint32_t points) {
    return points <= leafSize ? 1 : 1 + nodesFor(points / 2) + nodesFor(points - points / 2);
}

/// While it builds, disks_ stays as given and order_ is sorted. Where a part's nodes go is known from its size, so that
/// parts are built at once.
void PointTree::build(std::uint32_t self, std::uint32_t begin, std::uint32_t end) {
    Node& node = nodes_[self];
    node.begin = begin;
    node.end = end;
    if (end - begin <= leafSize) return;
    Imath::Box3f bounds;
    for (std::uint32_t i = begin; i < end; ++i)
        bounds.extendBy(disks_[order_[i]].center);
    const auto axis = int(bounds.majorAxis());
    const std::uint32_t middle = begin + (end - begin) / 2;
    // By index where coordinates are the same: one order for every library's sort.
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
        const float pa = disks_[a].center[axis], pb = disks_[b].center[axis];
        return pa < pb || (pa == pb && a < b);
    };
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, less);
    node.axis = std::uint32_t(axis);
    node.split = disks_[order_[middle]].center[axis];
    node.right = self + 1 + nodesFor(middle - begin);
    constexpr std::uint32_t worthATask = 4096;
    if (end - begin > worthATask) {
        tbb::parallel_invoke([&] { build(self + 1, begin, middle); }, [&] { build(node.right, middle, end); });
    } else {
        build(self + 1, begin, middle);
        build(node.right, middle, end);
    }
}

void PointTree::updateRadii(std::span<const GatherDisk> disks) {
    tbb::parallel_for(std::size_t(0), disks_.size(),
                      [&](std::size_t i) { disks_[i].radius = disks[order_[i]].radius; });
    // Children follow their parents.
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        Node& node = nodes_[i];
        node.maxRadius = 0;
        if (node.axis == leaf) {
            for (std::uint32_t k = node.begin; k < node.end; ++k)
                node.maxRadius = std::max(node.maxRadius, disks_[k].radius);
        } else {
            node.maxRadius = std::max(nodes_[i + 1].maxRadius, nodes_[node.right].maxRadius);
        }
    }
}

std::size_t PointTree::memoryBytes() const {
    return nodes_.capacity() * sizeof(Node) + disks_.capacity() * (sizeof(GatherDisk) + sizeof(std::uint32_t));
}

void TreeLookup::find(std::span<const GatherDisk> disks, NearPhotons& found) const {
    tree_.fit(disks);
    struct Pair {
        std::uint32_t disk;
        NearPhoton photon;
    };
    // Pairs by block of photons, those of a block by disk: photons of a disk keep their order. Then by part of the disks.
    constexpr std::size_t blockSize = 8192, partSize = 8192;
    const std::size_t blocks = (photons_.size() + blockSize - 1) / blockSize;
    std::vector<std::vector<Pair>> pairs(blocks);
    tbb::parallel_for(std::size_t(0), blocks, [&](std::size_t b) {
        for (std::size_t i = b * blockSize; i < std::min(photons_.size(), (b + 1) * blockSize); ++i)
            tree_.search(photons_[i].p(), [&](std::uint32_t disk, float distance2) {
                pairs[b].push_back({disk, {std::uint32_t(i), distance2}});
            });
        std::sort(pairs[b].begin(), pairs[b].end(), [](const Pair& one, const Pair& other) {
            return one.disk != other.disk ? one.disk < other.disk : one.photon.index < other.photon.index;
        });
    });

    const std::size_t parts = (disks.size() + partSize - 1) / partSize;
    std::vector<std::size_t> ends(disks.size()), partStarts(parts + 1);
    const auto forPairs = [&](std::size_t part, auto&& f) {
        const auto before = [](const Pair& pair, std::size_t disk) { return pair.disk < disk; };
        for (const auto& block : pairs)
            for (auto pair = std::lower_bound(block.begin(), block.end(), part * partSize, before);
                 pair != block.end() && pair->disk < (part + 1) * partSize; ++pair)
                f(*pair);
    };
    tbb::parallel_for(std::size_t(0), parts, [&](std::size_t part) {
        forPairs(part, [&](const Pair& pair) {
            ++ends[pair.disk];
            ++partStarts[part + 1];
        });
    });
    std::partial_sum(partStarts.begin(), partStarts.end(), partStarts.begin());
    std::vector<NearPhoton> photons(partStarts.back());
    tbb::parallel_for(std::size_t(0), parts, [&](std::size_t part) {
        std::size_t sum = partStarts[part];
        for (std::size_t disk = part * partSize; disk < std::min(disks.size(), (part + 1) * partSize); ++disk)
            sum += std::exchange(ends[disk], sum);
        forPairs(part, [&](const Pair& pair) { photons[ends[pair.disk]++] = pair.photon; });
    });
    found.assign(std::move(photons), std::move(ends));
}

} // namespace vitrine
