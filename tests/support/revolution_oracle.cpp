#include "support/revolution_oracle.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>

namespace vitrine::test {

namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using Polynomial = std::vector<Real>; // power basis, constant first

Real valueAt(const Polynomial& p, const Real& t) {
    Real sum = 0;
    for (std::size_t k = p.size(); k-- > 0;)
        sum = sum * t + p[k];
    return sum;
}

Polynomial derivativeOf(const Polynomial& p) {
    Polynomial d;
    for (std::size_t k = 1; k < p.size(); ++k)
        d.push_back(p[k] * k);
    return d;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
    Polynomial c(a.size() + b.size() - 1, Real(0));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            c[i + j] += a[i] * b[j];
    return c;
}

/// a + f b, of the degree of the larger.
Polynomial combine(Polynomial a, const Real& f, const Polynomial& b) {
    a.resize(std::max(a.size(), b.size()), Real(0));
    for (std::size_t i = 0; i < b.size(); ++i)
        a[i] += f * b[i];
    return a;
}

Polynomial powerBasis(const std::vector<V2d>& points, int axis, double shift) {
    const std::size_t n = points.size() - 1;
    Polynomial result;
    std::vector<Real> c;
    for (const V2d& p : points)
        c.push_back(Real(p[axis]) + Real(shift));
    Real binomial = 1; // times the k-th forward difference of the control points
    for (std::size_t k = 0; k <= n; ++k) {
        result.push_back(binomial * c[0]);
        for (std::size_t i = 0; i + 1 < c.size(); ++i)
            c[i] = c[i + 1] - c[i];
        c.pop_back();
        binomial = binomial * (n - k) / (k + 1);
    }
    return result;
}

/// Narrows the bracket by what long double can see, if that is right.
void narrow(const Polynomial& p, Real& a, Real& b, bool negativeAtA) {
    std::vector<long double> c;
    for (const Real& x : p)
        c.push_back(static_cast<long double>(x));
    long double lo = static_cast<long double>(a), hi = static_cast<long double>(b);
    for (int i = 0; i < 60; ++i) {
        const long double t = (lo + hi) / 2;
        long double f = 0;
        for (std::size_t k = c.size(); k-- > 0;)
            f = f * t + c[k];
        ((f < 0) == negativeAtA ? lo : hi) = t;
    }
    const Real low = Real(lo) - Real(1e-11), high = Real(hi) + Real(1e-11);
    if (low > a && (valueAt(p, low) < 0) == negativeAtA) a = low;
    if (high < b && (valueAt(p, high) < 0) != negativeAtA) b = high;
}

/// The change of sign in (a, b), where f(a) and f(b) differ: bisection and Newton.
Real solve(const Polynomial& p, const Polynomial& d, Real a, Real b, bool negativeAtA) {
    narrow(p, a, b, negativeAtA);
    Real t = (a + b) / 2;
    for (int i = 0; i < 200; ++i) {
        const Real f = valueAt(p, t);
        ((f < 0) == negativeAtA ? a : b) = t;
        const Real slope = valueAt(d, t);
        Real next = slope != 0 ? Real(t - f / slope) : a;
        if (!(next > a && next < b) || i % 6 == 5) next = (a + b) / 2;
        const Real step = abs(next - t);
        t = next;
        if (step < Real(1e-22)) break; // Newton: the error is of the order of its square
    }
    return t;
}

/// Whether the convex hull of the Bernstein coefficients excludes zero.
bool isNeverZero(const Polynomial& p) {
    std::vector<Real> c = p;
    const std::size_t n = p.size() - 1;
    Real binomial = 1;
    for (std::size_t k = 0; k <= n; ++k) {
        c[k] /= binomial;
        binomial = binomial * (n - k) / (k + 1);
    }
    for (std::size_t level = 1; level <= n; ++level)
        for (std::size_t i = n; i >= level; --i)
            c[i] += c[i - 1];
    return std::all_of(c.begin(), c.end(), [](const Real& x) { return x > 0; }) ||
           std::all_of(c.begin(), c.end(), [](const Real& x) { return x < 0; });
}

std::vector<Real> signChanges(const Polynomial& p) {
    if (p.size() < 2 || isNeverZero(p)) return {};
    const Polynomial d = derivativeOf(p);
    std::vector<Real> knots = signChanges(d);
    knots.insert(knots.begin(), Real(0));
    knots.push_back(Real(1));
    std::vector<Real> roots;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const bool negative = valueAt(p, knots[i]) < 0;
        if (negative != (valueAt(p, knots[i + 1]) < 0)) roots.push_back(solve(p, d, knots[i], knots[i + 1], negative));
    }
    return roots;
}

