// Integrator node -> integrator.
#pragma once

#include "core/sampler.h"
#include "integrators/integrator.h"
#include "scene/context.h"
#include "scene/overrides.h"

namespace vitrine {

std::unique_ptr<Integrator> buildIntegrator(BuildContext& context, const Overrides& overrides,
                                            const SamplerSettings& sampler);

} // namespace vitrine
