#include "shapes/revolution/bernstein.h"

#include <algorithm>
#include <cmath>

namespace vitrine::bernstein {

double binomial(int n, int k) {
    k = std::min(k, n - k);
    double result = 1;
    for (int i = 1; i <= k; ++i)
        result = std::round(result * (n - k + i) / i);
    return result;
}

std::vector<double> multiply(std::span<const double> a, std::span<const double> b) {
    const int m = int(a.size()) - 1, n = int(b.size()) - 1;
    std::vector<double> product(std::size_t(m + n + 1));
    for (int k = 0; k <= m + n; ++k) {
        double sum = 0;
        for (int i = std::max(0, k - n); i <= std::min(k, m); ++i)
            sum +=
                binomial(m, i) * binomial(n, k - i) / binomial(m + n, k) * (a[std::size_t(i)] * b[std::size_t(k - i)]);
        product[std::size_t(k)] = sum;
    }
    return product;
}

std::vector<double> elevate(std::span<const double> a, int degree) {
    const std::vector<double> one(std::size_t(degree - int(a.size()) + 2), 1.);
    return multiply(a, one);
}

std::vector<double> derivative(std::span<const double> a) {
    if (a.size() < 2) return {0.};
    std::vector<double> result(a.size() - 1);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = double(result.size()) * (a[i + 1] - a[i]);
    return result;
}

double evaluate(std::span<const double> a, double t) {
    std::vector<double> c(a.begin(), a.end());
    for (std::size_t level = c.size() - 1; level > 0; --level)
        for (std::size_t i = 0; i < level; ++i)
            c[i] = c[i] + t * (c[i + 1] - c[i]);
    return c[0];
}

namespace {

double bisect(std::span<const double> a, double ta, double tb, bool negativeAtA) {
    while (true) {
        const double t = (ta + tb) / 2;
        if (t <= ta || t >= tb) return t;
        ((evaluate(a, t) < 0) == negativeAtA ? ta : tb) = t;
    }
}

void search(std::span<const double> whole, std::vector<double> c, double ta, double tb, double noise,
            std::vector<double>& found) {
    constexpr double minWidth = 0x1p-40;
    const int n = int(c.size());
    const int variations = signVariations(c.data(), n);
    if (variations == 0) return;
    const bool isNoise = std::all_of(c.begin(), c.end(), [&](double x) { return std::abs(x) <= noise; });
    if (variations == 1 || isNoise || tb - ta < minWidth) {
        if ((c.front() < 0) != (c.back() < 0)) found.push_back(bisect(whole, ta, tb, c.front() < 0));
        return;
    }
    std::vector<double> left(c.size());
    halve(c.data(), left.data(), n);
    const double tm = (ta + tb) / 2;
    search(whole, std::move(left), ta, tm, noise, found);
    search(whole, std::move(c), tm, tb, noise, found);
}

} // namespace

std::vector<double> signChanges(std::span<const double> a, double noise) {
    std::vector<double> found;
    search(a, std::vector<double>(a.begin(), a.end()), 0, 1, noise, found);
    return found;
}

} // namespace vitrine::bernstein
