// The wavelengths that all paths of a pass share.
#pragma once

#include "spectrum/sampled.h"

#include <cstdint>

namespace vitrine {

/// Four stratified wavelengths a pass, so that camera and light paths can merge. Over 2^k passes that begin at a multiple
/// of 2^k all their wavelengths lie at equal steps of the distribution: the place in the strata is van der Corput's
/// sequence, shifted by the seed. Equal steps integrate smooth spectra far better than jittered ones.
SampledWavelengths passWavelengths(std::uint64_t pass, std::uint64_t seed);

/// Which of a pass's wavelengths is the hero of a path, all four alike often: dispersed paths of one pass then show four
/// colours, not one. Spectra go by the pass's order outside of the path (rotated(), rotatedBack()).
///
/// The turns go by the sum of the pass's digits to base 4, not by the pass itself: its last digit is also the first of
/// van der Corput's place, so that a pixel would only ever see the same quarter of each stratum. With the sum, the heroes
/// of one path over 4^k passes that begin at a multiple of 4^k lie one in each of 4^k equal parts of the distribution.
/// \param path index of a photon's path or of a pixel
inline int heroOf(std::uint64_t path, std::uint64_t pass) {
    for (; pass != 0; pass >>= 2)
        path += pass & 3;
    return int(path & 3);
}

} // namespace vitrine
