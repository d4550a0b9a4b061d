// Outlines of SVG's shape elements (SVG 2, chapters 9 and 10).
#pragma once

#include "nodes/svg_attributes.h"
#include "nodes/svg_coordinates.h"
#include "nodes/svg_path.h"

namespace vitrine {

bool isSvgShape(std::string_view tag);

/// The outline in the element's own coordinates; its offsets are bytes of the file.
/// \param tag one for which isSvgShape() \throws SvgTextError
SvgPath readSvgShape(std::string_view tag, const SvgAttributes& attributes, const SvgExtent& extent);

} // namespace vitrine
