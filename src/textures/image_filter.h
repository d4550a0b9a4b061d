// The mean of an image over what a pixel sees of it.
#pragma once

#include "textures/image_cache.h"

namespace vitrine {

/// How much of the image one lookup takes in. In the words of pbrt-v4.
enum class ImageFilter {
    Point,     ///< the nearest texel of the level that is as coarse as the footprint
    Bilinear,  ///< the four nearest texels of it
    Trilinear, ///< bilinear in the two levels about as coarse, interpolated
    Ewa        ///< trilinear at the footprint's width, several times along its length
};

/// A parallelogram of the image, in units of its size.
struct ImageFootprint {
    V2d dx{0, 0}, dy{0, 0};
};

struct ImageSampling {
    ImageFilter filter = ImageFilter::Bilinear;
    ImageWrap wrap = ImageWrap::Repeat;
    float maxAnisotropy = 8; ///< length over width up to which Ewa does not blur more than it must
};

/// Filtered values at `st`, which goes over the image in [0, 1]^2 from its upper left corner. Without a footprint from the
/// finest level.
Texel filtered(const CachedImage& image, const ImageSampling& sampling, const V2d& st, const ImageFootprint& footprint);

} // namespace vitrine
