// Pearson's chi-squared test of samples against the density they claim, and the quadrature that it needs.
#pragma once

#include "core/random.h"
#include "core/vec.h"

#include <functional>
#include <optional>
#include <string>

namespace vitrine::test {

/// Draws one sample; empty when the sampler gives none. What is missing must be missing from the density too.
using SphereSampler = std::function<std::optional<V3f>(RandomStream&)>;
using SquareSampler = std::function<std::optional<V2f>(RandomStream&)>;
/// Density per steradian, or per unit area.
using SphereDensity = std::function<double(const V3f&)>;
using SquareDensity = std::function<double(const V2f&)>;

struct ChiSquaredSettings {
    int rows = 16;                ///< bands of equal theta, or along v; even, so that the horizon is no cell's inside
    int columns = 32;             ///< sectors of phi, or along u
    std::size_t samples = 100000; ///< drawn, failures included
    double minExpected = 5;       ///< cells that expect fewer are merged (Cochran 1954)
    std::uint64_t seed = 1;
};

struct ChiSquaredResult {
    double statistic = 0;
    int dof = 0;
    /// Chance of as bad a fit or worse if the density were right; 0 for a density that is negative, not finite, or of
    /// mass above 1. Takes in samples that fall where the density is 0.
    double pValue = 0;
    double mass = 0;         ///< integral of the density
    std::size_t missing = 0; ///< draws that gave no sample
    std::string report;      ///< all of this in words
};

/// Samples of directions against a density on the sphere.
ChiSquaredResult chiSquaredSphere(const SphereSampler& sample, const SphereDensity& pdf,
                                  const ChiSquaredSettings& settings = {});
/// Samples of [0,1]^2 against a density on it.
ChiSquaredResult chiSquaredSquare(const SquareSampler& sample, const SquareDensity& pdf,
                                  const ChiSquaredSettings& settings = {});

/// Adaptive 5 x 5 Gauss-Legendre quadrature over a rectangle; relative error about 1e-4, absolute 1e-7 or better.
double integrateRectangle(const std::function<double(double, double)>& f, const V2d& low, const V2d& high);
/// The integral over the sphere, summed over rows x columns cells of equal angles.
double integrateSphere(const SphereDensity& f, int rows = 16, int columns = 32);

/// P(X >= statistic) of a chi-squared variable.
double chiSquaredPValue(double statistic, int dof);
/// The p-value below which one of `tests` independent tests fails, so that all pass with probability 1 - significance
/// when nothing is wrong (Sidak 1967).
double sidakThreshold(double significance, int tests);
/// Two-sided p-value of a standard normal variable.
double normalPValue(double z);

} // namespace vitrine::test
