// The files that a scene reads, gathered beside its text.
#pragma once

#include "scene/plain_scene.h"

namespace vitrine {

/// Makes every parameter that names a file name its copy in the folder "resources", and lists the copies. Files of the same
/// name get numbers. What the film writes stays.
void gatherResources(PlainScene& scene);

} // namespace vitrine
