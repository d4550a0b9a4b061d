#include "cameras/raster_window.h"

#include <stdexcept>

namespace vitrine {

ScreenWindow ScreenWindow::ofAspect(double aspect) {
    if (!(aspect > 0) || !std::isfinite(aspect))
        throw std::invalid_argument("the frame's aspect ratio must be positive and finite");
    if (aspect > 1) return {-aspect, aspect, -1, 1};
    return {-1, 1, -1 / aspect, 1 / aspect};
}

RasterWindow::RasterWindow(const V2i& resolution, const ScreenWindow& window, double scale) : resolution_(resolution) {
    checkResolution(resolution);
    // Raster y runs down, screen y up.
    origin_ = V2d(window.xMin, window.yMax) * scale;
    perPixel_ = V2d(window.xMax - window.xMin, window.yMin - window.yMax) * scale / V2d(resolution.x, resolution.y);
    const bool finite = std::isfinite(origin_.x) && std::isfinite(origin_.y) && std::isfinite(perPixel_.x) &&
                        std::isfinite(perPixel_.y);
    if (!finite || perPixel_.x == 0 || perPixel_.y == 0)
        throw std::invalid_argument("the screen window must be finite and not empty");
}

void checkResolution(const V2i& resolution) {
    if (resolution.x <= 0 || resolution.y <= 0)
        throw std::invalid_argument("the picture must be at least one pixel wide and high");
}

} // namespace vitrine
