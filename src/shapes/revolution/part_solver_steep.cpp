// Rays that are not nearly horizontal: one polynomial of degree 2n.
#include "shapes/revolution/bernstein.h"
#include "shapes/revolution/refine.h"

#include <bit>

namespace vitrine {

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
        const double p = ray.P(y), f = ray.F(x, p), lengths = std::abs(ray.vq) + std::abs(ray.oy) + std::abs(y);
        const double noise = 2 * part.points_ * eps * (v2 * (sqr(x) + sqr(ray.e)) + std::abs(p) * lengths);
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
    /// The parabola's root where it rises or falls.
    double guess(bool rises) const {
        const double slope = safeSqrt(sqr(b()) - 4 * a() * f0) * (rises ? 1 : -1);
        return b() * slope > 0 ? -2 * f0 / (b() + slope) : (slope - b()) / (2 * a());
    }
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

/// A place where F's sign differs from that at the ends, and F there.
struct PartSolver::Dip {
    double t, y;
    Derivatives at{}; ///< all 0 at the middle, about which the parabola of the whole part is as good

    /// Where F's own parabola there has its root before or after.
    double guess(bool before) const {
        const double reach = safeSqrt(at.d1 * at.d1 - 2 * at.f * at.d2) / std::abs(at.d2);
        return t - at.d1 / at.d2 + (before ? -reach : reach);
    }
};

/// Tries three places where it is likely: the middle, the vertex of the parabola, and where the ray has the profile's
/// height as it is closest to the axis (P = 0), between its two sides; there F is negative if the profile is farther
/// from the axis than the ray ever comes.
std::optional<PartSolver::Dip> PartSolver::findDip(const Quadratic& f) const {
    const bool negative = f.f0 < 0;
    const auto dips = [&](double x, double y) { return negative ? f.value(x, y) > 0 : f.value(x, y) < 0; };
    if (dips(xHalf_, yHalf_)) return Dip{0.5, yHalf_};
    const double vertex = f.vertex();
    const CurveSample c = curve_.at(vertex);
    if (dips(c.x, c.y)) return Dip{vertex, c.y, f(c)};
    const double pa = f.ray.P(y0_), pb = f.ray.P(y1_);
    if (negative || (pa < 0) == (pb < 0)) return std::nullopt;
    double t = pa / (pa - pb);
    for (int i = 0; i < 3; ++i) {
        const CurveSample d = curve_.at(t);
        if (dips(d.x, d.y)) return Dip{t, d.y, f(d)};
        t -= f.ray.P(d.y) / (f.ray.h * d.dy);
        if (!(t > 0 && t < 1)) break;
    }
    return std::nullopt;
}

/// As it runs up or down a part, a steep ray meets what it meets in order: after a hit that is the first so far, all
/// others of the part come later.
void PartSolver::solveSeveral(const Quadratic& f, int variations, HitCollector& hits) const {
    const bool negative = f.f0 < 0, inOrder = isInOrder(f.ray);
    if (variations == 2)
        if (const std::optional<Dip> dip = findDip(f)) {
            const auto solveHalf = [&](bool first) {
                if (hits.settles(first ? y0_ : dip->y, first ? dip->y : y1_)) return true;
                const double guess = dip->at.f != 0 ? dip->guess(first) : f.guess(negative == first);
                return offerRoot(f, first ? Bracket{0, dip->t, negative} : Bracket{dip->t, 1, !negative}, guess, hits);
            };
            if (!(solveHalf(inOrder) && hits.wantsOne())) solveHalf(!inOrder);
            return;
        }
    double c[maxCoefficients + 3];
    for (int i = 0; i < quadruples_; ++i) {
        const Lanes four = f.coefficients(squares_[std::size_t(i)]);
        for (int k = 0; k < 4; ++k)
            c[4 * i + k] = four[k];
    }
    c[0] = f.f0;
    c[coefficients_ - 1] = f.f1;
    double left[maxCoefficients];
    const double t = f.vertex();
    bernstein::split(c, left, coefficients_, t);
    // At the vertex the curve knows F better than its coefficients do.
    const CurveSample vertex = curve_.at(t);
    if (const double value = f.value(vertex.x, vertex.y); value != 0) left[coefficients_ - 1] = c[0] = value;
    const auto solveHalf = [&](bool first) {
        return first ? isolateSteep(f, left, 0, t, maxDepth - 1, hits) : isolateSteep(f, c, t, 1, maxDepth - 1, hits);
    };
    if (!solveHalf(inOrder)) solveHalf(!inOrder);
}

/// Rounding in F's coefficients over [ta, tb]: of the terms' size there, which is largest at the ends of what is
/// monotone. Next to a pole all terms vanish and F keeps its relative accuracy.
double PartSolver::steepNoise(const AxialRay& ray, double ta, double tb) const {
    constexpr double eps = std::numeric_limits<double>::epsilon();
    const double p = std::abs(ray.P(middle_));
    double largest = 0;
    for (const double t : {ta, tb}) {
        const CurveSample c = curve_.at(t);
        largest = std::max(largest, sqr(ray.h * (c.y - middle_)) + sqr(ray.v * c.x));
    }
    return 16 * eps * (largest + sqr(p) + sqr(ray.v * ray.e));
}

/// True when the rest of the part is settled by a hit.
bool PartSolver::isolateSteep(const Quadratic& f, double* c, double ta, double tb, int depth,
                              HitCollector& hits) const {
    const int variations = bernstein::signVariations(c, coefficients_);
    if (variations == 0) return false;
    const double tm = (ta + tb) / 2;
    bool certain = variations == 1 || depth == 0;
    if (!certain && depth < maxDepth - 12) {
        double largest = 0;
        for (int k = 0; k < coefficients_; ++k)
            largest = std::max(largest, std::abs(c[k]));
        certain = largest <= steepNoise(f.ray, ta, tb);
    }
    if (certain) {
        if (variations % 2 == 0) return false;
        return offerRoot(f, {ta, tb, c[0] < 0}, f.guess(c[0] < 0), hits) && hits.wantsOne();
    }
    double left[maxCoefficients];
    bernstein::halve(c, left, coefficients_);
    if (isInOrder(f.ray))
        return isolateSteep(f, left, ta, tm, depth - 1, hits) || isolateSteep(f, c, tm, tb, depth - 1, hits);
    return isolateSteep(f, c, tm, tb, depth - 1, hits) || isolateSteep(f, left, ta, tm, depth - 1, hits);
}

} // namespace vitrine
