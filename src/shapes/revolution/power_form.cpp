#include "shapes/revolution/power_form.h"

namespace vitrine {

namespace {

// Differences of smooth curves cancel by up to 2^n.
#ifdef __SIZEOF_FLOAT128__
__extension__ using Wide = __float128;
#else
using Wide = long double;
#endif

/// A Bernstein polynomial of these coefficients at t < 1: de Casteljau's value, by the weights of the basis, in O(n).
Wide weightedMean(const std::vector<Wide>& c, double t) {
    const std::size_t n = c.size() - 1;
    const Wide ratio = Wide(t) / (1 - Wide(t));
    Wide weight = 1, sum = 0;
    for (std::size_t k = 0; k < n; ++k)
        weight *= 1 - Wide(t);
    for (std::size_t k = 0; k <= n; ++k) {
        sum += weight * c[k];
        weight *= Wide(double(n - k)) / Wide(double(k + 1)) * ratio;
    }
    return sum;
}

} // namespace

PowerForm::PowerForm(const std::vector<V2d>& points, double centre) : centre_(centre), c_(points.size()) {
    const std::size_t n = points.size() - 1;
    for (int axis = 0; axis < 2; ++axis) {
        std::vector<Wide> difference;
        for (const V2d& p : points)
            difference.push_back(p[axis]);
        Wide binomial = 1;
        for (std::size_t k = 0; k <= n; ++k) {
            c_[k][axis] = double(binomial * (centre < 1 ? weightedMean(difference, centre) : difference.back()));
            binomial *= Wide(double(n - k)) / Wide(double(k + 1));
            for (std::size_t i = 0; i + 1 < difference.size(); ++i)
                difference[i] = difference[i + 1] - difference[i];
            difference.pop_back();
        }
    }
    // Horner's rule rounds the term of c_k 2k times, t - centre once and so its powers k times, c_k once, half an eps
    // each (Higham 2002, 5.1 and 5.2); every derivative rounds as often again.
    constexpr double eps = std::numeric_limits<double>::epsilon();
    const double reach = std::max(centre, 1 - centre);
    for (int axis = 0; axis < 2; ++axis) {
        CurvePointError sum;
        double power = 1; // reach^k
        for (std::size_t k = 0; k <= n; ++k, power *= reach) {
            const double order = double(k), term = eps * std::abs(c_[k][axis]) * power;
            sum.p += (1.5 * order + 1) * term;
            sum.d1 += (2.5 * order + 1) * order / reach * term;
            sum.d2 += (3.5 * order + 1) * order * (order - 1) / sqr(reach) * term;
        }
        error_.p = std::max(error_.p, sum.p);
        error_.d1 = std::max(error_.d1, sum.d1);
        error_.d2 = std::max(error_.d2, sum.d2);
    }
}

} // namespace vitrine
