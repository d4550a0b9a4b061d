#include "shapes/revolution/bernstein_form.h"

#include "shapes/revolution/bernstein.h"

namespace vitrine {

namespace {

std::vector<V2d> differences(const std::vector<V2d>& c) {
    if (c.size() < 2) return {V2d(0, 0)};
    std::vector<V2d> result(c.size() - 1);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = (c[i + 1] - c[i]) * double(result.size());
    return result;
}

std::vector<V2d> scaledByBinomials(std::vector<V2d> c) {
    for (std::size_t i = 0; i < c.size(); ++i)
        c[i] *= bernstein::binomial(int(c.size()) - 1, int(i));
    return c;
}

double largest(const std::vector<V2d>& c) {
    double result = 0;
    for (const V2d& p : c)
        result = std::max({result, std::abs(p.x), std::abs(p.y)});
    return result;
}

V2d horner(const std::vector<V2d>& scaled, double t) {
    const std::size_t n = scaled.size() - 1;
    const double u = 1 - t;
    double power = 1;
    V2d sum(0, 0);
    if (t <= 0.5) {
        const double z = t / u;
        sum = scaled[n];
        for (std::size_t k = n; k-- > 0; power *= u)
            sum = sum * z + scaled[k];
    } else {
        const double z = u / t;
        sum = scaled[0];
        for (std::size_t k = 1; k <= n; ++k, power *= t)
            sum = sum * z + scaled[k];
    }
    return sum * power;
}

} // namespace

/// The term of b_k goes through at most 2k roundings of z^k, 2k of Horner's rule, 2n of the power and 3 more, half an
/// eps each; the weights' mean of k (or of n - k) is at most n/2. In all (2n + 2) eps of the largest coefficient.
BernsteinForm::BernsteinForm(const std::vector<V2d>& points) {
    constexpr double eps = std::numeric_limits<double>::epsilon();
    const std::vector<V2d> d1 = differences(points), d2 = differences(d1);
    scaled_ = scaledByBinomials(points);
    scaledD1_ = scaledByBinomials(d1);
    scaledD2_ = scaledByBinomials(d2);
    const double n = double(points.size()) - 1;
    // One more for the rounding of differences; those of the first derivative come again in the second, (n - 1)-fold.
    error_.p = (2 * n + 2) * eps * largest(points);
    error_.d1 = (2 * n + 1) * eps * largest(d1);
    error_.d2 = (2 * n - 1) * eps * largest(d2) + 2 * (n - 1) * eps * largest(d1);
}

V2d BernsteinForm::point(double t) const {
    return horner(scaled_, t);
}

CurvePoint BernsteinForm::evaluate(double t) const {
    return {horner(scaled_, t), horner(scaledD1_, t), horner(scaledD2_, t)};
}

} // namespace vitrine
