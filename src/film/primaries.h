// Pictures with other primaries than the screen's.
#pragma once

#include "core/image.h"

#include <span>

namespace vitrine {

/// The image with Rec.709 primaries and white (sRGB's). Images of other than three channels stay as they are.
/// \param chromaticities x and y of red, green, blue and white, as EXR gives them; all zero: Rec.709. White points are
///        not adapted to each other (as pbrt-v4 does not)
/// \throws std::invalid_argument when they span no colour space
Image inRec709(const Image& image, std::span<const float, 8> chromaticities);

} // namespace vitrine