void addHorizontal(const Polynomial& x, const Polynomial& y, const Ray& ray, int segment,
                   std::vector<OracleHit>& hits) {
    const Real dx = ray.d.x, dz = ray.d.z, ox = ray.o.x, oz = ray.o.z;
    const Real a = dx * dx + dz * dz, b = ox * dx + oz * dz, cross = ox * dz - oz * dx;
    for (const Real& t : signChanges(combine(y, Real(-1), Polynomial{Real(ray.o.y)}))) {
        const Real radius = valueAt(x, t), discriminant = a * radius * radius - cross * cross;
        if (!(discriminant > 0)) continue;
        for (const int sign : {-1, 1})
            hits.push_back({double((-b + sign * sqrt(discriminant)) / a), segment, double(t)});
    }
}

} // namespace

std::vector<OracleHit> exactHits(const ProfilePoints& profile, const Ray& ray, const V2d& shift) {
    std::vector<OracleHit> hits;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const Polynomial x = powerBasis(profile[i], 0, shift.x), y = powerBasis(profile[i], 1, shift.y);
        if (ray.d.y == 0) {
            addHorizontal(x, y, ray, int(i), hits);
            continue;
        }
        // |o_h d_y + d_h (y - o_y)|^2 = d_y^2 x^2
        const Real dy = ray.d.y;
        Polynomial f = combine(Polynomial{Real(0)}, -dy * dy, product(x, x));
        const Real o[2] = {Real(ray.o.x), Real(ray.o.z)}, d[2] = {Real(ray.d.x), Real(ray.d.z)};
        for (int axis = 0; axis < 2; ++axis) {
            const Polynomial side = combine(Polynomial{Real(o[axis] * dy - d[axis] * Real(ray.o.y))}, d[axis], y);
            f = combine(f, Real(1), product(side, side));
        }
        for (const Real& t : signChanges(f))
            hits.push_back({double((valueAt(y, t) - Real(ray.o.y)) / dy), int(i), double(t)});
    }
    std::sort(hits.begin(), hits.end(), [](const OracleHit& a, const OracleHit& b) { return a.s < b.s; });
    return hits;
}

bool isNearlyTangent(const ProfilePoints& profile, const Ray& ray, double band) {
    const std::size_t count = exactHits(profile, ray).size();
    for (const V2d& shift : {V2d(band, 0), V2d(-band, 0), V2d(0, band), V2d(0, -band)})
        if (exactHits(profile, ray, shift).size() != count) return true;
    for (const double side : {-band, band}) {
        const V3d aside = V3d(ray.d.z, 0, -ray.d.x);
        const V3d step = aside.length2() > 0 ? aside.normalized() * side : V3d(side, 0, 0);
        if (exactHits(profile, Ray{ray.o + step, ray.d}).size() != count) return true;
    }
    return false;
}

ScanOracle::ScanOracle(const ProfilePoints& profile, int samplesPerSegment) : samples_(samplesPerSegment) {
    for (const std::vector<V2d>& segment : profile) {
        points_.emplace_back();
        for (const V2d& p : segment)
            points_.back().push_back({p.x, p.y});
        table_.emplace_back();
        for (int k = 0; k <= samples_; ++k)
            table_.back().push_back(at(int(points_.size()) - 1, (long double)(k) / samples_));
    }
}

ScanOracle::Sample ScanOracle::at(int segment, long double t) const {
    std::vector<Sample> c = points_[std::size_t(segment)];
    for (std::size_t level = c.size() - 1; level > 0; --level)
        for (std::size_t i = 0; i < level; ++i)
            c[i] = {c[i].x + t * (c[i + 1].x - c[i].x), c[i].y + t * (c[i + 1].y - c[i].y)};
    return c[0];
}

struct ScanOracle::Scan {
    const ScanOracle& oracle;
    int segment;
    long double length, h, v, q, e, oy; ///< as in Ray = closest approach to the axis + unit direction
    long double side = 1;               ///< of the closest approach: +1 or -1
    std::vector<OracleHit>& hits;

    /// Height of the curve over the ray's half at the same radius; NaN where the ray does not come so near.
    long double gap(const Sample& c) const {
        const long double inside = (c.x - e) * (c.x + e);
        if (inside < 0) return std::numeric_limits<long double>::quiet_NaN();
        return h * (c.y - oy) + v * q - v * side * std::sqrt(inside);
    }
    long double gap(long double t) const { return gap(oracle.at(segment, t)); }

