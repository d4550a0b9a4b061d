// A Bezier curve evaluated in the Bernstein basis.
#pragma once

#include "shapes/revolution/curve_point.h"

#include <vector>

namespace vitrine {

/// O(n) a point: Horner's rule on the control points times the binomials, in t/(1-t) or its reciprocal, whichever is at
/// most 1. All weights are positive and sum to 1, so that a relative change of some (2n+2) eps in the control points
/// explains the error. Exact at both ends; a coordinate that vanishes at an end keeps its relative accuracy there.
class BernsteinForm {
  public:
    explicit BernsteinForm(const std::vector<V2d>& points);

    V2d point(double t) const;
    CurvePoint evaluate(double t) const;
    const CurvePointError& error() const { return error_; }

  private:
    std::vector<V2d> scaled_, scaledD1_, scaledD2_; ///< coefficients times the binomials
    CurvePointError error_;
};

} // namespace vitrine
