// A tree of rings over the parts of a profile, searched front to back. Four children a node are tested at once, in the
// half-plane where the ray is a hyperbola.
#pragma once

#include "shapes/revolution/hit_collector.h"
#include "shapes/revolution/lanes.h"
#include "shapes/revolution/ring.h"

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace vitrine {

class RingTree {
  public:
    explicit RingTree(std::vector<Ring> rings);

    /// Subtrees worth a bounding box each: cut where several small boxes catch fewer rays than a large one.
    unsigned groupCount() const { return unsigned(groups_.size()); }
    /// Of the leaves in a group.
    std::span<const Ring> rings(unsigned group) const {
        return std::span(rings_).subspan(groups_[group].first, groups_[group].count);
    }

    /// Calls visit(leaf) for the leaves that the ray may meet at lengths that `hits` still asks for, near ones mostly
    /// first, until it returns true.
    template <class Visit>
    void search(unsigned group, const HitCollector& hits, Visit&& visit) const;

    std::size_t memoryBytes() const {
        return nodes_.size() * sizeof(Node) + rings_.size() * sizeof(Ring) + groups_.size() * sizeof(Group);
    }

  private:
    static constexpr int maxDepth = 62;

    struct Node {
        Lanes rMin, rMax, yMin, yMax;
        std::int32_t child[4]; ///< negative: ~leaf
        unsigned used;         ///< mask of the children there are
    };
    struct Group {
        unsigned root, first, count; ///< leaves below
    };
    class Test;
    struct Builder;

    std::vector<Ring> rings_;
    std::vector<Node> nodes_;
    std::vector<Group> groups_;
};

/// The ray beside rings, with all rounding put into one margin.
class RingTree::Test {
  public:
    explicit Test(const HitCollector& hits) : hits_(hits), ray_(hits.ray()), margin_(hits.margin()) {
        eLow2_ = sqr(std::max(0., ray_.e - margin_));
        eHigh2_ = sqr(ray_.e + margin_);
    }

    /// Which children may be met, and from what length on.
    unsigned met(const Node& node, Lanes& from) const {
        const Lanes a = (node.yMin - broadcast(ray_.oy + margin_)) * broadcast(ray_.inverseV);
        const Lanes b = (node.yMax - broadcast(ray_.oy - margin_)) * broadcast(ray_.inverseV);
        const Lanes lo = greater(lesser(a, b), broadcast(hits_.lengthMin() - margin_));
        const Lanes hi = lesser(greater(a, b), broadcast(hits_.lengthMax() + margin_));
        // r^2 = e^2 + g^2 is convex along the ray.
        const Lanes ga = broadcast(ray_.q) + broadcast(ray_.h) * lo, gb = broadcast(ray_.q) + broadcast(ray_.h) * hi;
        const Lanes margin = broadcast(margin_), zero{};
        const Lanes near = greater(greater(ga, -gb) - margin, zero), far = greater(-ga, gb) + margin;
        const Lanes outer = node.rMax + margin, inner = greater(node.rMin - margin, zero);
        from = lo;
        const unsigned missed = lessMask(hi, lo) | lessMask(outer * outer, near * near + broadcast(eLow2_)) |
                                lessMask(far * far + broadcast(eHigh2_), inner * inner);
        return node.used & ~missed;
    }
    bool isTooFar(double from) const { return from > hits_.lengthMax() + margin_; }

  private:
    const HitCollector& hits_;
    const AxialRay& ray_;
    double margin_, eLow2_, eHigh2_;
};

template <class Visit>
void RingTree::search(unsigned group, const HitCollector& hits, Visit&& visit) const {
    struct Entry {
        double from;
        std::int32_t child;
    };
    Entry stack[3 * maxDepth + 4];
    int depth = 0;
    const Test test(hits);
    Entry next{-infinityD, std::int32_t(groups_[group].root)};
    while (true) {
        if (next.child < 0) {
            if (visit(unsigned(~next.child))) return;
        } else {
            const Node& node = nodes_[std::size_t(next.child)];
            Lanes from;
            // Put in by distance: the nearest comes off the stack first.
            const int bottom = depth;
            for (unsigned met = test.met(node, from); met != 0; met &= met - 1) {
                const int i = std::countr_zero(met);
                const Entry child{from[i], node.child[i]};
                int at = depth++;
                for (; at > bottom && stack[at - 1].from < child.from; --at)
                    stack[at] = stack[at - 1];
                stack[at] = child;
            }
        }
        do {
            if (depth == 0) return;
            next = stack[--depth];
        } while (test.isTooFar(next.from));
    }
}

} // namespace vitrine
