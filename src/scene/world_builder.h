// Shape, material, light and instance nodes -> the world that paths travel through.
#pragma once

#include "paths/world.h"
#include "scene/alpha_builder.h"
#include "scene/context.h"

namespace vitrine {

/// What an integrator does with lights.
struct LightUse {
    LightSampler::Choice choice = LightSampler::Choice::Power;
    bool startsPaths = false; ///< at the lights
    Place integrator;         ///< where it stands; none if it is the command line's
};

/// Everything but the camera; bounds hold what moves while the shutter is open. Shapes that are wrong are left out and recorded in the context's diagnostics.
World buildWorld(BuildContext& context, const LightUse& lightUse, const Shutter& shutter);

// The families, one table each.

/// The shapes of a node, where they start: one, or two for a bilinear mesh with planar and curved patches.
std::vector<ShapePtr> buildShape(BuildContext& context, const ShapeNode& node);

/// All of the scene's, in the order of its nodes; null for those that are wrong (then recorded).
std::vector<MaterialPtr> buildMaterials(BuildContext& context);

/// A light of LightSource.
LightPtr buildLight(BuildContext& context, const LightNode& node, const Shutter& shutter);

/// The light of one of the shapes of a node under AreaLightSource `node`; `shapes` are all that the node made, as
/// `power` is theirs together.
std::vector<std::shared_ptr<AreaLight>> buildAreaLights(BuildContext& context, const Node& node,
                                                        const std::vector<ShapePtr>& shapes,
                                                        const ShapeAlpha& alpha = {});

} // namespace vitrine
