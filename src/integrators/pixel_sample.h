// Where in a pixel a sample looks.
#pragma once

#include "cameras/camera.h"
#include "core/sampler.h"
#include "film/filter.h"

namespace vitrine {

struct PixelSample {
    CameraSample camera;
    float weight; ///< of the filter
};

/// By the stream's next two dimensions, for filter and lens.
inline PixelSample samplePixel(const Filter& filter, const V2i& pixel, SampleStream& stream) {
    const Filter::Sample filtered = filter.sample(stream.get2D());
    const V2d raster(pixel.x + 0.5 + filtered.p.x, pixel.y + 0.5 + filtered.p.y);
    return {{raster, stream.get2D()}, filtered.weight};
}

/// Uniform in [0, 1), of a dimension of its own that none of the others comes near: which time of the shutter a path sees.
inline float timeNumber(SampleStream stream) {
    stream.setDimension(0x74696d65);
    return stream.get1D();
}

} // namespace vitrine
