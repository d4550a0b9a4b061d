// Which lights certainly lie in the same solids all over.
#pragma once

#include "accel/caster.h"
#include "paths/world.h"

namespace vitrine {

/// Of each of the lights, whether it is a single point or no surface that bounds a solid comes near its box. Then looking
/// once for the solids round it serves for all rays that it emits (World::undividedLights).
/// \param surfaces by the shapes' numbers
std::vector<bool> findUndividedLights(const CasterInput& input, const std::vector<Surface>& surfaces,
                                      const std::vector<LightPtr>& lights);

} // namespace vitrine
