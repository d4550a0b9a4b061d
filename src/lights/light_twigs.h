// The binary tree over lights that a tree of wider nodes is made of.
#pragma once

#include "lights/light_bounds.h"

#include <vector>

namespace vitrine {

/// Built from the top by the surface area orientation heuristic (Conty Estevez & Kulla 2018, sec. 4.2).
class LightTwigs {
  public:
    struct Twig {
        LightBounds bounds;
        std::uint32_t first = 0, second = 0; ///< children; a leaf has none
        std::uint32_t light = 0;             ///< of a leaf

        bool isLeaf() const { return second == 0; }
    };
    /// \param lights those of no intensity are left out
    explicit LightTwigs(const std::vector<LightBounds>& lights);

    bool empty() const { return twigs_.empty(); }
    /// The root is 0.
    const Twig& operator[](std::uint32_t twig) const { return twigs_[twig]; }

  private:
    struct Item {
        LightBounds bounds;
        V3d center;
        std::uint32_t light;
    };
    std::uint32_t build(std::vector<Item>& items, std::size_t begin, std::size_t end, int depth);
    static std::size_t partition(std::vector<Item>& items, std::size_t begin, std::size_t end);

    std::vector<Twig> twigs_;
};

} // namespace vitrine
