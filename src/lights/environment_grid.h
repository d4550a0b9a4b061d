// A grid of texels over the sphere of directions.
#pragma once

#include "core/vec.h"

namespace vitrine {

enum class EnvironmentMapping {
    EqualArea, ///< pbrt-v4's: the octahedral map of Clarberg 2008, +z in the picture's middle (core/equal_area.h)
    LatLong ///< longitude phi across from +x over +y, latitude down from +z, as pbrt's `imgtool makeequiarea` reads it
};

/// Where the texels of an environment image lie. Directions are the light's, z up; the unit square is the picture, v
/// down.
class EnvironmentGrid {
  public:
    /// \throws std::invalid_argument unless EqualArea is square and LatLong twice as wide as high
    EnvironmentGrid(EnvironmentMapping mapping, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    /// Coordinates of a unit direction in the unit square.
    V2f squareFromDirection(const V3f& d) const;
    /// The direction of a point of the square such that areas within a row of texels become solid angles in one ratio:
    /// a uniform point of a texel is a uniform direction in it, also where rows narrow towards the poles of LatLong.
    V3f uniformDirection(const V2f& p) const;
    /// The row of texels that a coordinate v lies in.
    int row(float v) const { return std::clamp(int(v * float(height_)), 0, height_ - 1); }
    int column(float u) const { return std::clamp(int(u * float(width_)), 0, width_ - 1); }
    /// Of each texel of a row. All together fill 4 pi.
    double solidAngle(int row) const;
    /// Index in row-major order; x and y may lie one beyond the picture and are led round the sphere.
    std::size_t texel(int x, int y) const;

  private:
    EnvironmentMapping mapping_;
    int width_, height_;
};

} // namespace vitrine
