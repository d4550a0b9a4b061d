// Outlines of SVG as plain Bezier segments. SVG 2, chapter 9 (paths); user space, y as it is written.
#pragma once

#include "core/vec.h"

#include <array>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// A Bezier curve of degree 1 to 3. Lines have degree 1, Q and T 2, C and S 3; an arc becomes several cubics that stay
/// within 1e-6 of its larger radius.
struct SvgSegment {
    std::array<V2d, 4> points{{{0, 0}, {0, 0}, {0, 0}, {0, 0}}}; ///< the first degree + 1 of them count
    int degree = 1;
    std::size_t offset = 0, length = 1; ///< bytes of what draws it, in the text that was read

    std::span<const V2d> controls() const { return {points.data(), std::size_t(degree) + 1}; }
    std::span<V2d> controls() { return {points.data(), std::size_t(degree) + 1}; }
    const V2d& first() const { return points[0]; }
    const V2d& last() const { return points[std::size_t(degree)]; }
};

/// Segments that join: each begins where the one before ends, bit for bit. None has all its points in one place.
struct SvgSubpath {
    std::vector<SvgSegment> segments; ///< at least one
    bool closed = false;              ///< by Z: the line that it may need is among the segments
};

/// Subpaths that draw nothing ("M 1 1 M 2 2 ...") are left out.
struct SvgPath {
    std::vector<SvgSubpath> subpaths;
};

/// What is wrong at some bytes of a text; whoever knows where the text stands makes it a SceneError.
class SvgTextError : public std::runtime_error {
  public:
    SvgTextError(std::size_t at, std::size_t bytes, const std::string& message, std::string remedy = {})
        : std::runtime_error(message), offset(at), length(bytes), hint(std::move(remedy)) {}

    std::size_t offset, length;
    std::string hint;
};

/// Path data (the attribute "d"): M L H V Q C S T A Z and their lower case. Unlike a browser, which draws up to the
/// fault, it refuses what is wrong. \throws SvgTextError
SvgPath readSvgPath(std::string_view data);

} // namespace vitrine
