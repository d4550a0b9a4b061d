#include "support/revolution_slow.h"

#include <algorithm>

namespace vitrine::test {

namespace {

using Sample = SlowCurve::Sample;

/// Control values over [ta, tb], tb > 0: cut at tb, then what is left at ta / tb.
std::vector<long double> restricted(std::vector<long double> c, long double ta, long double tb) {
    const std::size_t n = c.size() - 1;
    std::vector<long double> result(c.size());
    for (std::size_t level = 0; level <= n; ++level) {
        result[level] = c[0];
        for (std::size_t i = 0; i + level < n; ++i)
            c[i] = (1 - tb) * c[i] + tb * c[i + 1];
    }
    const long double t = ta / tb;
    for (std::size_t level = 1; level <= n; ++level)
        for (std::size_t i = 0; i + level <= n; ++i)
            result[i] = (1 - t) * result[i] + t * result[i + 1];
    return result;
}

std::vector<long double> differences(const std::vector<long double>& c) {
    std::vector<long double> d;
    for (std::size_t k = 0; k + 1 < c.size(); ++k)
        d.push_back((long double)(c.size() - 1) * (c[k + 1] - c[k]));
    if (d.empty()) d.push_back(0);
    return d;
}

/// Of the control values over [ta, tb], which bound the polynomial's.
std::pair<long double, long double> range(const std::vector<long double>& c, long double ta, long double tb) {
    const std::vector<long double> part = restricted(c, ta, tb);
    const auto [low, high] = std::minmax_element(part.begin(), part.end());
    return {*low - 1e-17L, *high + 1e-17L};
}

/// Of the polynomial's magnitude over [ta, tb].
long double largest(const std::vector<long double>& c, long double ta, long double tb) {
    long double most = 0;
    for (const long double x : restricted(c, ta, tb))
        most = std::max(most, std::fabs(x));
    return most * (1 + 1e-15L) + 1e-17L;
}

/// Where the polynomial may change sign in (a, b): cuts that are not exactly there only cost time.
void signChanges(const std::vector<long double>& c, long double a, long double b, std::vector<long double>& found) {
    const std::vector<long double> part = restricted(c, a, b);
    const auto [low, high] = std::minmax_element(part.begin(), part.end());
    if (*low >= 0 || *high <= 0) return;
    const long double m = (a + b) / 2;
    if (b - a < 1e-6L) {
        long double lo = a, hi = b;
        const auto value = [&](long double t) { return restricted(c, t, t)[0]; };
        const bool negative = value(a) < 0;
        if (negative == (value(b) < 0)) return;
        for (int i = 0; i < 50; ++i) {
            const long double t = (lo + hi) / 2;
            ((value(t) < 0) == negative ? lo : hi) = t;
        }
        found.push_back((lo + hi) / 2);
        return;
    }
    signChanges(c, a, m, found);
    if (restricted(c, m, m)[0] == 0) found.push_back(m); // neither half would see it
    signChanges(c, m, b, found);
}

} // namespace

SlowSolver::SlowSolver(const ProfilePoints& profile) {
    for (std::size_t i = 0; i < profile.size(); ++i) {
        curves_.emplace_back(profile[i]);
        addPieces(int(i), profile[i]);
    }
}

void SlowSolver::addPieces(int segment, const std::vector<V2d>& points) {
    std::vector<long double> x;
    for (const V2d& p : points)
        x.push_back(p.x);
    std::vector<long double> cuts{0};
    signChanges(differences(x), 0, 1, cuts);
    cuts.push_back(1);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
        if (cuts[k + 1] > cuts[k]) addPiece(segment, points, cuts[k], cuts[k + 1]);
}

void SlowSolver::addPiece(int segment, const std::vector<V2d>& points, long double ta, long double tb) {
    std::vector<long double> x, y;
    for (const V2d& p : points)
        x.push_back(p.x), y.push_back(p.y);
    const std::vector<long double> x1 = differences(x), y1 = differences(y), x2 = differences(x1), y2 = differences(y1);
    const SlowCurve& curve = curves_[std::size_t(segment)];
    Piece piece{segment, ta, tb, curve.at(ta), curve.at(tb), {}};
    for (int depth = 0; depth <= treeDepth; ++depth) {
        for (int i = 0; i < (1 << depth); ++i) {
            const long double step = std::ldexp(tb - ta, -depth), a = ta + step * i, b = a + step;
            const auto [xLow, xHigh] = range(x, a, b);
            const auto [yLow, yHigh] = range(y, a, b);
            const Bounds bounds{largest(x, a, b), largest(x1, a, b), largest(x2, a, b), largest(y1, a, b),
                                largest(y2, a, b)};
            piece.nodes.push_back({curve.at((a + b) / 2), bounds, std::max(0.L, xLow), xHigh, yLow, yHigh});
        }
    }
    pieces_.push_back(std::move(piece));
}

/// f(t) = P^2 - v^2 (x^2 - e^2).
struct SlowSolver::Steep {
    const HalfPlaneRay& ray;
    const SlowCurve& curve;
    const Piece& piece;
    std::vector<OracleHit>& hits;
    long double mostNoise = 0; ///< of noise() on the piece: for a quick answer

