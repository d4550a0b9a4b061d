// Polynomials on [0,1] in the Bernstein basis: p(t) = sum_k c_k binomial(n,k) t^k (1-t)^(n-k).
//
// Zero counts as positive throughout. That is a symbolic perturbation: a root that falls exactly on the point where
// two polynomials meet belongs to one side only, and a touch of zero from above is no crossing.
#pragma once

#include <span>
#include <vector>

namespace vitrine::bernstein {

/// Exact up to n = 60, correctly rounded factors beyond.
double binomial(int n, int k);

/// The product, of degree deg a + deg b. All weights are positive and sum to 1: well conditioned.
std::vector<double> multiply(std::span<const double> a, std::span<const double> b);

/// The same polynomial in a higher degree.
std::vector<double> elevate(std::span<const double> a, int degree);

/// Coefficients of the derivative, one fewer (a constant gives a single zero).
std::vector<double> derivative(std::span<const double> a);

/// De Casteljau: value at t.
double evaluate(std::span<const double> a, double t);

/// De Casteljau: `c` (size n) becomes the part over [t, 1], `left` receives the part over [0, t]. The shared
/// coefficient has the same bits on both sides, and equal coefficients stay equal (a flat rim stays flat).
inline void split(double* c, double* left, int n, double t) {
    left[0] = c[0];
    for (int level = 1; level < n; ++level) {
        for (int i = 0; i < n - level; ++i)
            c[i] = c[i] + t * (c[i + 1] - c[i]);
        left[level] = c[0];
    }
}

inline void halve(double* c, double* left, int n) {
    left[0] = c[0];
    for (int level = 1; level < n; ++level) {
        for (int i = 0; i < n - level; ++i)
            c[i] = 0.5 * (c[i] + c[i + 1]);
        left[level] = c[0];
    }
}

/// Sign changes along the coefficients: by Descartes' rule at least the number of roots, and of the same parity.
inline int signVariations(const double* c, int n) {
    int variations = 0;
    for (int i = 1; i < n; ++i)
        variations += (c[i] < 0) != (c[i - 1] < 0);
    return variations;
}

/// Where the polynomial changes sign, by bisection in the Bernstein basis (Mourrain & Rouillier 2005) to full
/// precision; coefficients below `noise` in magnitude are taken for rounding. For building, not for rays.
std::vector<double> signChanges(std::span<const double> a, double noise);

} // namespace vitrine::bernstein
