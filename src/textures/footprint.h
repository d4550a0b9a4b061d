// The patch of a surface that a pixel sees.
#pragma once

#include "shapes/shape.h"
#include "textures/texture.h"

namespace vitrine {

/// Fills the derivatives of `at` for a beam of this width (world units) that meets the surface along `d` (unit): an ellipse
/// as wide as the beam across its slope. A cone follows the path in place of ray differentials (Akenine-Moeller et al. 2021,
/// "Improved shader and texture level of detail using ray cones"); curved mirrors and lenses do not change it.
void spreadOver(const SurfacePoint& surface, const V3f& d, float width, TexturePoint& at);

} // namespace vitrine
