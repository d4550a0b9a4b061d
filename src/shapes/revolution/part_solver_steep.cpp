// Rays that are not nearly horizontal: one polynomial of degree 2n.
#include "shapes/revolution/bernstein.h"
#include "shapes/revolution/refine.h"

#include <bit>

namespace vitrine {

namespace {

/// Where the parabola a t^2 + b t + c has its rising or its falling root.
double parabolaRoot(double c, double a, double b, bool rises) {
    const double slope = safeSqrt(b * b - 4 * a * c) * (rises ? 1 : -1);
    return b * slope > 0 ? -2 * c / (b + slope) : (slope - b) / (2 * a);
}

} // namespace

struct PartSolver::Quadratic {
    static constexpr double lastStep = 0x1p-20;

    const AxialRay& ray;
    const PartSolver& part;
    double v2, h2, linear, constant;
    double f0, fHalf, f1; ///< at the part's ends and middle

    Quadratic(const AxialRay& r, const PartSolver& p)
        : ray(r), part(p), v2(sqr(r.v)), h2(sqr(r.h)), f0(r.F(p.x0_, r.P(p.y0_))), fHalf(r.F(p.xHalf_, r.P(p.yHalf_))),
          f1(r.F(p.x1_, r.P(p.y1_))) {
        const double atMiddle = r.P(p.middle_);
        linear = 2 * r.h * atMiddle;
        constant = sqr(atMiddle) + v2 * sqr(r.e);
    }

    Lanes coefficients(const Quadruple& four) const {
        return (broadcast(h2) * four.y2 + broadcast(linear) * four.y1) +
               (broadcast(constant) - broadcast(v2) * four.x2);
    }
    /// Sign variations along the coefficients, those at the ends by the end points.
    int variations() const {
        unsigned before = f0 < 0;
        int count = 0;
        for (int i = 0; i < part.quadruples_; ++i) {
            unsigned negative = lessMask(coefficients(part.squares_[std::size_t(i)]), Lanes{});
            if (i == 0) negative = (negative & ~1u) | before;
            if (i == part.quadruples_ - 1) negative = (negative & part.inLast_) | (f1 < 0 ? ~part.inLast_ & 15u : 0u);
            count += std::popcount((negative ^ (negative << 1 | before)) & 15u);
            before = negative >> 3;
        }
        return count;
    }

    /// F at a point of the curve; 0 where rounding of the point and of the ray hides its sign: two roots that only rounding
    /// makes would be off the surface.
    double value(double x, double y) const {
        constexpr double eps = std::numeric_limits<double>::epsilon();
        const double p = ray.P(y), f = ray.F(x, p), relative = part.points_ * eps;
        // P's own error counts squared where P vanishes: at a pole that the ray goes through.
        const double errorOfP = relative * (std::abs(ray.vq) + std::abs(ray.oy) + std::abs(y));
        const double noise = 2 * relative * v2 * (sqr(x) + sqr(ray.e)) + errorOfP * (2 * std::abs(p) + errorOfP);
        return std::abs(f) > noise ? f : 0;
    }
    /// Half of F'' and F' and F: only ratios count.
    Derivatives operator()(const CurveSample& c) const {
        const double p = ray.P(c.y), hp = ray.h * p, slopeY = ray.h * c.dy;
        return {0.5 * ray.F(c.x, p), hp * c.dy - v2 * (c.x * c.dx),
                (slopeY * slopeY + hp * c.ddy) - v2 * (c.dx * c.dx + c.x * c.ddx)};
    }
    bool isForward(double y) const { return (ray.P(y) < 0) == (ray.v < 0); }

    // F of a part that is nearly straight is nearly the parabola a t^2 + b t + f0 through the three values.
    double a() const { return 2 * ((f0 - fHalf) + (f1 - fHalf)); }
    double b() const { return 4 * fHalf - 3 * f0 - f1; }
    double guess(bool rises) const { return parabolaRoot(f0, a(), b(), rises); }
    double vertex() const {
        const double t = -b() / (2 * a());
        return t > 0.01 && t < 0.99 ? t : 0.5;
    }
};

void PartSolver::solveSteep(HitCollector& hits) const {
    const Quadratic f(hits.ray(), *this);
    const int variations = f.variations();
    if (variations == 0) return;
    if (variations == 1) {
        if (hits.settles(y0_, y1_)) return;
        offerRoot(f, {0, 1, f.f0 < 0}, f.guess(f.f0 < 0), hits);
        return;
    }
    solveSeveral(f, variations, hits);
}

/// A place where F comes nearest to the other sign than at the ends, or has it.
struct PartSolver::Dip {
    double t, y;
    bool isCrossed;   ///< the signs differ: there is a root on either side
    Derivatives at{}; ///< all 0 at the middle, about which the parabola of the whole part is as good