    long double value(const Sample& c) const {
        const long double p = ray.rise(c.y);
        return p * p - ray.v * ray.v * (c.x - ray.e) * (c.x + ray.e);
    }
    /// Of P in units of the coordinates, and of f; x below 1e-16 is a pole.
    long double noise(const Sample& c) const {
        const long double dp = 0x1p-61L * (ray.h * (std::fabs(ray.oy) + std::fabs(c.y)) + std::fabs(ray.v * ray.q));
        return 4 * dp * (std::fabs(ray.rise(c.y)) + dp) +
               ray.v * ray.v * (0x1p-60L * (c.x * c.x + ray.e * ray.e) + 1e-32L);
    }
    /// What cannot be told from zero counts as positive, or a flat stretch in the ray would cross it many times.
    bool isNegative(const Sample& c) const { return value(c) < -noise(c); }
    long double slope(const Sample& c) const { return 2 * (ray.h * ray.rise(c.y) * c.dy - ray.v * ray.v * c.x * c.dx); }
    void found(long double t, const Sample& c) const {
        const bool forward = (ray.rise(c.y) < 0) == (ray.v < 0);
        hits.push_back({double(ray.lengthAt(c.x, c.y, forward) / ray.length), piece.segment, double(t), forward});
    }
    /// The only root in (a, b).
    void solve(long double a, long double b, bool negativeAtA) const {
        long double t = (a + b) / 2;
        Sample c{};
        for (int i = 1; i < 120; ++i) {
            c = curve.at(t);
            const long double f = value(c);
            (isNegative(c) == negativeAtA ? a : b) = t;
            long double next = t - f / slope(c);
            if (!(next > a && next < b) || i % 7 == 0) next = (a + b) / 2;
            const long double step = std::fabs(next - t);
            t = next;
            if (step < 1e-17L) break;
        }
        found(t, curve.at(t));
    }
    /// Whether f keeps its sign over the node's box.
    bool misses(const Node& node) const {
        const long double pa = ray.rise(node.yLow), pb = ray.rise(node.yHigh), a2 = pa * pa, b2 = pb * pb;
        const long double least = (pa < 0) == (pb < 0) ? std::min(a2, b2) : 0;
        const long double v2 = ray.v * ray.v;
        return least > v2 * (node.xHigh - ray.e) * (node.xHigh + ray.e) + 2 * mostNoise ||
               std::max(a2, b2) < v2 * (node.xLow - ray.e) * (node.xLow + ray.e) - 2 * mostNoise;
    }
    void search(std::size_t node, Bounds bounds, long double a, long double b, bool negativeAtA,
                bool negativeAtB) const {
        const long double m = (a + b) / 2, r = (b - a) / 2;
        Sample c;
        if (node < piece.nodes.size()) {
            if (misses(piece.nodes[node])) return;
            c = piece.nodes[node].middle;
            bounds = piece.nodes[node].bounds;
        } else {
            c = curve.at(m);
        }
        const long double p = ray.rise(c.y), h = ray.h, v2 = ray.v * ray.v;
        const long double f = p * p - v2 * (c.x - ray.e) * (c.x + ray.e);
        const long double df = std::fabs(2 * (h * p * c.dy - v2 * c.x * c.dx));
        // Near poles and cusps Taylor's bounds are far better than the node's.
        const long double x1 = std::min(bounds.x1, std::fabs(c.dx) + bounds.x2 * r);
        const long double y1 = std::min(bounds.y1, std::fabs(c.dy) + bounds.y2 * r);
        const long double x = std::min(bounds.x, c.x + x1 * r), rise = std::fabs(p) + h * y1 * r;
        const long double ddf = 2 * (h * (h * y1 * y1 + rise * bounds.y2) + v2 * (x1 * x1 + x * bounds.x2));
        const long double reach = df * r + ddf * r * r / 2;
        if (std::fabs(f) > reach + 2 * mostNoise) return;
        const long double rounding = noise(c);
        if (std::fabs(f) > reach + 2 * rounding) return;
        // Beyond 2 rounding + reach the stretch was left above: what remains here ends once reach is below a rounding, also
        // where a whole line of the profile lies in the ray.
        if (df > ddf * r || std::fabs(f) + reach < 4 * rounding || b - a < 0x1p-58L) {
            if (negativeAtA != negativeAtB) solve(a, b, negativeAtA);
            return;
        }
        search(2 * node + 1, bounds, a, m, negativeAtA, f < -rounding);
        search(2 * node + 2, bounds, m, b, f < -rounding, negativeAtB);
    }
    void run() {
        const Node& whole = piece.nodes[0];
        const long double y = std::fabs(whole.middle.y) + whole.bounds.y1 * (piece.tb - piece.ta);
        const long double p = std::fabs(ray.rise(whole.middle.y)) + ray.h * whole.bounds.y1 * (piece.tb - piece.ta);
        const long double dp = 0x1p-61L * (ray.h * (std::fabs(ray.oy) + y) + std::fabs(ray.v * ray.q));
        mostNoise =
            4 * dp * (p + dp) + ray.v * ray.v * (0x1p-60L * (whole.bounds.x * whole.bounds.x + ray.e * ray.e) + 1e-32L);
        search(0, {}, piece.ta, piece.tb, isNegative(piece.first), isNegative(piece.last));
    }
};

/// One half of the hyperbola: f(t) = P - w sqrt(x^2 - e^2), on the stretch of the piece that the ray reaches.
struct SlowSolver::Shallow {
    const HalfPlaneRay& ray;
    const SlowCurve& curve;
    const Piece& piece;
    bool forward;
    std::vector<OracleHit>& hits;
    long double tip = -1; ///< where the stretch ends because x = e: there both halves have the same value

