// Integrator node -> integrator.
#pragma once

#include "core/sampler.h"
#include "integrators/integrator.h"
#include "scene/context.h"
#include "scene/overrides.h"
#include "scene/world_builder.h"

namespace vitrine {

struct IntegratorPlan {
    std::unique_ptr<Integrator> integrator;
    LightUse lights;
    std::optional<std::uint64_t> passes; ///< in place of the sampler's number of samples
};
IntegratorPlan buildIntegrator(BuildContext& context, const Overrides& overrides, const SamplerSettings& sampler);

} // namespace vitrine
