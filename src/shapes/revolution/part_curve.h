// A part's curve as root finding needs it: point, first and second derivative at once.
#pragma once

#include "shapes/revolution/bezier_curve.h"
#include "shapes/revolution/lanes.h"

namespace vitrine {

struct CurveSample {
    double x, y, dx, dy, ddx, ddy;
};

class PartCurve {
  public:
    explicit PartCurve(const BezierCurve& curve);

    CurveSample at(double t) const { return bernstein_ ? atBernstein(t) : atPower(t); }
    std::size_t memoryBytes() const { return rows_.size() * sizeof(Row); }

  private:
    struct Row {
        Lanes v;
    };
    CurveSample atPower(double t) const;
    CurveSample atBernstein(double t) const;

    double centre_;
    int pairs_, bendPairs_;
    /// Coefficients of (t - centre)^k, rows of (x, y, x', y'), an even number of them; then those of (x'', y''), two
    /// powers a row.
    std::vector<Row> rows_;
    std::optional<BernsteinForm> bernstein_; ///< where powers of t would lose digits
};

inline CurveSample PartCurve::atPower(double t) const {
    const double tau = t - centre_;
    const Lanes square = broadcast(tau * tau);
    // Even and odd powers apart: two chains of operations of half the length.
    const Row* row = rows_.data() + 2 * (pairs_ - 1);
    Lanes even = row[0].v, odd = row[1].v;
    const Row* bend = rows_.data() + 2 * pairs_;
    Lanes second = bend[bendPairs_ - 1].v;
    for (int k = 1; k < pairs_; ++k) {
        row -= 2;
        even = fusedMultiplyAdd(even, square, row[0].v);
        odd = fusedMultiplyAdd(odd, square, row[1].v);
    }
    for (int k = bendPairs_ - 2; k >= 0; --k)
        second = fusedMultiplyAdd(second, square, bend[k].v);
    const Lanes first = fusedMultiplyAdd(odd, broadcast(tau), even);
    return {first[0],
            first[1],
            first[2],
            first[3],
            std::fma(second[2], tau, second[0]),
            std::fma(second[3], tau, second[1])};
}

} // namespace vitrine
