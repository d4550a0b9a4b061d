// Colours and pens that all panels share. The two colours of segments are told apart by any eye, and in grey.
#pragma once

#include "plot/figure.h"

namespace vitrine::plot {

inline constexpr Colour ink{34, 34, 40}, paper{255, 255, 255}, faintInk{110, 112, 120};
inline constexpr Colour gridInk{228, 230, 235}, axisInk{120, 124, 134};
inline constexpr Colour segmentInk[] = {{24, 92, 168}, {214, 106, 12}};
inline constexpr Colour polygonInk{128, 130, 138}, solidInk{120, 170, 210};
inline constexpr Colour combInk{20, 140, 120}, rayInk{120, 40, 140}, rootInk{200, 20, 50};

inline const Colour& colourOfSegment(std::size_t i) {
    return segmentInk[i % 2];
}

} // namespace vitrine::plot
