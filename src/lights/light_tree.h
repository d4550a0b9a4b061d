// A hierarchy over lights, for choosing one by what it brings to a point.
#pragma once

#include "lights/eight_lights.h"

#include <array>
#include <optional>
#include <vector>

namespace vitrine {

class LightTwigs;

/// A tree over bounds of lights (Conty Estevez & Kulla 2018): from the root down each step goes to a child in proportion to its
/// importance. Eight children a node: their importances are found at once, and of groups that are nearer each other than
/// those of a binary tree.
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
    std::size_t memoryBytes() const { return nodes_.capacity() * sizeof(Node) + leaves_.capacity() * sizeof(Spot); }

  private:
    static constexpr std::uint32_t nowhere = 0xffffffffu;
    /// A place among a node's children.
    struct Spot {
        std::uint32_t node = nowhere, lane = 0;
    };
    struct Node {
        EightLights lights;
        std::array<std::uint32_t, EightLights::lanes> next{}; ///< nodes, or the lights of leaves
        std::uint32_t leaves = 0;                             ///< a bit for each child that is one
        Spot parent;
    };
    struct Shares;
    std::uint32_t widen(const LightTwigs& twigs, std::uint32_t twig, Spot parent);

    std::vector<Node> nodes_;
    std::vector<Spot> leaves_; ///< of each light
};

} // namespace vitrine
