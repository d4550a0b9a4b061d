#include "paths/pass_wavelengths.h"

#include "core/random.h"

namespace vitrine {

SampledWavelengths passWavelengths(std::uint64_t pass, std::uint64_t seed) {
    const auto shift = std::uint32_t(streamKey(0x6c616d626461ull, seed));
    const std::uint32_t place = shift + reverseBits(std::uint32_t(pass)); // van der Corput's sequence
    return SampledWavelengths::picture(unitFloat(place >> 2));
}

} // namespace vitrine
