#include "support/revolution_exact.h"

#include <algorithm>
#include <bit>

namespace vitrine::test {

namespace {

using Integer = boost::multiprecision::cpp_int;
using Coefficients = std::vector<Integer>;

/// The least b >= 0 such that x 2^b is an integer.
int fractionBits(double x) {
    if (x == 0) return 0;
    int exponent;
    const auto mantissa = std::uint64_t(std::ldexp(std::abs(std::frexp(x, &exponent)), 53));
    return std::max(0, 53 - exponent - std::countr_zero(mantissa));
}

/// x 2^bits, which is an integer.
Integer fixedPoint(double x, int bits) {
    if (x == 0) return 0;
    int exponent;
    const auto mantissa = std::int64_t(std::ldexp(std::frexp(x, &exponent), 53));
    const int shift = exponent - 53 + bits;
    // The bits shifted out are zero.
    return shift >= 0 ? Integer(mantissa) << shift : Integer(mantissa / (std::int64_t(1) << -shift));
}

Coefficients binomials(std::size_t n) {
    Coefficients row{1};
    for (std::size_t k = 0; k < n; ++k)
        row.push_back(row.back() * (n - k) / (k + 1));
    return row;
}

/// Bernstein coefficients of a b, times `common`, a multiple of every binomial of their degree.
Coefficients product(const Coefficients& a, const Coefficients& b, const Integer& common) {
    const std::size_t m = a.size() - 1, n = b.size() - 1;
    const Coefficients am = binomials(m), bn = binomials(n), both = binomials(m + n);
    Coefficients result(m + n + 1, Integer(0));
    for (std::size_t i = 0; i <= m; ++i)
        for (std::size_t k = 0; k <= n; ++k)
            result[i + k] += am[i] * a[i] * bn[k] * b[k];
    for (std::size_t k = 0; k <= m + n; ++k)
        result[k] *= common / both[k];
    return result;
}

int variations(const Coefficients& c) {
    int count = 0;
    for (std::size_t k = 1; k < c.size(); ++k)
        count += (c[k] < 0) != (c[k - 1] < 0);
    return count;
}

/// c becomes the right half, the left half is returned; both times 2^(degree).
Coefficients halve(Coefficients& c) {
    const std::size_t n = c.size() - 1;
    Coefficients left(n + 1);
    left[0] = c[0] << unsigned(n);
    for (std::size_t level = 1; level <= n; ++level) {
        for (std::size_t i = 0; i + level <= n; ++i)
            c[i] += c[i + 1];
        left[level] = c[0] << unsigned(n - level);
    }
    for (std::size_t i = 1; i <= n; ++i)
        c[i] <<= unsigned(i);
    return left;
}

/// x 2^-exponent, to 64 bits.
long double rounded(const Integer& x, int exponent) {
    if (x == 0) return 0;
    const Integer magnitude = abs(x);
    const int excess = int(msb(magnitude)) - 63;
    const auto mantissa = std::uint64_t(excess > 0 ? Integer(magnitude >> excess) : magnitude);
    const long double value = std::ldexp((long double)(mantissa), std::max(excess, 0) - exponent);
    return x < 0 ? -value : value;
}

/// The only change of sign in (0,1), by bisection.
long double onlyRoot(const Coefficients& c) {
    int exponent = 0;
    for (const Integer& x : c)
        if (x != 0) exponent = std::max(exponent, int(msb(Integer(abs(x)))));
    std::vector<long double> value;
    for (const Integer& x : c)
        value.push_back(rounded(x, exponent));
    const std::size_t n = c.size() - 1;
    const Coefficients factor = binomials(n);
    for (std::size_t k = 0; k <= n; ++k)
        value[k] *= rounded(factor[k], 0);
    long double a = 0, b = 1;
    for (int i = 0; i < 64; ++i) {
        const long double t = (a + b) / 2, u = 1 - t;
        long double power = 1, sum = value[0] * u;
        for (std::size_t k = 1; k < n; ++k) {
            power *= t;
            sum = (sum + power * value[k]) * u;
        }
        sum += power * t * value[n];
        ((sum < 0) == (c[0] < 0) ? a : b) = t;
    }
    return (a + b) / 2;
}

} // namespace

ExactOracle::ExactOracle(const ProfilePoints& profile) {
    for (const std::vector<V2d>& points : profile) {
        Segment segment{SlowCurve(points), 0, 1, {}, {}, {}, {}};
        for (const V2d& p : points)
            segment.fractionBits = std::max({segment.fractionBits, fractionBits(p.x), fractionBits(p.y)});
        Coefficients x;
        for (const V2d& p : points) {
            x.push_back(fixedPoint(p.x, segment.fractionBits));
            segment.y.push_back(fixedPoint(p.y, segment.fractionBits));
        }
        for (const Integer& b : binomials(2 * points.size() - 2))
            segment.one = lcm(segment.one, b);
        segment.y1 = product(segment.y, Coefficients(points.size(), Integer(1)), segment.one);
        segment.xx = product(x, x, segment.one);
        segment.yy = product(segment.y, segment.y, segment.one);
        segments_.push_back(std::move(segment));
    }
}

Coefficients ExactOracle::rayPolynomial(const Segment& segment, const Ray& ray) {
    const int pBits = segment.fractionBits;
    int oBits = 0, dBits = 0;
    for (int i = 0; i < 3; ++i) {
        oBits = std::max(oBits, fractionBits(ray.o[i]));
        dBits = std::max(dBits, fractionBits(ray.d[i]));
    }
    Integer o[3], d[3];
    for (int i = 0; i < 3; ++i) {
        o[i] = fixedPoint(ray.o[i], oBits);
        d[i] = fixedPoint(ray.d[i], dBits);
    }
    // F = (d_x^2 + d_z^2) y^2 + 2 (d_x A + d_z B) y + A^2 + B^2 - d_y^2 x^2, in units of 2^-2(pBits + oBits + dBits).
    const Integer a = o[0] * d[1] - d[0] * o[1], b = o[2] * d[1] - d[2] * o[1];
    const Integer quadratic = (d[0] * d[0] + d[2] * d[2]) << (2 * oBits);
    const Integer linear = (2 * (d[0] * a + d[2] * b)) << (oBits + pBits);
    const Integer constant = ((a * a + b * b) << (2 * pBits)) * segment.one;
    const Integer radial = (d[1] * d[1]) << (2 * oBits);
    Coefficients c;
    for (std::size_t k = 0; k < segment.xx.size(); ++k)
        c.push_back(quadratic * segment.yy[k] + linear * segment.y1[k] + constant - radial * segment.xx[k]);
    return c;
}

Coefficients ExactOracle::heightPolynomial(const Segment& segment, double height) {
    const int bits = fractionBits(height), common = std::max(bits, segment.fractionBits);
    Coefficients c;
    for (const Integer& y : segment.y)
        c.push_back((y << (common - segment.fractionBits)) - fixedPoint(height, common));
    return c;
}

/// |(d_x, d_z)|^2 (y - o_y) + d_y (o_x d_x + o_z d_z).
Coefficients ExactOracle::risePolynomial(const Segment& segment, const Ray& ray) {
    int bits = segment.fractionBits;
    for (int i = 0; i < 3; ++i)
        bits = std::max({bits, fractionBits(ray.o[i]), fractionBits(ray.d[i])});
    Integer o[3], d[3];
    for (int i = 0; i < 3; ++i) {
        o[i] = fixedPoint(ray.o[i], bits);
        d[i] = fixedPoint(ray.d[i], bits);
    }
    const Integer h2 = d[0] * d[0] + d[2] * d[2], constant = d[1] * (o[0] * d[0] + o[2] * d[2]) - h2 * o[1];
    Coefficients c;
    for (const Integer& y : segment.y)
        c.push_back(h2 * (y << (bits - segment.fractionBits)) + constant);
    return c;
}

void ExactOracle::isolate(Coefficients c, Coefficients side, long double ta, long double width,
                          std::vector<Root>& roots) {
    const int count = variations(c);
    if (count == 0) return;
    const bool sideIsKnown = side.empty() || variations(side) == 0;
    if ((count == 1 && sideIsKnown) || width < 0x1p-100L) {
        if (count % 2 == 1)
            roots.push_back({ta + width * (count == 1 ? onlyRoot(c) : 0.5L), !side.empty() && side[0] < 0});
        return;
    }
    Coefficients left = halve(c), leftSide = side.empty() ? side : halve(side);
    isolate(std::move(left), std::move(leftSide), ta, width / 2, roots);
    isolate(std::move(c), std::move(side), ta + width / 2, width / 2, roots);
}

std::vector<OracleHit> ExactOracle::hits(const Ray& ray) const {
    const HalfPlaneRay half(ray);
    const bool horizontal = ray.d.y == 0, shallow = !horizontal && std::fabs(half.v) < 1e-3L;
    std::vector<OracleHit> hits;
    std::vector<Root> roots;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        const Segment& segment = segments_[i];
        roots.clear();
        isolate(horizontal ? heightPolynomial(segment, ray.o.y) : rayPolynomial(segment, ray),
                shallow ? risePolynomial(segment, ray) : Coefficients{}, 0, 1, roots);
        for (const auto& [t, riseIsNegative] : roots) {
            const SlowCurve::Sample c = segment.curve.at(t);
            const auto add = [&](bool forward) {
                hits.push_back({double(half.lengthAt(c.x, c.y, forward) / half.length), int(i), double(t), forward});
            };
            if (!horizontal) {
                add((shallow ? riseIsNegative : half.rise(c.y) < 0) == (half.v < 0));
            } else if (c.x > half.e) {
                add(false);
                add(true);
            }
        }
    }
    std::sort(hits.begin(), hits.end(), [](const OracleHit& a, const OracleHit& b) { return a.s < b.s; });
    return hits;
}

} // namespace vitrine::test
