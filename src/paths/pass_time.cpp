#include "paths/pass_time.h"

#include "core/random.h"

#include <cmath>

namespace vitrine {

double passTime(const Shutter& shutter, std::uint64_t pass, std::uint64_t seed) {
    double place = unitDouble(streamKey(0x74696d65ull, seed)), digit = 1;
    for (; pass > 0; pass /= 3)
        place += double(pass % 3) * (digit /= 3);
    return shutter.at(place - std::floor(place));
}

} // namespace vitrine
