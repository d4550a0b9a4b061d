// What the parameter "alpha" of every shape says.
//
// | name  | type             | unit | default | meaning |
// |-------|------------------|------|---------|---------|
// | alpha | float or texture | 1    | 1       | the share of rays, shadow rays too, that the surface stops; 0: as if it were not there |
#pragma once

#include "accel/cutout.h"
#include "nodes/parameters.h"

namespace vitrine {

class BuildContext;

struct ShapeAlpha {
    CutoutPtr cutout;      ///< null: no holes
    bool isUnseen = false; ///< 0 throughout: only as a light it is there
};

/// Errors are recorded with the parameters, to be reported with the shape's others.
ShapeAlpha findShapeAlpha(BuildContext& context, const ParameterSet& parameters);

} // namespace vitrine
