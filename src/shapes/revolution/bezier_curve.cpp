#include "shapes/revolution/bezier_curve.h"

#include "shapes/revolution/bernstein.h"

#include <stdexcept>

namespace vitrine {

namespace {

std::vector<V2d> checked(std::vector<V2d> points) {
    if (points.size() < 2 || points.size() > std::size_t(BezierCurve::maxDegree) + 1)
        throw std::invalid_argument("a Bezier curve needs 2 to 61 control points, not " +
                                    std::to_string(points.size()));
    for (const V2d& p : points)
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw std::invalid_argument("a control point is not finite");
    return points;
}

std::vector<double> coordinatesOf(const std::vector<V2d>& points, int axis) {
    std::vector<double> result;
    for (const V2d& p : points)
        result.push_back(p[axis]);
    return result;
}

using Halves = std::pair<std::vector<V2d>, std::vector<V2d>>;

Halves splitPoints(const std::vector<V2d>& points, double t) {
    const std::size_t n = points.size();
    Halves halves{std::vector<V2d>(n), std::vector<V2d>(n)};
    std::vector<double> left(n);
    for (int axis = 0; axis < 2; ++axis) {
        std::vector<double> right = coordinatesOf(points, axis);
        bernstein::split(right.data(), left.data(), int(n), t);
        for (std::size_t i = 0; i < n; ++i)
            halves.first[i][axis] = left[i], halves.second[i][axis] = right[i];
    }
    return halves;
}

} // namespace

BezierCurve::BezierCurve(std::vector<V2d> points) : points_(checked(std::move(points))), bernstein_(points_) {
    // Above this degree the power basis serves none but nearly straight curves, and its preparation is slow.
    constexpr int maxPowerDegree = 12;
    if (degree() > maxPowerDegree) return;
    const PowerForm power(points_);
    const CurvePointError &stable = bernstein_.error(), &quick = power.error();
    if (quick.p <= stable.p && quick.d1 <= 4 * stable.d1 && quick.d2 <= 4 * stable.d2) power_ = power;
}

std::vector<double> BezierCurve::coordinates(int axis) const {
    return coordinatesOf(points_, axis);
}

std::pair<BezierCurve, BezierCurve> BezierCurve::split(double t) const {
    Halves halves = splitPoints(points_, t);
    return {BezierCurve(std::move(halves.first)), BezierCurve(std::move(halves.second))};
}

std::vector<V2d> BezierCurve::partPoints(double ta, double tb) const {
    std::vector<V2d> head = tb < 1 ? splitPoints(points_, tb).first : points_;
    return ta > 0 ? splitPoints(head, ta / tb).second : std::move(head);
}

BezierCurve BezierCurve::derivative() const {
    std::vector<V2d> d;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i)
        d.push_back((points_[i + 1] - points_[i]) * double(degree()));
    if (d.size() == 1) d.push_back(d[0]);
    return BezierCurve(std::move(d));
}

Imath::Box2d BezierCurve::controlBounds() const {
    Imath::Box2d box;
    for (const V2d& p : points_)
        box.extendBy(p);
    return box;
}

Imath::Box2d BezierCurve::bounds() const {
    Imath::Box2d box;
    box.extendBy(first());
    box.extendBy(last());
    for (const double t : monotoneCuts())
        box.extendBy(point(t));
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

std::vector<double> BezierCurve::monotoneCuts() const {
    std::vector<double> cuts = extrema(0);
    const std::vector<double> others = extrema(1);
    cuts.insert(cuts.end(), others.begin(), others.end());
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

double BezierCurve::areaUnder() const {
    const std::vector<double> integrand = bernstein::multiply(coordinates(0), bernstein::derivative(coordinates(1)));
    double sum = 0;
    for (const double c : integrand)
        sum += c; // every Bernstein polynomial of degree m has the integral 1/(m+1)
    return sum / double(integrand.size());
}

} // namespace vitrine
