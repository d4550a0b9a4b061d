#include "paths/pass_wavelengths.h"

#include "core/random.h"

namespace vitrine {

SampledWavelengths passWavelengths(std::uint64_t pass, std::uint64_t seed) {
    auto place = std::uint32_t(streamKey(0x6c616d626461ull, seed));
    // Van der Corput's sequence: the pass's bits behind the binary point, mirrored.
    for (std::uint32_t i = std::uint32_t(pass), half = 1u << 31; i != 0; i >>= 1, half >>= 1)
        if (i & 1) place += half;
    return SampledWavelengths::picture(unitFloat(place >> 2));
}

} // namespace vitrine