    /// Where F's own parabola there has its root before or after.
    double guess(bool before) const {
        const double reach = safeSqrt(at.d1 * at.d1 - 2 * at.f * at.d2) / std::abs(at.d2);
        return vertex() + (before ? -reach : reach);
    }
    double vertex() const { return t - at.d1 / at.d2; }
};

/// Tries the middle; where the ray has the profile's height as it is closest to the axis (P = 0), between its two sides:
/// there F is negative if the profile is farther from the axis than the ray ever comes; and the vertex of the parabola.
PartSolver::Dip PartSolver::findDip(const Quadratic& f) const {
    const bool negative = f.f0 < 0;
    const auto isCrossed = [&](double x, double y) { return negative ? f.value(x, y) > 0 : f.value(x, y) < 0; };
    if (isCrossed(xHalf_, yHalf_)) return Dip{0.5, yHalf_, true};
    const double pa = f.ray.P(y0_), pHalf = f.ray.P(yHalf_), pb = f.ray.P(y1_);
    Dip dip{};
    if (!negative && (pa < 0) != (pb < 0)) {
        double t = parabolaRoot(pa, 2 * ((pa - pHalf) + (pb - pHalf)), 4 * pHalf - 3 * pa - pb, pa < 0);
        for (int i = 0; i < 3 && t > 0 && t < 1; ++i) {
            const CurveSample c = curve_.at(t);
            dip = {t, c.y, isCrossed(c.x, c.y), f(c)};
            if (dip.isCrossed) return dip;
            t -= f.ray.P(c.y) / (f.ray.h * c.dy);
        }
    }
    const double vertex = f.vertex();
    const CurveSample c = curve_.at(vertex);
    const Dip atVertex{vertex, c.y, isCrossed(c.x, c.y), f(c)};
    return atVertex.isCrossed || !(dip.t > 0) || std::abs(atVertex.at.f) < std::abs(dip.at.f) ? atVertex : dip;
}

/// As it runs up or down a part, a steep ray meets what it meets in order.
void PartSolver::solveSeveral(const Quadratic& f, int variations, HitCollector& hits) const {
    const bool negative = f.f0 < 0, inOrder = isInOrder(f.ray);
    double t = f.vertex();
    if (variations == 2) {
        const Dip dip = findDip(f);
        if (dip.isCrossed) {
            const auto solveHalf = [&](bool first) {
                if (hits.settles(first ? y0_ : dip.y, first ? dip.y : y1_)) return;
                const double guess = dip.at.f != 0 ? dip.guess(first) : f.guess(negative == first);
                offerRoot(f, first ? Bracket{0, dip.t, negative} : Bracket{dip.t, 1, !negative}, guess, hits);
            };
            solveHalf(inOrder);
            if (!hits.done() && !hits.needsNothingFrom(dip.y)) solveHalf(!inOrder);
            return;
        }
        if (dip.vertex() > 0 && dip.vertex() < 1) t = dip.vertex();
    }
    double c[maxCoefficients + 3];
    for (int i = 0; i < quadruples_; ++i) {
        const Lanes four = f.coefficients(squares_[std::size_t(i)]);
        for (int k = 0; k < 4; ++k)
            c[4 * i + k] = four[k];
    }
    c[0] = f.f0;
    c[coefficients_ - 1] = f.f1;
    // A wall in which the ray lies.
    if (variations % 2 == 0 && isNoise(f.ray, c, {x0_, x1_}, {y0_, y1_})) return;
    double left[maxCoefficients];
    bernstein::split(c, left, coefficients_, t);
    // There the curve knows F better than its coefficients do.
    const CurveSample least = curve_.at(t);
    if (const double value = f.value(least.x, least.y); value != 0) left[coefficients_ - 1] = c[0] = value;
    const auto solveHalf = [&](bool first) {
        return first ? isolateSteep(f, left, 0, t, maxDepth - 1, hits) : isolateSteep(f, c, t, 1, maxDepth - 1, hits);
    };
    if (!solveHalf(inOrder)) solveHalf(!inOrder);
}

/// Whether F's coefficients over a stretch with these ends are rounding: of the terms' size there, which is largest at the
/// ends of what is monotone. Next to a pole all terms vanish and F keeps its relative accuracy.
bool PartSolver::isNoise(const AxialRay& ray, const double* c, const std::array<double, 2>& x,
                         const std::array<double, 2>& y) const {
    constexpr double eps = std::numeric_limits<double>::epsilon();
    double terms = 0, largest = 0;
    for (const std::size_t i : {0u, 1u})
        terms = std::max(terms, sqr(ray.h * (y[i] - middle_)) + sqr(ray.v * x[i]));
    for (int k = 0; k < coefficients_; ++k)
        largest = std::max(largest, std::abs(c[k]));
    return largest <= 16 * eps * (terms + sqr(ray.P(middle_)) + sqr(ray.v * ray.e));
}

/// True when the rest of the part is settled by a hit.
bool PartSolver::isolateSteep(const Quadratic& f, double* c, double ta, double tb, int depth,
                              HitCollector& hits) const {
    const int variations = bernstein::signVariations(c, coefficients_);
    if (variations == 0) return false;
    const double tm = (ta + tb) / 2;
    bool certain = variations == 1 || depth == 0;
    if (!certain && depth < maxDepth - 12) {
        const CurveSample a = curve_.at(ta), b = curve_.at(tb);
        certain = isNoise(f.ray, c, {a.x, b.x}, {a.y, b.y});
    }
    if (certain) {
        if (variations % 2 == 0) return false;
        offerRoot(f, {ta, tb, c[0] < 0}, f.guess(c[0] < 0), hits);
        return hits.done() || hits.needsNothingFrom(curve_.at(isInOrder(f.ray) ? tb : ta).y);
    }
    double left[maxCoefficients];
    bernstein::halve(c, left, coefficients_);
    if (isInOrder(f.ray))
        return isolateSteep(f, left, ta, tm, depth - 1, hits) || isolateSteep(f, c, tm, tb, depth - 1, hits);
    return isolateSteep(f, c, tm, tb, depth - 1, hits) || isolateSteep(f, left, ta, tm, depth - 1, hits);
}

} // namespace vitrine