    void found(long double t) const {
        const Sample c = oracle.at(segment, t);
        const long double g = side * std::sqrt(std::max(0.L, (c.x - e) * (c.x + e)));
        const long double l = std::fabs(v) * c.x < std::fabs(g) * h ? (g - q) / h : (c.y - oy) / v;
        hits.push_back({double(l / length), segment, double(t)});
    }
    void bisect(long double a, long double b) const {
        const bool negativeAtA = gap(a) < 0;
        for (int i = 0; i < 70; ++i) {
            const long double m = (a + b) / 2;
            ((gap(m) < 0) == negativeAtA ? a : b) = m;
        }
        found((a + b) / 2);
    }
    /// a is out of the ray's reach, b is not.
    long double edge(long double a, long double b) const {
        for (int i = 0; i < 70; ++i) {
            const long double m = (a + b) / 2;
            (std::isnan(gap(m)) ? a : b) = m;
        }
        return b;
    }
    void interval(long double a, long double b, long double ga, long double gb) const {
        if (std::isnan(ga) && std::isnan(gb)) return;
        if (std::isnan(ga)) ga = gap(a = edge(a, b));
        if (std::isnan(gb)) gb = gap(b = edge(b, a));
        if ((ga < 0) != (gb < 0)) bisect(a, b);
    }
    /// |gap| is least somewhere in (a, b): if it goes below zero there, two crossings.
    void dip(long double a, long double b, bool negative) const {
        const long double ratio = 0.61803398874989484820L, lo = a, hi = b;
        const auto magnitude = [&](long double t) { return negative ? -gap(t) : gap(t); };
        long double p = b - ratio * (b - a), r = a + ratio * (b - a), fp = magnitude(p), fr = magnitude(r);
        for (int i = 0; i < 60; ++i) {
            const long double least = std::min(fp, fr);
            if (least < 0) {
                const long double t = fp < 0 ? p : r;
                bisect(lo, t);
                bisect(t, hi);
                return;
            }
            if (fp < fr)
                b = r, r = p, fr = fp, p = b - ratio * (b - a), fp = magnitude(p);
            else
                a = p, p = r, fp = fr, r = a + ratio * (b - a), fr = magnitude(r);
        }
    }
    void run() const {
        const std::vector<Sample>& table = oracle.table_[std::size_t(segment)];
        const auto time = [&](int k) { return (long double)(k) / oracle.samples_; };
        long double before = 0, here = gap(table[0]), next = gap(table[1]);
        for (int k = 0; k < oracle.samples_; ++k) {
            interval(time(k), time(k + 1), here, next);
            before = here;
            here = next;
            next = k + 2 <= oracle.samples_ ? gap(table[std::size_t(k + 2)]) : before;
            const bool same = (before < 0) == (here < 0) && (here < 0) == (next < 0);
            // A parabola through the three goes deeper by at most a quarter of the larger difference; twice that and more
            // for what is not one.
            const long double reach = std::max(std::fabs(before - here), std::fabs(next - here));
            if (k + 2 <= oracle.samples_ && same && std::fabs(here) <= std::fabs(before) &&
                std::fabs(here) <= std::fabs(next) && std::fabs(here) <= reach)
                dip(time(k), time(k + 2), here < 0);
        }
    }
};

std::vector<OracleHit> ScanOracle::hits(const Ray& ray) const {
    std::vector<OracleHit> all;
    const long double dx = ray.d.x, dy = ray.d.y, dz = ray.d.z;
    const long double horizontal = std::sqrt(dx * dx + dz * dz);
    const long double ux = horizontal > 0 ? dx / horizontal : 1, uz = horizontal > 0 ? dz / horizontal : 0;
    for (int i = 0; i < int(points_.size()); ++i) {
        Scan scan{*this, i, std::sqrt(dx * dx + dy * dy + dz * dz), 0, 0, 0, 0, ray.o.y, 1, all};
        scan.h = horizontal / scan.length;
        scan.v = dy / scan.length;
        scan.q = ray.o.x * ux + ray.o.z * uz;
        scan.e = std::fabs(ray.o.x * uz - ray.o.z * ux);
        scan.run();
        scan.side = -1;
        scan.run();
    }
    std::sort(all.begin(), all.end(), [](const OracleHit& a, const OracleHit& b) { return a.s < b.s; });
    return all;
}

double residual(const ProfilePoints& profile, const Ray& ray, double s, int segment, double t) {
    std::vector<V2d> points = profile[std::size_t(segment)];
    std::vector<long double> x, y;
    for (const V2d& p : points)
        x.push_back(p.x), y.push_back(p.y);
    const long double b = t, a = 1 - b;
    for (std::size_t level = x.size() - 1; level > 0; --level)
        for (std::size_t i = 0; i < level; ++i)
            x[i] = a * x[i] + b * x[i + 1], y[i] = a * y[i] + b * y[i + 1];
    const long double px = ray.o.x + (long double)(s)*ray.d.x, py = ray.o.y + (long double)(s)*ray.d.y;
    const long double pz = ray.o.z + (long double)(s)*ray.d.z;
    return double(std::hypot(std::sqrt(px * px + pz * pz) - x[0], py - y[0]));
}

} // namespace vitrine::test
