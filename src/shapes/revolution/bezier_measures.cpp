// Arc length and curvature of Bezier curves.
#include "shapes/quadrature.h"
#include "shapes/revolution/bernstein.h"
#include "shapes/revolution/bezier_curve.h"

namespace vitrine {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

double polygonLength(const std::vector<V2d>& points) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        sum += (points[i + 1] - points[i]).length();
    return sum;
}

/// The integral of the speed, cut where it is extreme: a cusp, or almost one, makes a corner there, which could hide
/// between the last node of a panel and its end.
class SpeedIntegral {
  public:
    explicit SpeedIntegral(const BezierCurve& curve)
        : curve_(curve), cuts_(curve.speedExtrema()), polygon_(polygonLength(curve.points())) {}

    BezierCurve::Length over(double ta, double tb) const {
        BezierCurve::Length total{0, 4 * curve_.degree() * eps * polygon_};
        double from = ta;
        for (const double cut : cuts_)
            if (cut > from && cut < tb) {
                add(from, cut, estimate(from, cut), maxHalvings, total);
                from = cut;
            }
        add(from, tb, estimate(from, tb), maxHalvings, total);
        return total;
    }

  private:
    static constexpr int maxHalvings = 40;

    double estimate(double ta, double tb) const {
        return integratePanels([&](double t) { return curve_.evaluate(t).d1.length(); }, ta, tb, 1);
    }
    void add(double ta, double tb, double whole, int depth, BezierCurve::Length& total) const {
        const double tm = (ta + tb) / 2, left = estimate(ta, tm), right = estimate(tm, tb);
        const double change = std::abs(left + right - whole);
        if (change <= 0x1p-46 * polygon_ || depth == 0) {
            total.value += left + right;
            total.error += change;
        } else {
            add(ta, tm, left, depth - 1, total);
            add(tm, tb, right, depth - 1, total);
        }
    }

    const BezierCurve& curve_;
    std::vector<double> cuts_;
    double polygon_;
};

} // namespace

std::vector<double> BezierCurve::speedExtrema() const {
    std::vector<double> slope; // of the squared speed, halved: c' . c''
    double largest = 0;
    for (int axis = 0; axis < 2; ++axis) {
        const std::vector<double> d1 = bernstein::derivative(coordinates(axis));
        const std::vector<double> product = bernstein::multiply(d1, bernstein::derivative(d1));
        slope.resize(product.size());
        for (std::size_t i = 0; i < product.size(); ++i) {
            slope[i] += product[i];
            largest = std::max(largest, std::abs(product[i]));
        }
    }
    std::vector<double> found = bernstein::signChanges(slope, 8 * degree() * eps * largest);
    std::erase_if(found, [](double t) { return !(t > 0 && t < 1); });
    return found;
}

BezierCurve::Length BezierCurve::length(double ta, double tb) const {
    return SpeedIntegral(*this).over(ta, tb);
}

double BezierCurve::parameterAtLength(double length) const {
    const SpeedIntegral integral(*this);
    const double total = integral.over(0, 1).value;
    if (!(length > 0)) return 0;
    if (!(length < total)) return 1;
    double ta = 0, tb = 1, t = length / total, reached = 0, from = 0;
    // Newton's method, kept in the bracket by bisection; each step integrates only the way it went.
    for (int i = 1; i < 100; ++i) {
        reached += t >= from ? integral.over(from, t).value : -integral.over(t, from).value;
        from = t;
        (reached < length ? ta : tb) = t;
        double next = t + (length - reached) / evaluate(t).d1.length();
        if (!(next >= ta && next <= tb) || i % 8 == 0) next = (ta + tb) / 2;
        const double step = std::abs(next - t);
        t = next;
        if (step <= eps * t) break;
    }
    return t;
}

namespace {

/// Curvature where the derivative vanishes. Of c(t) = a t^m + ... + b t^(m+j) + ..., b the first coefficient that is not
/// along a, it goes like t^(j-m) (m+j) j / m^2 (a x b) / |a|^3.
/// \param noise of the control points
double limitOfCurvature(std::vector<V2d> difference, double noise) {
    const std::size_t n = difference.size() - 1;
    double binomial = 1;
    std::size_t m = 0;
    V2d a(0, 0);
    for (std::size_t k = 1; k <= n; ++k) {
        for (std::size_t i = 0; i + 1 < difference.size(); ++i)
            difference[i] = difference[i + 1] - difference[i];
        difference.pop_back();
        binomial *= double(n - k + 1) / double(k);
        noise *= 2;
        const V2d c = difference[0] * binomial; // of t^k
        const double coefficientNoise = noise * binomial;
        if (m == 0) {
            if (c.length() > coefficientNoise) m = k, a = c;
            continue;
        }
        const double cross = a.cross(c);
        if (std::abs(cross) <= coefficientNoise * a.length()) continue;
        const std::size_t j = k - m;
        if (j > m) return 0;
        if (j < m) return std::copysign(infinityD, cross);
        return 2 * cross / (a.length() * a.length2());
    }
    return 0;
}

} // namespace

double BezierCurve::curvature(double t) const {
    const CurvePoint c = evaluate(t);
    const double speed = c.d1.length();
    if (speed > 16 * bernstein_.error().d1) return c.d1.cross(c.d2) / (speed * speed * speed);
    const double noise = 4 * pointError();
    if (t < 1) return limitOfCurvature(split(t).second.points_, noise);
    return -limitOfCurvature({points_.rbegin(), points_.rend()}, noise); // the way back turns the other way
}

} // namespace vitrine
