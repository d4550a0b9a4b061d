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
        Lanes rMin, rMax, y[2]; ///< y: lowest, highest
        std::int32_t child[4];  ///< negative: ~leaf
        unsigned used;          ///< mask of the children there are
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

/// The ray beside rings, with all rounding put into one margin. Written so that few operations wait for one another.
class RingTree::Test {
  public:
    explicit Test(const HitCollector& hits) : hits_(hits) {
        const AxialRay& ray = hits.ray();
        const double margin = hits.margin();
        enter_ = ray.inverseV < 0;
        slope_ = ray.inverseV;
        const double slack = margin * std::abs(ray.inverseV);
        enterOffset_ = -ray.oy * ray.inverseV - slack;
        leaveOffset_ = -ray.oy * ray.inverseV + slack;
        h_ = ray.h;
        qLow_ = ray.q - margin;
        qHigh_ = ray.q + margin;
        eLow2_ = sqr(std::max(0., ray.e - margin));
        eHigh2_ = sqr(ray.e + margin);
    }

    /// Which children may be met, and from what length on.
    unsigned met(const Node& node, Lanes& from) const {
        const Lanes slope = broadcast(slope_), h = broadcast(h_), margin = broadcast(hits_.margin()), zero{};
        const Lanes enter = fusedMultiplyAdd(node.y[enter_], slope, broadcast(enterOffset_));
        const Lanes leave = fusedMultiplyAdd(node.y[1 - enter_], slope, broadcast(leaveOffset_));
        const Lanes lo = greater(enter, broadcast(hits_.lengthMin() - hits_.margin()));
        const Lanes hi = lesser(leave, broadcast(hits_.lengthMax() + hits_.margin()));
        // r^2 = e^2 + g^2 is convex along the ray.
        const Lanes ga = fusedMultiplyAdd(lo, h, broadcast(qLow_)), gb = fusedMultiplyAdd(hi, h, broadcast(qHigh_));
        const Lanes near = greater(greater(ga, -gb), zero), far = greater(-ga, gb);
        const Lanes outer = node.rMax + margin, inner = greater(node.rMin - margin, zero);
        from = lo;
        const unsigned missed = lessMask(hi, lo) |
                                lessMask(outer * outer, fusedMultiplyAdd(near, near, broadcast(eLow2_))) |
                                lessMask(fusedMultiplyAdd(far, far, broadcast(eHigh2_)), inner * inner);
        return node.used & ~missed;
    }
    bool isTooFar(double from) const { return from > hits_.lengthMax() + hits_.margin(); }

  private:
    const HitCollector& hits_;
    int enter_; ///< whether a ray comes from above
    double slope_, enterOffset_, leaveOffset_, h_, qLow_, qHigh_, eLow2_, eHigh2_;
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
