// All crossings of a ray with a turned profile: a tree of rings over the profile's parts, a solver for each part.
#pragma once

#include "shapes/revolution/part_solver.h"
#include "shapes/revolution/profile.h"
#include "shapes/revolution/ring_tree.h"

namespace vitrine {

class RootFinder {
  public:
    explicit RootFinder(const Profile& profile);

    /// The profile in pieces that have a bounding box each.
    unsigned groupCount() const { return tree_.groupCount(); }
    /// Of the parts in a group.
    std::span<const Ring> rings(unsigned group) const { return tree_.rings(group); }

    /// Offers the crossings in one group to `hits`.
    void search(unsigned group, HitCollector& hits) const;
    /// Every crossing with s in (sMin, sMax), in order.
    std::vector<ProfileHit> allHits(const AxialRay& ray, const PhiRange& phi, double sMin, double sMax) const;

    /// Of the profile: for HitCollector.
    double size() const { return size_; }
    std::size_t memoryBytes() const;

  private:
    std::vector<PartSolver> parts_;
    RingTree tree_;
    double size_;
};

} // namespace vitrine
