// Area of a turned profile, and points drawn by it.
#pragma once

#include "shapes/revolution/profile.h"

#include <vector>

namespace vitrine {

/// Area per radian of phi and per unit of v.
inline double areaDensity(const CurvePoint& c) {
    return std::max(c.p.x, 0.) * c.d1.length();
}

/// Cells over v in [0,1], each with the exact area and a density that is linear inside.
class AreaTable {
  public:
    /// \throws std::invalid_argument when the profile has no area
    explicit AreaTable(const Profile& profile);

    /// Area per radian of phi.
    double total() const { return cumulative_.back(); }
    /// v up to which the fraction u of the area lies, nearly.
    double sample(double u) const;
    /// The density with which sample() draws v, per area per radian: 1/total() up to the second order of a cell.
    /// \param density areaDensity() at v
    double pdf(double v, double density) const;

    std::size_t memoryBytes() const { return cells_.size() * (sizeof(Cell) + sizeof(double)); }

  private:
    struct Cell {
        double v0, v1;
        double f0, f1; ///< areaDensity at the ends
    };
    std::vector<Cell> cells_;
    std::vector<double> cumulative_; ///< cells + 1 values
};

} // namespace vitrine
