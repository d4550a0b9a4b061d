#include "scene/alpha_builder.h"

#include "scene/context.h"
#include "textures/alpha.h"

namespace vitrine {

ShapeAlpha findShapeAlpha(BuildContext& context, const ParameterSet& parameters) {
    const auto alpha = findFloatInput(context, parameters, "alpha");
    if (!alpha) return {};
    if (!alpha->isConstant()) return {std::make_shared<AlphaCutout>(*alpha), false};
    if (alpha->constant() >= 1) return {};
    // Not a number is no part either.
    if (!(alpha->constant() > 0)) return {nullptr, true};
    return {std::make_shared<AlphaCutout>(*alpha), false};
}

} // namespace vitrine
