#include "cameras/perspective.h"

#include <stdexcept>

namespace vitrine {

namespace {

/// Half the height at z = 1 of what screen space [-1, 1] shows.
double unitScale(double fov) {
    if (!(fov > 0 && fov < 180)) throw std::invalid_argument("the field of view must lie between 0 and 180 degrees");
    return std::tan(radians(fov) / 2);
}

} // namespace

PerspectiveCamera::PerspectiveCamera(const Motion& worldFromCamera, const V2i& resolution, const Settings& settings)
    : lens_(worldFromCamera, RasterWindow(resolution, settings.window, unitScale(settings.fov)), settings.lensRadius,
            settings.focalDistance, settings.aperture) {}

} // namespace vitrine
