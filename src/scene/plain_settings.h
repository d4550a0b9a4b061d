// Integrators and materials of ours, as pbrt-v4 can say them.
#pragma once

#include "nodes/nodes.h"

namespace vitrine {

/// Absorption as a homogeneous medium in the shapes that have the material; priorities are dropped with a warning. Returns
/// whether there are media now.
bool interiorsAsMedia(SceneNodes& scene, Diagnostics& diagnostics);

/// The integrator's type and parameters as pbrt-v4 has them; what it has not is dropped with a warning.
/// \param needsVolumes paths must follow media and pass surfaces without a material
Node plainIntegrator(const Node& integrator, bool needsVolumes, Diagnostics& diagnostics);

} // namespace vitrine
