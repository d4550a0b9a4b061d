// Coordinate systems of SVG (SVG 2, chapter 8): transformations, view boxes, lengths with units. Imath's convention for
// matrices: (x y 1) M.
#pragma once

#include "core/vec.h"

#include <ImathMatrix.h>

#include <optional>
#include <string_view>

namespace vitrine {

using Imath::M33d;

V2d transformed(const V2d& p, const M33d& m);

/// A list of matrix, translate, scale, rotate, skewX and skewY; the last acts first. \throws SvgTextError
M33d readSvgTransform(std::string_view text);

/// What percentages are of: the size of the nearest view box, or of its viewport.
struct SvgExtent {
    V2d size{100, 100};

    /// For lengths that are neither horizontal nor vertical (SVG 2, 8.9).
    double diagonal() const { return size.length() / std::sqrt(2.); }
};

/// A length in user units of 1/96 inch. \throws SvgTextError
double readSvgLength(std::string_view text, double hundredPercent);

/// x, y, width, height. \throws SvgTextError unless width and height are positive
Imath::Box2d readSvgViewBox(std::string_view text);

/// What a view box becomes in a viewport that begins at the origin, by preserveAspectRatio ("" is its default, "xMidYMid
/// meet"). \throws SvgTextError
M33d readSvgFit(std::string_view preserveAspectRatio, const Imath::Box2d& viewBox, const V2d& viewport);

} // namespace vitrine
