// From an outline in a drawing to a profile in the half-plane of radius and height.
#pragma once

#include "core/errors.h"
#include "nodes/svg_path.h"
#include "shapes/revolution/profile.h"

#include <functional>

namespace vitrine {

/// Where the axis lies in a drawing, and how long its units are.
struct ProfileFrame {
    V2d scenePerUnit{1, 1}; ///< of x and y of the drawing
    V2d origin{0, 0};       ///< becomes radius 0, height 0; in units of the drawing
    bool flipX = false, flipY = false;
    bool lying = false; ///< the axis runs along x of the drawing, not along y

    /// (radius, height) of a point of the drawing.
    V2d operator()(const V2d& p) const;
};

/// What does not lie on the axis exactly, but within this of the profile's extent, is meant to: Inkscape writes eight
/// digits, and the errors of relative coordinates add up. The same holds for ends that nearly meet and for segments
/// that are no longer than this.
constexpr double drawingTolerance = 1e-6;

/// A segment takes up to 20 kilobytes of a revolution: parts, their solvers and tables.
constexpr std::size_t mostSegments = 10000;

/// \param placeOf where a segment is written
/// \throws SceneError when the outline is no profile: several lines, a radius below zero ...
Profile profileOfDrawing(const SvgPath& path, const ProfileFrame& frame,
                         const std::function<Place(const SvgSegment&)>& placeOf);

} // namespace vitrine
