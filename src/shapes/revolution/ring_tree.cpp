#include "shapes/revolution/ring_tree.h"

namespace vitrine {

namespace {

/// Where to divide rings into two runs so that boxes about them, weighted by what they hold, are smallest.
unsigned bestCut(std::span<const Ring> rings) {
    std::vector<double> tail(rings.size());
    Ring ring;
    for (std::size_t i = rings.size(); i-- > 0;) {
        ring.extendBy(rings[i]);
        tail[i] = ring.surface() * double(rings.size() - i);
    }
    ring = Ring{};
    unsigned best = 1;
    double least = infinityD;
    for (unsigned i = 1; i < rings.size(); ++i) {
        ring.extendBy(rings[i - 1]);
        const double cost = ring.surface() * i + tail[i];
        if (cost < least) least = cost, best = i;
    }
    return best;
}

} // namespace

/// A binary tree over runs of neighbouring rings, from which the tree of four is made.
struct RingTree::Builder {
    struct Run {
        Ring ring;
        unsigned first, count;
        unsigned right = 0; ///< the second half, the first follows its parent; 0 for a leaf
    };

    RingTree& tree;
    std::vector<Run> runs;

    unsigned divide(unsigned first, unsigned count, int depth) {
        const unsigned index = unsigned(runs.size());
        runs.push_back({Ring{}, first, count});
        const auto rings = std::span(tree.rings_).subspan(first, count);
        for (const Ring& ring : rings)
            runs[index].ring.extendBy(ring);
        if (count > 1) {
            // Halving from some depth on keeps the tree's depth, and with it the stack of a search, within bounds.
            const unsigned cut = depth < maxDepth - 32 ? bestCut(rings) : count / 2;
            divide(first, cut, depth + 1);
            const unsigned right = divide(first + cut, count - cut, depth + 1);
            runs[index].right = right;
        }
        return index;
    }

    double cheapestGroups(unsigned index, std::vector<unsigned>& groups) const {
        // A ray that meets the box pays for the call and for the way down the tree; measured in calls.
        constexpr double levelCost = 0.05;
        const Run& run = runs[index];
        const double whole = run.ring.surface() * (1 + levelCost * std::log2(double(run.count)));
        if (run.right != 0) {
            std::vector<unsigned> apart;
            const double cost = cheapestGroups(index + 1, apart) + cheapestGroups(run.right, apart);
            if (cost < whole) {
                groups.insert(groups.end(), apart.begin(), apart.end());
                return cost;
            }
        }
        groups.push_back(index);
        return whole;
    }

    /// A node for the run, with as many of its descendants as fit: the largest are opened first.
    unsigned collapse(unsigned index) {
        std::vector<unsigned> children{index};
        while (children.size() < 4) {
            const auto size = [&](unsigned c) { return runs[c].right != 0 ? runs[c].ring.surface() : -1; };
            const auto largest = std::max_element(children.begin(), children.end(),
                                                  [&](unsigned a, unsigned b) { return size(a) < size(b); });
            const unsigned opened = *largest;
            if (runs[opened].right == 0) break;
            *largest = opened + 1;
            children.push_back(runs[opened].right);
        }
        const unsigned node = unsigned(tree.nodes_.size());
        tree.nodes_.push_back(Node{});
        for (std::size_t i = 0; i < children.size(); ++i) {
            const Run& run = runs[children[i]];
            const std::int32_t child = run.right == 0 ? ~std::int32_t(run.first) : std::int32_t(collapse(children[i]));
            Node& n = tree.nodes_[node];
            n.rMin[i] = run.ring.rMin;
            n.rMax[i] = run.ring.rMax;
            n.y[0][i] = run.ring.yMin;
            n.y[1][i] = run.ring.yMax;
            n.child[i] = child;
            n.used |= 1u << i;
        }
        return node;
    }
};

RingTree::RingTree(std::vector<Ring> rings) : rings_(std::move(rings)) {
    Builder builder{*this, {}};
    builder.divide(0, unsigned(rings_.size()), 0);
    std::vector<unsigned> roots;
    builder.cheapestGroups(0, roots);
    for (const unsigned root : roots) {
        const Builder::Run& run = builder.runs[root];
        groups_.push_back({builder.collapse(root), run.first, run.count});
    }
}

} // namespace vitrine
