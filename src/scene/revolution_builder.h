// The profile of Shape "revolution": control points, SVG path data or a shape of an SVG file.
#pragma once

#include "scene/context.h"
#include "shapes/revolution/profile.h"

namespace vitrine {

/// \throws SceneError, FileError
Profile buildProfile(BuildContext& context, const ShapeNode& node);

} // namespace vitrine
