#pragma once

#include "plot/figure.h"

#include <cstddef>

namespace vitrine::plot {

/// The bytes of a PNG file of the figure, on white.
/// \throws std::invalid_argument when it would have more pixels a side than Cairo draws (32767)
std::vector<std::byte> toPng(const Figure& figure, double pixelsPerPoint);

} // namespace vitrine::plot
