// A plane Bezier curve of any degree up to 60.
#pragma once

#include "shapes/revolution/bernstein_form.h"
#include "shapes/revolution/power_form.h"

#include <optional>
#include <utility>
#include <vector>

namespace vitrine {

class BezierCurve {
  public:
    static constexpr int maxDegree = 60;

    /// \throws std::invalid_argument unless there are 2 to 61 finite points.
    explicit BezierCurve(std::vector<V2d> points);

    int degree() const { return int(points_.size()) - 1; }
    const std::vector<V2d>& points() const { return points_; }
    const V2d& first() const { return points_.front(); }
    const V2d& last() const { return points_.back(); }
    std::vector<double> coordinates(int axis) const;

    /// In O(n), in the power basis where that is as accurate (usesPowerBasis()), else in Bernstein's. Next to the ends
    /// always in the latter: exact there, and relatively accurate where a coordinate vanishes (a pole).
    V2d point(double t) const { return power_ && isInner(t) ? power_->point(t) : bernstein_.point(t); }
    CurvePoint evaluate(double t) const { return power_ && isInner(t) ? power_->evaluate(t) : bernstein_.evaluate(t); }
    /// Whether the bound of the power basis's error is no larger than that of Bernstein's; four times as large for the
    /// derivatives, which steer directions only.
    bool usesPowerBasis() const { return power_.has_value(); }
    /// Bound of either coordinate's error in point(): at most (2n + 2) eps of the largest control point.
    double pointError() const { return bernstein_.error().p; }

    /// The part over [ta, tb], by de Casteljau.
    BezierCurve part(double ta, double tb) const { return BezierCurve(partPoints(ta, tb)); }
    std::vector<V2d> partPoints(double ta, double tb) const;
    std::pair<BezierCurve, BezierCurve> split(double t) const;
    /// The hodograph: the derivative by t as a curve, of one degree less (of a line: its one point twice).
    BezierCurve derivative() const;

    /// Of the control polygon; the curve lies inside.
    Imath::Box2d controlBounds() const;
    /// Of the curve, tight but for rounding.
    Imath::Box2d bounds() const;
    /// Parameters in (0,1), ascending, where x' (axis 0) or y' (axis 1) changes sign.
    std::vector<double> extrema(int axis) const;
    /// Those of both axes: between them the curve is monotone in x and in y.
    std::vector<double> monotoneCuts() const;
    /// Parameters in (0,1), ascending, where the speed |c'| is least or greatest.
    std::vector<double> speedExtrema() const;
    /// Integral of x dy over the curve, exact up to rounding.
    double areaUnder() const;

    /// The same curve in a higher degree.
    BezierCurve elevated(int degree) const;
    /// See reduced().
    struct Reduced;
    /// The curve of a lower degree with the same ends that is nearest in the mean square over t (Eck 1995, "Least squares
    /// degree reduction of Bezier curves").
    /// \throws std::invalid_argument for a degree below 1 or not below this one's
    Reduced reduced(int degree) const;

    struct Length {
        double value;
        double error; ///< of quadrature and rounding
    };
    /// Arc length over [ta, tb], by adaptive Gauss-Legendre quadrature; cusps only cost time. The error is the sum of
    /// what the last halvings changed, which for a smooth stretch is more than is left by some orders of magnitude.
    Length length(double ta = 0, double tb = 1) const;
    /// Where the length from the beginning on is `length`, clamped to [0,1].
    double parameterAtLength(double length) const;

    /// Signed by the way the tangent turns, positive to the left. Where the derivative vanishes (a cusp, coinciding
    /// control points) the limit from the right, at t = 1 from the left: plus or minus infinity at an ordinary cusp, 0
    /// where the curve is straight.
    double curvature(double t) const;

  private:
    static bool isInner(double t) { return t > 0x1p-6 && t < 1 - 0x1p-6; }

    std::vector<V2d> points_;
    BernsteinForm bernstein_;
    std::optional<PowerForm> power_;
};

struct BezierCurve::Reduced {
    BezierCurve curve;
    double error; ///< bound of the distance between points of the same parameter
};

} // namespace vitrine
