// Rays that are not nearly horizontal: one polynomial of degree 2n.
#include "shapes/revolution/bernstein.h"
#include "shapes/revolution/part_solver.h"

namespace vitrine {

void PartSolver::solveSteep(HitCollector& hits) const {
    const AxialRay& ray = hits.ray();
    const double v2 = sqr(ray.v), h2 = sqr(ray.h), p = ray.P(middle_);
    const double linear = 2 * ray.h * p, constant = sqr(p) + v2 * sqr(ray.e);
    const double *x2 = xSquared(), *y1 = raised(), *y2 = squared();
    double c[maxCoefficients];
    for (int k = 0; k < coefficients_; ++k)
        c[k] = (h2 * y2[k] + linear * y1[k]) + (constant - v2 * x2[k]);
    const int last = coefficients_ - 1;
    c[0] = ray.F(xs()[0], ray.P(ys()[0]));
    c[last] = ray.F(xs()[points_ - 1], ray.P(ys()[points_ - 1]));

    const int variations = bernstein::signVariations(c, coefficients_);
    if (variations == 0) return;
    if (variations == 1) {
        int k = 1;
        while ((c[k] < 0) == (c[0] < 0))
            ++k;
        refineSteep(0, 1, c[0] < 0, (k - 1 + c[k - 1] / (c[k - 1] - c[k])) / last, hits);
        return;
    }
    isolateSteep(c, 0, 1, maxDepth, hits);
}

/// Rounding in F's coefficients over [ta, tb]: of the terms' size there, which is largest at the ends of what is
/// monotone. Next to a pole all terms vanish and F keeps its relative accuracy.
double PartSolver::steepNoise(const AxialRay& ray, double ta, double tb) const {
    constexpr double eps = std::numeric_limits<double>::epsilon();
    const double p = std::abs(ray.P(middle_));
    double largest = 0;
    for (const double t : {ta, tb}) {
        const Sample c = at(t);
        largest = std::max(largest, sqr(ray.h * (c.y - middle_)) + sqr(ray.v * c.x));
    }
    return 16 * eps * (largest + sqr(p) + sqr(ray.v * ray.e));
}

void PartSolver::isolateSteep(double* c, double ta, double tb, int depth, HitCollector& hits) const {
    const int variations = bernstein::signVariations(c, coefficients_);
    if (variations == 0) return;
    const double tm = (ta + tb) / 2;
    bool certain = variations == 1 || depth == 0;
    if (!certain && depth < maxDepth - 12) {
        double largest = 0;
        for (int k = 0; k < coefficients_; ++k)
            largest = std::max(largest, std::abs(c[k]));
        certain = largest <= steepNoise(hits.ray(), ta, tb);
    }
    if (certain) {
        if (variations % 2 == 1) refineSteep(ta, tb, c[0] < 0, tm, hits);
        return;
    }
    double left[maxCoefficients];
    bernstein::halve(c, left, coefficients_);
    isolateSteep(left, ta, tm, depth - 1, hits);
    isolateSteep(c, tm, tb, depth - 1, hits);
}

void PartSolver::refineSteep(double ta, double tb, bool negativeAtA, double guess, HitCollector& hits) const {
    const AxialRay& ray = hits.ray();
    const double v2 = sqr(ray.v);
    double t = guess > ta && guess < tb ? guess : (ta + tb) / 2, lastStep = 0;
    Sample c;
    // Newton's method, kept in the bracket by bisection; F comes from the curve itself, not from its coefficients, so
    // the root is as exact as the point.
    for (int i = 1; i < 100; ++i) {
        c = at(t);
        const double p = ray.P(c.y), f = ray.F(c.x, p);
        ((f < 0) == negativeAtA ? ta : tb) = t;
        double next = t - f / (2 * (ray.h * p * c.dy - v2 * c.x * c.dx));
        const bool newton = next >= ta && next <= tb && i % 8 != 0;
        if (!newton) next = (ta + tb) / 2;
        const double step = next - t;
        t = next;
        c.x += step * c.dx;
        c.y += step * c.dy;
        // Once Newton's steps shrink a thousandfold they shrink quadratically: this one was the last, and so short that
        // the curve is its tangent.
        if (std::abs(step) <= 0x1p-51 || (newton && std::abs(step) < std::min(0x1p-32, 0x1p-10 * lastStep))) break;
        lastStep = newton ? std::abs(step) : 0;
    }
    hits.offer(index_, t, c.x, c.y, (ray.P(c.y) < 0) == (ray.v < 0));
}

} // namespace vitrine
