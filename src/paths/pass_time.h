// The time that all paths of a pass share.
#pragma once

#include "core/motion.h"

#include <cstdint>

namespace vitrine {

/// Where photons and eye paths meet, things must stand where both saw them. Over passes the times are van der Corput's
/// sequence to base 3, shifted by the seed: even over any run of passes, and unlike the wavelengths' (base 2), so that no
/// colour belongs to a time.
double passTime(const Shutter& shutter, std::uint64_t pass, std::uint64_t seed);

} // namespace vitrine
