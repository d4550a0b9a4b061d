// What an evaluation of a plane curve gives.
#pragma once

#include "core/vec.h"

namespace vitrine {

/// Position and derivatives by the curve's parameter.
struct CurvePoint {
    V2d p, d1, d2;
};

/// Bounds of the absolute error of each coordinate over t in [0,1], to the first order in eps.
struct CurvePointError {
    double p = 0, d1 = 0, d2 = 0;
};

} // namespace vitrine
