#include "cameras/pixel_footprint.h"

namespace vitrine {

PixelFootprint PixelFootprint::of(const Camera& camera, const CameraSample& sample, const Ray& ray) {
    // Where the picture ends the pixel on the other side serves.
    for (const double step : {1., -1.}) {
        const auto beside = camera.generate({sample.raster + V2d(step, 0), sample.lens, sample.time});
        if (beside) return {(beside->ray.o - ray.o).length(), (beside->ray.d - ray.d).length()};
    }
    return {};
}

} // namespace vitrine
