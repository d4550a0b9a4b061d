#include "photons/point_tree.h"

#include <tbb/parallel_for.h>

#include <numeric>

namespace vitrine {

bool PointTree::moved(std::span<const GatherDisk> disks) const {
    if (disks.size() != disks_.size()) return true;
    for (std::size_t i = 0; i < disks_.size(); ++i) {
        const GatherDisk &before = disks_[i], &now = disks[order_[i]];
        if (before.center != now.center || before.normal != now.normal) return true;
    }
    return false;
}

void PointTree::fit(std::span<const GatherDisk> disks) {
    if (moved(disks)) {
        order_.resize(disks.size());
        std::iota(order_.begin(), order_.end(), 0u);
        disks_.assign(disks.begin(), disks.end());
        nodes_.clear();
        if (!disks.empty()) build(0, std::uint32_t(disks.size()));
        for (std::size_t i = 0; i < order_.size(); ++i)
            disks_[i] = disks[order_[i]];
    }
    updateRadii(disks);
}

/// While it builds, disks_ stays as given and order_ is sorted.
void PointTree::build(std::uint32_t begin, std::uint32_t end) {
    const auto self = nodes_.size();
    nodes_.emplace_back();
    nodes_[self].begin = begin;
    nodes_[self].end = end;
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
    nodes_[self].axis = std::uint32_t(axis);
    nodes_[self].split = disks_[order_[middle]].center[axis];
    build(begin, middle);
    nodes_[self].right = std::uint32_t(nodes_.size());
    build(middle, end);
}

void PointTree::updateRadii(std::span<const GatherDisk> disks) {
    for (std::size_t i = 0; i < disks_.size(); ++i)
        disks_[i].radius = disks[order_[i]].radius;
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
    // Pairs by block of photons, then sorted by disk: photons of a disk keep their order.
    constexpr std::size_t blockSize = 8192;
    const std::size_t blocks = (photons_.size() + blockSize - 1) / blockSize;
    std::vector<std::vector<Pair>> pairs(blocks);
    tbb::parallel_for(std::size_t(0), blocks, [&](std::size_t b) {
        for (std::size_t i = b * blockSize; i < std::min(photons_.size(), (b + 1) * blockSize); ++i)
            tree_.search(photons_[i].p(), [&](std::uint32_t disk, float distance2) {
                pairs[b].push_back({disk, {std::uint32_t(i), distance2}});
            });
    });
    std::vector<std::size_t> ends(disks.size());
    for (const auto& block : pairs)
        for (const Pair& pair : block)
            ++ends[pair.disk];
    std::size_t sum = 0;
    for (std::size_t& end : ends)
        sum += std::exchange(end, sum);
    std::vector<NearPhoton> photons(sum);
    for (auto& block : pairs) {
        for (const Pair& pair : block)
            photons[ends[pair.disk]++] = pair.photon;
        std::vector<Pair>().swap(block);
    }
    found.assign(std::move(photons), std::move(ends));
}

} // namespace vitrine
