// A k-d tree over the points that gather, which photons search: the other way round.
#pragma once

#include "photons/photon_lookup.h"

namespace vitrine {

/// Each node knows the largest radius below it, so points of very different radii share a tree. Where points stay, as in
/// progressive photon mapping, only radii are updated.
class PointTree {
  public:
    /// Fits the tree to these disks: anew if there are others or they moved, else by their radii alone.
    void fit(std::span<const GatherDisk> disks);

    /// Calls visit(disk index, squared distance) for each disk that p lies in.
    template <class F>
    void search(const V3f& p, F&& visit) const;

    std::size_t memoryBytes() const;

  private:
    static constexpr std::uint32_t leafSize = 8, leaf = 3;

    struct Node {
        float split = 0;
        float maxRadius = 0;
        std::uint32_t axis = leaf;        ///< of the split
        std::uint32_t begin = 0, end = 0; ///< in disks_
        std::uint32_t right = 0;          ///< second child; the first follows its parent
    };
    /// How far from its centre a disk may hold a point: to the rim of its thick edge, and a rounding.
    static float reach(float radius) { return radius * std::sqrt(1 + sqr(GatherDisk::thickness)) * 1.00001f; }
    bool moved(std::span<const GatherDisk> disks) const;
    /// Of a tree over so many points.
    static std::uint32_t nodesFor(std::uint32_t points);
    void build(std::uint32_t self, std::uint32_t begin, std::uint32_t end);
    void updateRadii(std::span<const GatherDisk> disks);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_; ///< index, as given, of each of disks_
    std::vector<GatherDisk> disks_;    ///< sorted by leaf
};

/// Photons looked for by a tree over the disks that ask. Find asks once for all the picture's disks, with all threads.
class TreeLookup final : public PhotonLookup {
  public:
    /// \param tree kept from pass to pass
    TreeLookup(std::vector<Photon> photons, PointTree& tree) : photons_(std::move(photons)), tree_(tree) {}

    std::span<const Photon> photons() const override { return photons_; }
    /// Not for several threads at a time: it fits the tree.
    void find(std::span<const GatherDisk> disks, NearPhotons& found) const override;
    std::size_t memoryBytes() const override { return photons_.capacity() * sizeof(Photon) + tree_.memoryBytes(); }

  private:
    std::vector<Photon> photons_;
    PointTree& tree_;
};

template <class F>
void PointTree::search(const V3f& p, F&& visit) const {
    if (nodes_.empty()) return;
    std::uint32_t stack[64];
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const Node& node = nodes_[stack[--size]];
        if (node.axis == leaf) {
            for (std::uint32_t i = node.begin; i < node.end; ++i)
                if (const float distance2 = distance2InDisk(disks_[i], p); distance2 >= 0) visit(order_[i], distance2);
            continue;
        }
        const auto first = std::uint32_t(&node - nodes_.data()) + 1;
        const float beyond = p[int(node.axis)] - node.split;
        if (beyond >= -reach(nodes_[node.right].maxRadius)) stack[size++] = node.right;
        if (beyond <= reach(nodes_[first].maxRadius)) stack[size++] = first;
    }
}

} // namespace vitrine
