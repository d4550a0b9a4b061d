// The part of the screen plane that the picture shows.
#pragma once

#include "core/vec.h"

namespace vitrine {

/// pbrt's `screenwindow`: the rectangle of screen space that fills the picture; x to the right, y up.
struct ScreenWindow {
    double xMin = -1, xMax = 1, yMin = -1, yMax = 1;

    /// pbrt's default for a picture `aspect` times as wide as high: the shorter side spans [-1, 1].
    /// \throws std::invalid_argument unless 0 < aspect < infinity
    static ScreenWindow ofAspect(double aspect);
};

/// The linear map between raster space and a rectangle of a plane.
class RasterWindow {
  public:
    /// \param resolution pixels of the full picture  \param scale the rectangle is the window times this
    /// \throws std::invalid_argument for empty resolutions and for windows that are empty or not finite
    RasterWindow(const V2i& resolution, const ScreenWindow& window, double scale);

    V2d planeFromRaster(const V2d& raster) const { return origin_ + raster * perPixel_; }
    V2d rasterFromPlane(const V2d& p) const { return (p - origin_) / perPixel_; }
    /// Whether the raster point lies in the picture, or so many pixels beyond its edges.
    bool contains(const V2d& raster, const V2f& margin) const {
        return raster.x >= -margin.x && raster.y >= -margin.y && raster.x < resolution_.x + margin.x &&
               raster.y < resolution_.y + margin.y;
    }
    /// Of the rectangle, in the plane's units.
    double area() const { return std::abs(perPixel_.x * perPixel_.y) * resolution_.x * resolution_.y; }

  private:
    V2i resolution_;
    V2d origin_, perPixel_;
};

/// \throws std::invalid_argument unless both numbers are positive
void checkResolution(const V2i& resolution);

} // namespace vitrine
