#include "shapes/revolution/bezier_curve.h"

#include "shapes/revolution/bernstein.h"

#include <stdexcept>

namespace vitrine {

namespace {

std::vector<V2d> differences(const std::vector<V2d>& c) {
    if (c.size() < 2) return {V2d(0, 0)};
    std::vector<V2d> result(c.size() - 1);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = (c[i + 1] - c[i]) * double(result.size());
    return result;
}

std::vector<V2d> scaledByBinomials(std::vector<V2d> c) {
    for (std::size_t i = 0; i < c.size(); ++i)
        c[i] *= bernstein::binomial(int(c.size()) - 1, int(i));
    return c;
}

V2d hornerBernstein(const std::vector<V2d>& scaled, double t) {
    const std::size_t n = scaled.size() - 1;
    const double u = 1 - t;
    double power = 1;
    V2d sum(0, 0);
    if (t <= 0.5) {
        const double z = t / u;
        sum = scaled[n];
        for (std::size_t k = n; k-- > 0; power *= u)
            sum = sum * z + scaled[k];
    } else {
        const double z = u / t;
        sum = scaled[0];
        for (std::size_t k = 1; k <= n; ++k, power *= t)
            sum = sum * z + scaled[k];
    }
    return sum * power;
}

} // namespace

BezierCurve::BezierCurve(std::vector<V2d> points) : points_(std::move(points)) {
    if (points_.size() < 2 || points_.size() > std::size_t(maxDegree) + 1)
        throw std::invalid_argument("a Bezier curve needs 2 to 61 control points, not " +
                                    std::to_string(points_.size()));
    for (const V2d& p : points_)
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw std::invalid_argument("a control point is not finite");
    const std::vector<V2d> d1 = differences(points_);
    scaled_ = scaledByBinomials(points_);
    scaledD1_ = scaledByBinomials(d1);
    scaledD2_ = scaledByBinomials(differences(d1));
}

V2d BezierCurve::point(double t) const {
    return hornerBernstein(scaled_, t);
}

CurvePoint BezierCurve::evaluate(double t) const {
    return {hornerBernstein(scaled_, t), hornerBernstein(scaledD1_, t), hornerBernstein(scaledD2_, t)};
}

std::vector<double> BezierCurve::coordinates(int axis) const {
    std::vector<double> result;
    for (const V2d& p : points_)
        result.push_back(p[axis]);
    return result;
}

std::pair<BezierCurve, BezierCurve> BezierCurve::split(double t) const {
    const std::size_t n = points_.size();
    std::vector<V2d> left(n), right(n);
    for (int axis = 0; axis < 2; ++axis) {
        std::vector<double> c = coordinates(axis), l(n);
        bernstein::split(c.data(), l.data(), int(n), t);
        for (std::size_t i = 0; i < n; ++i)
            left[i][axis] = l[i], right[i][axis] = c[i];
    }
    return {BezierCurve(std::move(left)), BezierCurve(std::move(right))};
}

BezierCurve BezierCurve::part(double ta, double tb) const {
    BezierCurve head = tb < 1 ? split(tb).first : *this;
    return ta > 0 ? head.split(ta / tb).second : head;
}

Imath::Box2d BezierCurve::controlBounds() const {
    Imath::Box2d box;
    for (const V2d& p : points_)
        box.extendBy(p);
    return box;
}

std::vector<double> BezierCurve::extrema(int axis) const {
    const std::vector<double> c = coordinates(axis);
    double largest = 0;
    for (const double x : c)
        largest = std::max(largest, std::abs(x));
    const double noise = 8 * degree() * std::numeric_limits<double>::epsilon() * largest;
    std::vector<double> found;
    for (const double t : bernstein::signChanges(bernstein::derivative(c), noise))
        if (t > 0 && t < 1) found.push_back(t);
    return found;
}

double BezierCurve::areaUnder() const {
    const std::vector<double> integrand = bernstein::multiply(coordinates(0), bernstein::derivative(coordinates(1)));
    double sum = 0;
    for (const double c : integrand)
        sum += c; // every Bernstein polynomial of degree m has the integral 1/(m+1)
    return sum / double(integrand.size());
}

} // namespace vitrine
