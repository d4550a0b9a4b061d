// How large a pixel is along its path.
#pragma once

#include "cameras/camera.h"

namespace vitrine {

/// side = offset + spread * distance
struct PixelFootprint {
    double offset = 0, spread = 0;

    /// Of the ray that `camera` made of `sample`, by that of the pixel beside.
    static PixelFootprint of(const Camera& camera, const CameraSample& sample, const Ray& ray);
    double at(double distance) const { return offset + spread * distance; }
};

} // namespace vitrine
