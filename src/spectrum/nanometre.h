// Tables with one entry a nanometre over the visible range.
#pragma once

#include "spectrum/sampled.h"

namespace vitrine {

/// Entries of a table over 360, 361 ... 830 nm, with a zero before and one after them: no branch for what lies outside.
inline constexpr int nanometres = 471, nanometreSlots = nanometres + 2;

using SlotLanes [[gnu::vector_size(16)]] = int;

/// The slots of the nearest whole nanometres, halves up (pbrt-v4 rounds so). NaN goes to the zero in front.
inline SlotLanes nanometreSlot(SampledSpectrum::Lanes lambda) {
    // Exact: lambda is in [256, 1024) and the difference smaller.
    SampledSpectrum::Lanes position = lambda - (lambdaMin - 1.5f);
    const SampledSpectrum::Lanes first{}, last = first + float(nanometreSlots - 1);
    position = position > first ? position : first;
    position = position < last ? position : last;
    return __builtin_convertvector(position, SlotLanes);
}

inline int nanometreSlot(float lambda) {
    const float position = lambda - (lambdaMin - 1.5f);
    return int(std::min(position > 0 ? position : 0.f, float(nanometreSlots - 1)));
}

} // namespace vitrine
