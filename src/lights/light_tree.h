// A hierarchy over lights, for choosing one by what it brings to a point.
#pragma once

#include "lights/light_bounds.h"

#include <optional>
#include <vector>

namespace vitrine {

/// A binary tree over bounds of lights (Conty Estevez & Kulla 2018): from the root down each step goes to one of two children
/// in proportion to their importance. The path to each leaf is kept, so that its probability is found by the same numbers.
class LightTree {
  public:
    struct Choice {
        unsigned leaf = 0; ///< index into the lights given
        double probability = 0;
    };
    LightTree() = default;
    /// Lights of no intensity are never chosen.
    explicit LightTree(const std::vector<LightBounds>& lights);

    bool empty() const { return nodes_.empty(); }
    /// Empty where no light comes to. \param u in [0, 1)
    std::optional<Choice> sample(const LightReceiver& receiver, double u) const;
    /// Of sample() giving this leaf.
    double probability(const LightReceiver& receiver, unsigned leaf) const;
    std::size_t memoryBytes() const {
        return nodes_.capacity() * sizeof(Node) + trails_.capacity() * sizeof(std::uint64_t);
    }

  private:
    struct Node {
        LightImportance importance;
        std::uint32_t next = 0; ///< the second child (the first one follows), or the light of a leaf
        bool isLeaf = true;
    };
    /// A light that is to find its place.
    struct Item {
        LightBounds bounds;
        V3d center;
        unsigned light;
    };

    /// The first child's part of the choice between a node's two; negative where no light comes from either.
    double shareOfFirst(std::size_t node, const LightReceiver& receiver) const;
    LightBounds build(std::vector<Item>& items, std::size_t begin, std::size_t end, std::uint64_t trail,
                      unsigned depth);
    static std::size_t partition(std::vector<Item>& items, std::size_t begin, std::size_t end, unsigned depth);

    std::vector<Node> nodes_;
    /// A bit a step from the root, the lowest first: 1 for the second child.
    std::vector<std::uint64_t> trails_;
};

} // namespace vitrine
