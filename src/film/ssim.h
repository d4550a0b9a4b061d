// Structural similarity (Wang, Bovik, Sheikh & Simoncelli 2004).
#pragma once

#include "core/image.h"

#include <optional>

namespace vitrine {

/// Mean over all windows of 11 x 11 that lie in the picture and hold finite values alone; empty if there is none.
/// \param range the dynamic range L of eq. 13's constants
std::optional<double> meanSsim(const Image& a, const Image& b, double range);

} // namespace vitrine
