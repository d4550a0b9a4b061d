// Degree elevation and reduction of Bezier curves.
#include "shapes/revolution/bernstein.h"
#include "shapes/revolution/bezier_curve.h"

#include <fmt/format.h>

#include <stdexcept>

namespace vitrine {

namespace {

BezierCurve fromCoordinates(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<V2d> points;
    for (std::size_t i = 0; i < x.size(); ++i)
        points.emplace_back(x[i], y[i]);
    return BezierCurve(std::move(points));
}

/// Bernstein coefficients of the Jacobi polynomial P_n^(2,2)(2t - 1): orthogonal on [0,1] for the weight t^2 (1-t)^2.
std::vector<double> jacobi(int n) {
    std::vector<double> c;
    for (int k = 0; k <= n; ++k) {
        const double magnitude =
            bernstein::binomial(n + 2, k) * bernstein::binomial(n + 2, n - k) / bernstein::binomial(n, k);
        c.push_back((n - k) % 2 == 0 ? magnitude : -magnitude);
    }
    return c;
}

/// The coefficient of t^n, in long double: alternating sums cancel.
long double leading(const std::vector<double>& c) {
    const int n = int(c.size()) - 1;
    long double sum = 0;
    for (int k = 0; k <= n; ++k)
        sum += ((n - k) % 2 == 0 ? 1 : -1) * (long double)(bernstein::binomial(n, k)) * c[std::size_t(k)];
    return sum;
}

/// The same polynomial in one degree less, which it must have: from either end as far as the middle, where the recurrence
/// of elevation still damps errors (Forrest 1972, "Interactive interpolation and approximation by Bezier polynomials").
std::vector<double> lowered(const std::vector<double>& c) {
    const std::size_t n = c.size() - 1;
    std::vector<double> result(n);
    for (std::size_t k = 0; k < (n + 1) / 2; ++k) {
        const double before = k > 0 ? result[k - 1] : 0;
        result[k] = (double(n) * c[k] - double(k) * before) / double(n - k);
    }
    for (std::size_t k = n; k > (n + 1) / 2; --k) {
        const double after = k < n ? result[k] : 0;
        result[k - 1] = (double(n) * c[k] - double(n - k) * after) / double(k);
    }
    return result;
}

/// With the ends' straight line L, p - L = t (1-t) w; among polynomials of lower degree with p's ends, that one is
/// nearest whose w is the truncated series of w in Jacobi polynomials, as the square of t (1-t) is their weight.
std::vector<double> reducedCoordinates(const std::vector<double>& p, int degree) {
    const int n = int(p.size()) - 1;
    const auto line = [&](int k, int of) { return lerp(double(k) / of, p.front(), p.back()); };
    std::vector<double> w;
    for (int k = 1; k < n; ++k)
        w.push_back((p[std::size_t(k)] - line(k, n)) * n * (n - 1) / (double(k) * (n - k)));
    for (int m = n - 2; m > degree - 2 && m > 0; --m) {
        const std::vector<double> term = jacobi(m);
        const double factor = double(leading(w) / leading(term));
        for (std::size_t k = 0; k < w.size(); ++k)
            w[k] -= factor * term[k];
        w = lowered(w);
    }
    std::vector<double> result{p.front()};
    for (int k = 1; k < degree; ++k)
        result.push_back(line(k, degree) + w[std::size_t(k - 1)] * k * (degree - k) / (double(degree) * (degree - 1)));
    result.push_back(p.back());
    return result;
}

/// Bound of |e(t)| by the control points of its 32 pieces, each of which lies in their hull.
double farthest(const BezierCurve& e, int halvings) {
    if (halvings > 0) {
        const auto [left, right] = e.split(0.5);
        return std::max(farthest(left, halvings - 1), farthest(right, halvings - 1));
    }
    double result = 0;
    for (const V2d& p : e.points())
        result = std::max(result, p.length());
    return result;
}

} // namespace

BezierCurve BezierCurve::elevated(int degree) const {
    if (degree < this->degree() || degree > maxDegree)
        throw std::invalid_argument(
            fmt::format("a curve of degree {} cannot be elevated to degree {}", this->degree(), degree));
    return fromCoordinates(bernstein::elevate(coordinates(0), degree), bernstein::elevate(coordinates(1), degree));
}

BezierCurve::Reduced BezierCurve::reduced(int degree) const {
    if (degree < 1 || degree >= this->degree())
        throw std::invalid_argument(
            fmt::format("a curve of degree {} cannot be reduced to degree {}", this->degree(), degree));
    BezierCurve result =
        fromCoordinates(reducedCoordinates(coordinates(0), degree), reducedCoordinates(coordinates(1), degree));
    std::vector<V2d> difference = result.elevated(this->degree()).points();
    double size = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        difference[i] -= points_[i];
        size = std::max({size, std::abs(points_[i].x), std::abs(points_[i].y)});
    }
    const double rounding = 8 * this->degree() * std::numeric_limits<double>::epsilon() * size;
    return {std::move(result), farthest(BezierCurve(std::move(difference)), 5) + rounding};
}

} // namespace vitrine
