// Rays that are nearly or exactly horizontal: the two halves of the hyperbola apart, without squaring.
//
// On a half, G(t) = P(y(t)) - w S(x(t)) with w = +-v and S(x) = sqrt(x^2 - e^2), which is concave: over [xa, xb] it
// lies between its chord and the parallel tangent. So G is enclosed by a polynomial of degree n and a band, whose width
// falls with the square of the interval's.
#include "shapes/revolution/bernstein.h"
#include "shapes/revolution/refine.h"

namespace vitrine {

struct PartSolver::Branch {
    /// Next to the closest approach, where S has its root, higher derivatives are so large that Halley's step says nothing
    /// of the next one: only one that is itself next to nothing is the last.
    static constexpr double lastStep = 0x1p-47;

    const AxialRay& ray;
    double w;
    bool forward;
    double unit; ///< rounding of the part's coordinates after many halvings
    double base; ///< that, and rounding of the ray's

    /// Rounding in G's values where S is s, and room to spare: G is a length, to be known to 1e-9 of the profile at the
    /// least. An error of delta in x makes one of x delta / S in S, and of sqrt(2 x delta) where S is next to nothing.
    double noise(double x, double s) const {
        const double amplified = s > 0 ? x * unit / s : infinityD;
        return base + std::abs(w) * std::min(std::sqrt(x * unit), amplified);
    }
    Derivatives operator()(const CurveSample& c) const {
        const double p = ray.P(c.y), s = ray.halfWidth(c.x);
        if (!(s > 0)) return {p, ray.h * c.dy, ray.h * c.ddy};
        const double dsdx = c.x / s, turn = dsdx * c.dx;
        return {p - w * s, ray.h * c.dy - w * turn, ray.h * c.ddy - w * ((sqr(c.dx) - sqr(turn)) / s + dsdx * c.ddx)};
    }
    bool isForward(double) const { return forward; }
    bool isNegative(double x, double p) const { return p - w * ray.halfWidth(x) < 0; }
    /// dS/dx = x / S; infinite where the ray is closest to the axis.
    static double slope(double x, double s) { return s > 0 ? x / s : infinityD; }
    /// Range of G over the interval by its enclosure.
    /// \param sa, sb S at the lesser and the greater radius
    std::pair<double, double> enclose(const double* x, const double* p, int n, double sa, double sb) const {
        const auto [xa, xb] = std::minmax(x[0], x[n - 1]);
        // (sb - sa) / (xb - xa), without the differences: sb^2 - sa^2 = xb^2 - xa^2.
        const double chord = sb > 0 ? (xa + xb) / (sa + sb) : 0, width = xb - xa;
        // S - chord (x - xa) - S(xa) is largest where S' = chord: at x = e chord / root, S = e / root. Next to nothing
        // in a short interval, where S'' = -e^2 / S^3 says it better; at a vertical tangent all of the rise at most.
        const double root = safeSqrt((chord - 1) * (chord + 1));
        const double bulge = std::max(0., chord * xa - sa - ray.e * root);
        const double band =
            std::min({chord * width, bulge, sa > 0 ? sqr(width * ray.e) / (8 * sa * sa * sa) : infinityD});
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
    bool isMonotone(const double* x, const double* p, int n, double sa, double sb) const {
        const auto [xa, xb] = std::minmax(x[0], x[n - 1]);
        const double least = slope(xb, sb), most = slope(xa, sa);
        double low = infinityD, high = -infinityD;
        for (int k = 1; k < n; ++k) {
            const double dp = p[k] - p[k - 1], turn = w * (x[k] - x[k - 1]);
            const double a = turn == 0 ? dp : dp - turn * least, b = turn == 0 ? dp : dp - turn * most;
            low = std::min({low, a, b});
            high = std::max({high, a, b});
        }
        return low >= 0 || high <= 0;
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
    // All of the backward half comes before all of the forward one, with the closest approach to the axis between them.
    // A length that comes from a height errs by 1 / v of it, so that rounding may put roots beside it on its other side.
    const double closest = -ray.q, slack = hits.margin() / std::max(std::abs(ray.v), 1e-7);
    constexpr double eps = std::numeric_limits<double>::epsilon();
    const double unit = (8 + 8 * points_) * eps * reach_;
    const double base = unit + 8 * eps * (2 * std::abs(ray.vq) + std::abs(ray.oy));
    const auto solveBranch = [&](double w, bool forward) {
        const Branch branch{ray, w, forward, unit, base};
        const Bracket whole{ta, tb, branch.isNegative(x[0], p[0])};
        return isolateShallow(branch, x, p, whole, branch.isNegative(x[points_ - 1], p[points_ - 1]), maxDepth, hits);
    };
    if (closest + slack >= hits.lengthMin() * ray.h && solveBranch(-ray.v, false) && hits.done()) return;
    if (closest - slack <= hits.lengthMax() * ray.h) solveBranch(ray.v, true);
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

struct PartSolver::Excess {
    static constexpr double lastStep = 0x1p-20;
    double radius;
    Derivatives operator()(const CurveSample& c) const { return {c.x - radius, c.dx, c.ddx}; }
};

/// Where x(t) crosses `radius`.
double PartSolver::reachAt(double radius) const {
    return findRoot(Excess{radius}, {0, 1, x0_ < radius}, (radius - x0_) / (x1_ - x0_)).t;
}

/// The signs at the ends are handed down, so that neighbours agree. True when a crossing counts.
bool PartSolver::isolateShallow(const Branch& branch, const double* x, const double* p, const Bracket& bracket,
                                bool negativeAtB, int depth, HitCollector& hits) const {
    const int last = points_ - 1;
    const double s0 = branch.ray.halfWidth(x[0]), s1 = branch.ray.halfWidth(x[last]);
    const double sa = x[0] > x[last] ? s1 : s0, sb = x[0] > x[last] ? s0 : s1;
    const bool changes = bracket.negativeAtA != negativeAtB;
    const auto [low, high] = branch.enclose(x, p, points_, sa, sb);
    if (!changes && (low > 0 || high < 0)) return false;
    const bool isNoise = std::max(-low, high) <= std::max(branch.noise(x[0], s0), branch.noise(x[last], s1));
    if (depth == 0 || isNoise || branch.isMonotone(x, p, points_, sa, sb)) {
        if (!changes) return false;
        const double a = p[0] - branch.w * s0, b = p[last] - branch.w * s1;
        return offerRoot(branch, bracket, bracket.ta + (bracket.tb - bracket.ta) * (a / (a - b)), hits);
    }
    double leftX[maxPoints], leftP[maxPoints], rightX[maxPoints], rightP[maxPoints];
    std::copy_n(x, points_, rightX);
    std::copy_n(p, points_, rightP);
    bernstein::halve(rightX, leftX, points_);
    bernstein::halve(rightP, leftP, points_);
    const double tm = (bracket.ta + bracket.tb) / 2;
    const bool negative = branch.isNegative(rightX[0], rightP[0]);
    const bool inLeft =
        isolateShallow(branch, leftX, leftP, {bracket.ta, tm, bracket.negativeAtA}, negative, depth - 1, hits);
    if (inLeft && hits.done()) return true;
    return isolateShallow(branch, rightX, rightP, {tm, bracket.tb, negative}, negativeAtB, depth - 1, hits) || inLeft;
}

} // namespace vitrine
