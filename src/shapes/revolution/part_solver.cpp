#include "shapes/revolution/part_solver.h"

#include "shapes/revolution/bernstein.h"

namespace vitrine {

PartSolver::PartSolver(const BezierCurve& curve, unsigned index)
    : index_(index), points_(curve.degree() + 1), coefficients_(2 * curve.degree() + 1) {
    const std::vector<double> x = curve.coordinates(0), y = curve.coordinates(1);
    // At a pole x^2 and the ray's distance both vanish: there the height must be exact to keep F's relative accuracy.
    if (x.front() == 0)
        middle_ = y.front();
    else if (x.back() == 0)
        middle_ = y.back();
    else
        middle_ = (y.front() + y.back()) / 2;
    std::vector<double> height = y;
    xMax_ = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        height[i] -= middle_;
        xMax_ = std::max(xMax_, std::abs(x[i]));
    }
    for (int i = 0; i < points_; ++i) {
        const double b = bernstein::binomial(curve.degree(), i);
        numbers_.push_back(b * x[std::size_t(i)]);
        numbers_.push_back(b * y[std::size_t(i)]);
    }
    for (const std::vector<double>& block :
         {x, y, bernstein::multiply(x, x), bernstein::elevate(height, 2 * curve.degree()),
          bernstein::multiply(height, height)})
        numbers_.insert(numbers_.end(), block.begin(), block.end());
}

PartSolver::Sample PartSolver::at(double t) const {
    const double* b = scaled();
    const int n = points_ - 1;
    const bool low = t <= 0.5;
    const double base = low ? 1 - t : t, inverse = 1 / base, z = (low ? t : 1 - t) * inverse;
    // Horner's rule for the value and its derivative by z, from the far end of the coefficients.
    const double* c = low ? b + 2 * n : b;
    const int step = low ? -2 : 2;
    double qx = c[0], qy = c[1], dqx = 0, dqy = 0, power = 1;
    for (int k = 1; k <= n; ++k) {
        c += step;
        dqx = std::fma(dqx, z, qx);
        dqy = std::fma(dqy, z, qy);
        qx = std::fma(qx, z, c[0]);
        qy = std::fma(qy, z, c[1]);
        if (k < n) power *= base;
    }
    // x = base^n q(z), and dz/dt = 1/u^2 or -1/t^2.
    const double full = power * base, sign = low ? power : -power;
    return {full * qx, full * qy, sign * (dqx * inverse - n * qx), sign * (dqy * inverse - n * qy)};
}

} // namespace vitrine
