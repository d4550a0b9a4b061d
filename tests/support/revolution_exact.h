// The judge of all crossings: a ray and a turned Bezier profile in exact integers.
#pragma once

#include "support/revolution_oracle.h"

#include <boost/multiprecision/cpp_int.hpp>

namespace vitrine::test {

/// A ray (o, d) meets the profile (x(t), y(t)) where
///     F(t) = |(o_x, o_z) d_y + (d_x, d_z) (y(t) - o_y)|^2 - d_y^2 x(t)^2
/// changes sign. Doubles are integers times a power of two, so that F's Bernstein coefficients are integers, and so are
/// those of its halves, their halves, and so on (Vincent's theorem: Descartes' count of sign variations becomes 0 or 1).
/// Nothing is rounded until every change of sign in (0,1) is alone in its interval; then its place is found in long
/// double from that interval's own coefficients. On which half of the ray's hyperbola it lies, the sign of
/// P(t) = |(d_x, d_z)|^2 (y(t) - o_y) + d_y (o_x d_x + o_z d_z) says, for shallow rays in integers too.
///
/// Zero counts as positive, as if the ray were moved aside by an infinitesimal. Roots that 2^-100 of a segment does not
/// part are one place, a crossing if their number is odd. Horizontal rays: the same with y(t) - o_y for F.
class ExactOracle {
  public:
    explicit ExactOracle(const ProfilePoints& profile);
    /// Every crossing on the whole line, ascending in s.
    std::vector<OracleHit> hits(const Ray& ray) const;

  private:
    using Integer = boost::multiprecision::cpp_int;
    using Coefficients = std::vector<Integer>;

    struct Segment {
        SlowCurve curve;
        int fractionBits;           ///< F's terms are integers in units of 2^-fractionBits of the control points'
        Integer one;                ///< times a common denominator of the coefficients of degree 2n
        Coefficients y, y1, xx, yy; ///< y; then y, x^2, y^2 in degree 2n times `one`
    };
    static Coefficients rayPolynomial(const Segment& segment, const Ray& ray);
    static Coefficients heightPolynomial(const Segment& segment, double height);
    static Coefficients risePolynomial(const Segment& segment, const Ray& ray);
    struct Root {
        long double t;
        bool sideIsNegative; ///< sign of the polynomial `side` at the root
    };
    static void isolate(Coefficients c, Coefficients side, long double ta, long double width, std::vector<Root>& roots);

    std::vector<Segment> segments_;
};

} // namespace vitrine::test
