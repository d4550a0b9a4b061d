// From linear light to what a screen can show.
#pragma once

#include "core/image.h"

#include <string>
#include <vector>

namespace vitrine {

/// Operators, all on linear RGB with Rec.709 primaries; what they leave above 1 is clamped when written to 8 bits.
enum class ToneMap {
    None,     ///< as it is: the sRGB curve and clamping of the file format alone
    Reinhard, ///< Reinhard et al. 2002, eq. 3, on the luminance: L / (1 + L); keeps hue and saturation
    Filmic    ///< a curve fitted to the ACES reference rendering: shoulder and toe of film, bright colours bleach
};

/// "none", "reinhard", "filmic". \throws std::invalid_argument for another name, with the nearest one
ToneMap toneMapNamed(const std::string& name);
const std::vector<std::string>& toneMapNames();

/// Multiplies by 2^stops and applies the operator. Channels beyond the third (alpha and the like) stay as they are;
/// images of one or two channels have one colour channel. \param stops exposure, in factors of two; finite
Image toneMapped(const Image& image, float stops, ToneMap operation);

} // namespace vitrine
