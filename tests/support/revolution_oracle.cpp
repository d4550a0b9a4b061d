#include "support/revolution_oracle.h"

namespace vitrine::test {

double sizeOf(const ProfilePoints& profile) {
    double size = 0;
    for (const std::vector<V2d>& segment : profile)
        for (const V2d& p : segment)
            size = std::max({size, std::abs(p.x), std::abs(p.y)});
    return size;
}

namespace {

std::vector<long double> withBinomials(std::vector<long double> c) {
    long double binomial = 1;
    const std::size_t n = c.size() - 1;
    for (std::size_t k = 0; k <= n; ++k) {
        c[k] *= binomial;
        binomial = binomial * (long double)(n - k) / (long double)(k + 1);
    }
    return c;
}

struct Pair {
    long double x, y;
};

/// Two polynomials at once: their chains of operations do not wait for each other.
Pair horner(const std::vector<long double>& cx, const std::vector<long double>& cy, long double t) {
    if (cx.size() == 1) return {cx[0], cy[0]};
    const long double u = 1 - t;
    long double power = 1, x = cx[0] * u, y = cy[0] * u;
    for (std::size_t k = 1; k + 1 < cx.size(); ++k) {
        power *= t;
        x = (x + power * cx[k]) * u;
        y = (y + power * cy[k]) * u;
    }
    power *= t;
    return {x + power * cx.back(), y + power * cy.back()};
}

} // namespace

SlowCurve::SlowCurve(const std::vector<V2d>& points) {
    for (const V2d& p : points)
        x_.push_back(p.x), y_.push_back(p.y);
    const long double n = (long double)(points.size() - 1);
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
        dx_.push_back(n * (x_[k + 1] - x_[k])), dy_.push_back(n * (y_[k + 1] - y_[k]));
    for (std::vector<long double>* c : {&x_, &y_, &dx_, &dy_})
        *c = withBinomials(std::move(*c));
}

SlowCurve::Sample SlowCurve::at(long double t) const {
    const Pair p = horner(x_, y_, t), d = horner(dx_, dy_, t);
    return {p.x, p.y, d.x, d.y};
}

HalfPlaneRay::HalfPlaneRay(const Ray& ray) {
    const long double dx = ray.d.x, dy = ray.d.y, dz = ray.d.z;
    const long double horizontal = std::sqrt(dx * dx + dz * dz);
    length = std::sqrt(horizontal * horizontal + dy * dy);
    ux = horizontal > 0 ? dx / horizontal : 1;
    uz = horizontal > 0 ? dz / horizontal : 0;
    h = horizontal / length;
    v = dy / length;
    q = ray.o.x * ux + ray.o.z * uz;
    e = std::fabs(ray.o.x * uz - ray.o.z * ux);
    oy = ray.o.y;
}

long double HalfPlaneRay::lengthAt(long double x, long double y, bool forward) const {
    // An error in the radius moves the place by x / (h g), one in the height by 1 / v.
    const long double g = width(x);
    if (g * h > std::fabs(v) * x || v == 0) return ((forward ? g : -g) - q) / h;
    return (y - oy) / v;
}

long double distanceFromCurve(const SlowCurve& curve, double t, long double r, long double y) {
    const SlowCurve::Sample c = curve.at(t);
    const long double speed = std::hypot(c.dx, c.dy), ex = r - c.x, ey = y - c.y;
    if (speed < 1e-3L) return std::hypot(ex, ey);
    // What is along the tangent is an error of t, not of the point.
    const long double along = (ex * c.dx + ey * c.dy) / speed, across = (ex * c.dy - ey * c.dx) / speed;
    return std::fabs(along) < 1e-7L ? std::fabs(across) : std::hypot(ex, ey);
}

} // namespace vitrine::test
