// The parameters of textures that say where they lie.
#pragma once

#include "scene/context.h"
#include "textures/mapping.h"

namespace vitrine {

/// The mapping of a 2D texture; a wrong one is recorded, and "uv" returned.
/// \throws std::invalid_argument for one that makes no sense
MappingPtr findMapping(BuildContext& context, const TextureNode& node);

/// The space of a 3D texture. A moving one is recorded as an error.
TextureSpace findTextureSpace(BuildContext& context, const TextureNode& node);

} // namespace vitrine
