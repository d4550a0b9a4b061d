// All crossings of a ray with a turned profile: a binary tree of rings over the profile's parts, tested in the
// half-plane where the ray is a hyperbola. Unlike a box, a ring has a hole.
#pragma once

#include "shapes/revolution/part_solver.h"
#include "shapes/revolution/profile.h"

namespace vitrine {

/// What lies between two radii and two heights.
struct Ring {
    double rMin = infinityD, rMax = 0, yMin = infinityD, yMax = -infinityD;

    void extendBy(const Ring& other);
    double surface() const;
};

class RootFinder {
  public:
    explicit RootFinder(const Profile& profile);

    /// Subtrees worth a bounding box each: cut where several small boxes catch fewer rays than a large one.
    unsigned groupCount() const { return unsigned(groups_.size()); }
    /// Of the parts in a group.
    std::vector<Ring> rings(unsigned group) const;

    /// Offers the crossings in one group to `hits`.
    void search(unsigned group, HitCollector& hits) const;
    /// Every crossing with s in (sMin, sMax), in order.
    std::vector<ProfileHit> allHits(const AxialRay& ray, const PhiRange& phi, double sMin, double sMax) const;

    std::size_t memoryBytes() const;

  private:
    static constexpr int maxTreeDepth = 62;

    struct Node {
        Ring ring;
        unsigned first, count; ///< parts below
        unsigned right = 0;    ///< the second child, the first follows its parent; 0 for a leaf
    };
    unsigned build(unsigned first, unsigned count, const std::vector<Ring>& rings, int depth);
    double cheapestGroups(unsigned node, std::vector<unsigned>& groups) const;

    std::vector<PartSolver> parts_;
    std::vector<Node> nodes_;
    std::vector<unsigned> groups_;
    double size_;
};

} // namespace vitrine
