// What the parameters "displacement" and "normalmap" of every material say.
//
// | name         | type          | unit        | default | meaning |
// |--------------|---------------|-------------|---------|---------|
// | displacement | float texture | scene units | 0       | shaded as if the surface were moved outwards by so much (bump mapping) |
// | normalmap    | string        |             |         | image of normals in tangent space; goes before displacement |
#pragma once

#include "scene/context.h"
#include "textures/surface_detail.h"

namespace vitrine {

/// Null when there is none. Errors are recorded with the parameters. \throws FileError, SceneError
SurfaceDetailPtr findSurfaceDetail(BuildContext& context, const ParameterSet& parameters);

} // namespace vitrine