    long double w() const { return forward ? ray.v : -ray.v; }
    long double width(long double t, const Sample& c) const { return t == tip ? 0 : ray.width(c.x); }
    long double noise(const Sample& c) const {
        return 0x1p-60L *
               (ray.h * (std::fabs(ray.oy) + std::fabs(c.y)) + std::fabs(ray.v * ray.q) + std::fabs(ray.v) * c.x);
    }
    bool isNegative(long double t, const Sample& c) const { return ray.rise(c.y) - w() * width(t, c) < -noise(c); }

    void solve(long double a, long double b, bool negativeAtA) const {
        for (int i = 0; i < 66; ++i) {
            const long double t = (a + b) / 2;
            (isNegative(t, curve.at(t)) == negativeAtA ? a : b) = t;
        }
        const long double t = (a + b) / 2;
        const Sample c = curve.at(t);
        hits.push_back({double(ray.lengthAt(c.x, c.y, forward) / ray.length), piece.segment, double(t), forward});
    }
    /// Where x(t) passes e, which lies between x(a) and x(b).
    long double edge(long double a, long double b, bool insideAtA) const {
        for (int i = 0; i < 66; ++i) {
            const long double t = (a + b) / 2;
            ((curve.at(t).x < ray.e) == insideAtA ? a : b) = t;
        }
        return insideAtA ? b : a;
    }
    /// On the node's interval [na, nb] cut to [a, b]; where the stretch ends at x = e, W is zero there.
    void search(std::size_t node, Bounds bounds, long double na, long double nb, long double a, long double b) const {
        if (nb <= a || na >= b) return;
        if (node < piece.nodes.size()) bounds = piece.nodes[node].bounds;
        const long double lo = std::max(a, na), hi = std::min(b, nb), m = (lo + hi) / 2, r = (hi - lo) / 2;
        const Sample c = curve.at(m), ca = curve.at(lo), cb = curve.at(hi);
        const long double dySpread = bounds.y2 * r, dxSpread = bounds.x2 * r;
        const long double pSpread = ray.h * (std::fabs(c.dy) + dySpread / 2) * r, p = ray.rise(c.y);
        const long double wa = width(lo, ca), wb = width(hi, cb); // x is monotone
        const long double ga = w() * std::min(wa, wb), gb = w() * std::max(wa, wb);
        const long double rounding = noise(c);
        if (p - pSpread > std::max(ga, gb) + 2 * rounding || p + pSpread < std::min(ga, gb) - 2 * rounding) return;
        const long double dyLow = ray.h * (c.dy - dySpread), dyHigh = ray.h * (c.dy + dySpread);
        const auto steepness = [&](const Sample& s, long double width) {
            return width > 0 ? s.x / width : std::numeric_limits<long double>::infinity();
        };
        const long double most = wa < wb ? steepness(ca, wa) : steepness(cb, wb);
        const long double least = wa < wb ? steepness(cb, wb) : steepness(ca, wa);
        // w x' x / W over the interval.
        long double low = std::numeric_limits<long double>::infinity(), high = -low;
        for (const long double dx : {c.dx - dxSpread, c.dx + dxSpread})
            for (const long double k : {least, most}) {
                const long double turn = dx == 0 || w() == 0 ? 0 : w() * dx * k;
                low = std::min(low, turn), high = std::max(high, turn);
            }
        const bool monotone = dyLow > high || dyHigh < low;
        const long double size = std::fabs(p) + pSpread + std::max(std::fabs(ga), std::fabs(gb));
        if (monotone || size < rounding || hi - lo < 0x1p-56L) {
            const bool negativeAtA = isNegative(lo, ca);
            if (negativeAtA != isNegative(hi, cb)) solve(lo, hi, negativeAtA);
            return;
        }
        const long double nm = (na + nb) / 2;
        search(2 * node + 1, bounds, na, nm, a, b);
        search(2 * node + 2, bounds, nm, nb, a, b);
    }
    void run() {
        const bool insideAtA = piece.first.x < ray.e, insideAtB = piece.last.x < ray.e;
        if (insideAtA && insideAtB) return;
        long double a = piece.ta, b = piece.tb;
        if (insideAtA != insideAtB) (insideAtA ? a : b) = tip = edge(a, b, insideAtA);
        search(0, {}, piece.ta, piece.tb, a, b);
    }
};

std::vector<OracleHit> SlowSolver::hits(const Ray& ray) const {
    std::vector<OracleHit> hits;
    const HalfPlaneRay half(ray);
    for (const Piece& piece : pieces_) {
        const SlowCurve& curve = curves_[std::size_t(piece.segment)];
        if (std::fabs(half.v) >= 1e-3L) {
            Steep{half, curve, piece, hits}.run();
        } else {
            Shallow{half, curve, piece, false, hits}.run();
            Shallow{half, curve, piece, true, hits}.run();
        }
    }
    std::sort(hits.begin(), hits.end(), [](const OracleHit& a, const OracleHit& b) { return a.s < b.s; });
    return hits;
}

} // namespace vitrine::test
