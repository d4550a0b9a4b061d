#pragma once

#include "plot/figure.h"

namespace vitrine::plot {

/// The figure as the text of an SVG 1.1 file. Texts stay texts, groups are `<g class="name">`.
std::string toSvg(const Figure& figure);

} // namespace vitrine::plot
