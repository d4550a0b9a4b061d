// The profile of Shape "revolution": control points, SVG path data or a shape of an SVG file.
#pragma once

#include "nodes/svg_file.h"
#include "scene/context.h"
#include "scene/drawn_profile.h"

namespace vitrine {

/// \throws SceneError, FileError
Profile buildProfile(BuildContext& context, const ShapeNode& node);

/// Where a file's drawing goes by the parameters "origin", "axis", "flipx", "flipy", "scale", "unit". \throws SceneError
ProfileFrame frameOfFile(const ParameterSet& parameters, const SvgDrawing& drawing);

} // namespace vitrine
