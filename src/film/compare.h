// How far one picture is from another.
#pragma once

#include "core/image.h"

#include <optional>

namespace vitrine {

struct Comparison {
    /// Per pixel the mean over channels of (a-b)^2 / (b^2 + 0.01), b the reference; the 0.1 % of pixels with the
    /// largest error dropped; the mean of the rest, less the mean over the same pixels of variance / (b^2 + 0.01) if
    /// the reference's variance is known. With it the value can be negative: then a is as good as b.
    double relMse = 0;
    double mse = 0; ///< mean of (a-b)^2 over all pixels and channels
    /// Decibels, 10 log10(peak^2 / mse); infinite for equal pictures.
    double psnr = 0;
    double peak = 0; ///< the reference's largest value over all channels, at least 1
    /// Mean structural similarity of the luminances (Wang et al. 2004: windows of 11 x 11, Gaussian of sigma 1.5, K1 =
    /// 0.01, K2 = 0.03), dynamic range `peak`; empty for pictures narrower than a window.
    std::optional<double> ssim;
    /// Per channel: mean of a over mean of b (1 if both are 0).
    std::vector<double> meanRatio;
    /// Pixels with a NaN or infinity, in a and in b: they are left out of everything above, SSIM's windows included.
    std::size_t badPixelsA = 0, badPixelsB = 0;
    std::size_t pixels = 0; ///< that were compared
};

/// \param a, b linear, of one size and number of channels
/// \param variance of each value of b (of the mean, if b is one); null: b is exact
/// \throws std::invalid_argument when sizes differ, there are no channels, or no pixel is finite in both
Comparison compareImages(const Image& a, const Image& b, const Image* variance = nullptr);

/// Signed relative differences as colours: red where a is brighter than b, blue where it is darker, black where equal;
/// full brightness at `range`, which is a difference of luminances over (reference's luminance + 0.1). Yellow: not
/// finite.
Image heatMap(const Image& a, const Image& b, float range = 0.5f);

/// Rec.709 luminance; of images of one or two channels the first.
float luminance(const Image& image, std::size_t pixel);

} // namespace vitrine
