#include "shapes/revolution/part_solver.h"

#include "shapes/revolution/bernstein.h"

namespace vitrine {

PartSolver::PartSolver(const BezierCurve& curve, unsigned index)
    : index_(index), points_(curve.degree() + 1), coefficients_(2 * curve.degree() + 1), curve_(curve) {
    const std::vector<double> x = curve.coordinates(0), y = curve.coordinates(1);
    x0_ = x.front();
    y0_ = y.front();
    x1_ = x.back();
    y1_ = y.back();
    const CurveSample half = curve_.at(0.5);
    xHalf_ = half.x;
    yHalf_ = half.y;
    // At a pole x^2 and the ray's distance both vanish: there the height must be exact to keep F's relative accuracy.
    middle_ = x0_ == 0 ? y0_ : x1_ == 0 ? y1_ : (y0_ + y1_) / 2;
    std::vector<double> height = y;
    xMax_ = reach_ = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        height[i] -= middle_;
        xMax_ = std::max(xMax_, std::abs(x[i]));
        reach_ = std::max({reach_, std::abs(x[i]), std::abs(y[i])});
    }
    const std::vector<double> x2 = bernstein::multiply(x, x), y2 = bernstein::multiply(height, height),
                              y1 = bernstein::elevate(height, 2 * curve.degree());
    quadruples_ = (coefficients_ + 3) / 4;
    inLast_ = (1u << ((coefficients_ - 1) % 4)) - 1;
    squares_.resize(std::size_t(quadruples_));
    for (std::size_t k = 0; k < x2.size(); ++k) {
        Quadruple& four = squares_[k / 4];
        four.x2[k % 4] = x2[k];
        four.y1[k % 4] = y1[k];
        four.y2[k % 4] = y2[k];
    }
    control_ = x;
    control_.insert(control_.end(), y.begin(), y.end());
}

std::size_t PartSolver::memoryBytes() const {
    return sizeof(*this) + curve_.memoryBytes() + squares_.size() * sizeof(Quadruple) +
           control_.size() * sizeof(double);
}

} // namespace vitrine
