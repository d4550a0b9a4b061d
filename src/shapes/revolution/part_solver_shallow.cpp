// Rays that are nearly or exactly horizontal: the two halves of the hyperbola apart, without squaring.
//
// On a half, G(t) = P(y(t)) - w S(x(t)) with w = +-v and S(x) = sqrt(x^2 - e^2), which is concave: over [xa, xb] it
// lies between its chord and the parallel tangent. So G is enclosed by a polynomial of degree n and a band, whose width
// falls with the square of the interval's.
#include "shapes/revolution/bernstein.h"
#include "shapes/revolution/refine.h"

namespace vitrine {

struct PartSolver::Branch {
    const AxialRay& ray;
    double w;
    bool forward;

    /// Rounding in G's values near (x, p).
    double noise(double x, double p) const { return 0x1p-49 * (2 * std::abs(ray.vq) + std::abs(p) + std::abs(w) * x); }
    double value(double x, double p) const { return p - w * ray.halfWidth(x); }
    Derivatives operator()(const CurveSample& c) const {
        const double p = ray.P(c.y), s = ray.halfWidth(c.x);
        if (!(s > 0)) return {p, ray.h * c.dy, ray.h * c.ddy};
        const double dsdx = c.x / s, turn = dsdx * c.dx;
        return {p - w * s, ray.h * c.dy - w * turn, ray.h * c.ddy - w * ((sqr(c.dx) - sqr(turn)) / s + dsdx * c.ddx)};
    }
    bool isForward(double) const { return forward; }
    /// dS/dx = x / S; infinite where the ray is closest to the axis.
    double slope(double x) const {
        const double s = ray.halfWidth(x);
        return s > 0 ? x / s : infinityD;
    }
    /// Range of G over the interval by its enclosure.
    std::pair<double, double> enclose(const double* x, const double* p, int n) const {
        const auto [xa, xb] = std::minmax(x[0], x[n - 1]);
        const double sa = ray.halfWidth(xa), rise = ray.halfWidth(xb) - sa;
        double chord = 0, band = rise; // of a vertical wall
        if (xb - xa > 1e-9 * xb) {
            chord = rise / (xb - xa);
            // S - chord (x - xa) - S(xa) is largest where S' = chord: at x = e chord / root, S = e / root.
            const double root = safeSqrt((chord - 1) * (chord + 1));
            band = std::clamp(chord * xa - sa - ray.e * root, 0., rise);
        }
        double low = infinityD, high = -infinityD;
        for (int k = 0; k < n; ++k) {
            const double g = p[k] - w * (sa + chord * (x[k] - xa));
            low = std::min(low, g);
            high = std::max(high, g);
        }
        (w > 0 ? low : high) -= w * band;
        return {low, high};
    }
    /// Whether G is monotone over the interval: its derivative's coefficients keep one sign for both extremes of dS/dx.
    bool isMonotone(const double* x, const double* p, int n) const {
        const auto [xa, xb] = std::minmax(x[0], x[n - 1]);
        const double least = slope(xb), most = slope(xa);
        bool rises = true, falls = true;
        for (int k = 1; k < n; ++k) {
            const double dp = p[k] - p[k - 1], dx = x[k] - x[k - 1];
            const double turn = w * dx;
            for (const double m : {least, most}) {
                const double d = turn == 0 ? dp : dp - turn * m;
                rises = rises && d >= 0;
                falls = falls && d <= 0;
            }
        }
        return rises || falls;
    }
};

void PartSolver::solveShallow(HitCollector& hits) const {
    const AxialRay& ray = hits.ray();
    double x[maxPoints], p[maxPoints];
    double low = infinityD, high = -infinityD;
    for (int k = 0; k < points_; ++k) {
        x[k] = control_[std::size_t(k)];
        p[k] = ray.P(control_[std::size_t(points_ + k)]);
        low = std::min(low, p[k]);
        high = std::max(high, p[k]);
    }
    const double widest = std::abs(ray.v) * ray.halfWidth(std::max(xMax_, ray.e));
    if (low > widest || high < -widest) return;
    double ta = 0, tb = 1;
    if (!clipToReach(ray, x, p, ta, tb)) return;
    for (const bool forward : {true, false}) {
        double bx[maxPoints], bp[maxPoints];
        std::copy_n(x, points_, bx);
        std::copy_n(p, points_, bp);
        isolateShallow(Branch{ray, forward ? ray.v : -ray.v, forward}, bx, bp, ta, tb, maxDepth, hits);
        if (hits.done()) return;
    }
}

/// Cuts away what is nearer to the axis than the ray ever comes. At the cut both branches have the same value, so that
/// they agree on its sign. x is monotone. False when nothing is left.
bool PartSolver::clipToReach(const AxialRay& ray, double* x, double* p, double& ta, double& tb) const {
    const bool startsInside = x[0] < ray.e, endsInside = x[points_ - 1] < ray.e;
    if (startsInside && endsInside) return false;
    if (startsInside == endsInside) return true;
    const double t = reachAt(ray.e);
    double left[maxPoints];
    if (startsInside) {
        bernstein::split(x, left, points_, t);
        bernstein::split(p, left, points_, t);
        x[0] = ray.e;
        ta = t;
    } else {
        bernstein::split(x, left, points_, t);
        std::copy_n(left, points_, x);
        bernstein::split(p, left, points_, t);
        std::copy_n(left, points_, p);
        x[points_ - 1] = ray.e;
        tb = t;
    }
    return true;
}

/// Where x(t) crosses `radius`.
double PartSolver::reachAt(double radius) const {
    const auto excess = [&](const CurveSample& c) { return Derivatives{c.x - radius, c.dx, c.ddx}; };
    return findRoot(excess, {0, 1, x0_ < radius}, (radius - x0_) / (x1_ - x0_)).t;
}

void PartSolver::isolateShallow(const Branch& branch, double* x, double* p, double ta, double tb, int depth,
                                HitCollector& hits) const {
    const int last = points_ - 1;
    const double valueAtA = branch.value(x[0], p[0]), valueAtB = branch.value(x[last], p[last]);
    const bool changes = (valueAtA < 0) != (valueAtB < 0);
    const auto [low, high] = branch.enclose(x, p, points_);
    if (!changes && (low > 0 || high < 0)) return;
    const bool isNoise = std::max(-low, high) <= std::max(branch.noise(x[0], p[0]), branch.noise(x[last], p[last]));
    if (depth == 0 || isNoise || branch.isMonotone(x, p, points_)) {
        const double secant = ta + (tb - ta) * (valueAtA / (valueAtA - valueAtB));
        if (changes) offerRoot(branch, {ta, tb, valueAtA < 0}, secant, hits);
        return;
    }
    double leftX[maxPoints], leftP[maxPoints];
    bernstein::halve(x, leftX, points_);
    bernstein::halve(p, leftP, points_);
    const double tm = (ta + tb) / 2;
    isolateShallow(branch, leftX, leftP, ta, tm, depth - 1, hits);
    isolateShallow(branch, x, p, tm, tb, depth - 1, hits);
}

} // namespace vitrine
