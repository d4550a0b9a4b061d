// A plane Bezier curve of any degree up to 60.
#pragma once

#include "core/vec.h"

#include <span>
#include <utility>
#include <vector>

namespace vitrine {

/// Position and derivatives by the curve's parameter.
struct CurvePoint {
    V2d p, d1, d2;
};

class BezierCurve {
  public:
    static constexpr int maxDegree = 60;

    /// \throws std::invalid_argument unless there are 2 to 61 finite points.
    explicit BezierCurve(std::vector<V2d> points);

    int degree() const { return int(points_.size()) - 1; }
    const std::vector<V2d>& points() const { return points_; }
    const V2d& first() const { return points_.front(); }
    const V2d& last() const { return points_.back(); }

    /// In O(n): Horner's rule on the scaled Bernstein form, in t/(1-t) or its reciprocal, whichever is at most 1.
    /// Backward stable: a relative change of O(n eps) in the control points explains the error.
    V2d point(double t) const;
    CurvePoint evaluate(double t) const;

    /// The part over [ta, tb], by de Casteljau.
    BezierCurve part(double ta, double tb) const;
    std::pair<BezierCurve, BezierCurve> split(double t) const;

    /// Of the control polygon; the curve lies inside.
    Imath::Box2d controlBounds() const;
    /// Parameters in (0,1), ascending, where x' (axis 0) or y' (axis 1) changes sign.
    std::vector<double> extrema(int axis) const;
    /// Integral of x dy over the curve, exact up to rounding.
    double areaUnder() const;

    std::vector<double> coordinates(int axis) const;

  private:
    std::vector<V2d> points_;
    std::vector<V2d> scaled_, scaledD1_, scaledD2_; ///< times the binomials
};

} // namespace vitrine
