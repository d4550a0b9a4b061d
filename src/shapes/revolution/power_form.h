// A Bezier curve evaluated in the power basis.
#pragma once

#include "shapes/revolution/curve_point.h"

#include <vector>

namespace vitrine {

/// sum c_k (t - centre)^k: the quickest O(n) evaluation, derivatives by Horner's rule of the same coefficients. Its error
/// is that of sum |c_k| |t - centre|^k, which about the ends grows like 3^n, about the middle like (3/2)^n (Farouki &
/// Rajan 1987, "On the numerical condition of polynomials in Bernstein form"): fit for low degrees and calm curves.
class PowerForm {
  public:
    /// O(n^2), in the machine's widest type: the k-th differences of the control points, evaluated at the centre.
    explicit PowerForm(const std::vector<V2d>& points, double centre = 0.5);

    V2d point(double t) const {
        const double s = t - centre_;
        V2d p = c_.back();
        for (std::size_t k = c_.size() - 1; k-- > 0;)
            p = p * s + c_[k];
        return p;
    }
    CurvePoint evaluate(double t) const {
        const double s = t - centre_;
        V2d p = c_.back(), d(0, 0), half(0, 0);
        for (std::size_t k = c_.size() - 1; k-- > 0;) {
            half = half * s + d;
            d = d * s + p;
            p = p * s + c_[k];
        }
        return {p, d, half * 2.};
    }
    const CurvePointError& error() const { return error_; }
    /// Of (t - centre)^k.
    const std::vector<V2d>& coefficients() const { return c_; }

  private:
    double centre_;
    std::vector<V2d> c_;
    CurvePointError error_;
};

} // namespace vitrine
