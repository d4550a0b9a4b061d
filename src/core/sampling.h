// Mappings from the unit square to the domains of rendering, with their densities, and discrete distributions.
#pragma once

#include "core/vec.h"

#include <span>
#include <vector>

namespace vitrine {

/// Concentric map of the unit square to the unit disk (Shirley & Chiu 1997). Density 1/pi.
V2f sampleUniformDisk(const V2f& u);

/// Cosine-weighted direction about +z. Density cos/pi.
inline V3f sampleCosineHemisphere(const V2f& u) {
    const V2f d = sampleUniformDisk(u);
    return V3f(d.x, d.y, safeSqrt(1 - d.x * d.x - d.y * d.y));
}

/// Uniform direction on the sphere. Density 1/(4 pi).
inline V3f sampleUniformSphere(const V2f& u) {
    const float z = 1 - 2 * u.x, r = safeSqrt(1 - z * z), phi = 2 * pi * u.y;
    return V3f(r * std::cos(phi), r * std::sin(phi), z);
}

/// Barycentric coordinates (b0, b1) of a uniform point in a triangle (Heitz 2019, "A low-distortion map").
inline V2f sampleUniformTriangle(const V2f& u) {
    return u.x < u.y ? V2f(u.x / 2, u.y - u.x / 2) : V2f(u.x - u.y / 2, u.y / 2);
}

/// Veach 1997, eq. 9.13 with beta = 2, one sample of each strategy.
inline float powerHeuristic(float pdfA, float pdfB) {
    // Scaled by the larger: the squares of delta-like densities overflow float.
    if (!(pdfA > 0)) return 0;
    const float ratio = pdfB / pdfA;
    return 1 / (1 + ratio * ratio);
}

/// Piecewise-constant density on [0,1] from non-negative weights; all zero means uniform.
class PiecewiseConstant1D {
  public:
    struct Sample {
        float x;
        float pdf;
        int bin;
    };
    PiecewiseConstant1D() = default;
    /// \throws std::invalid_argument when there are none, or one is negative or not finite
    explicit PiecewiseConstant1D(std::span<const float> weights);

    int size() const { return int(weights_.size()); }
    /// Mean of the weights: the function's integral over [0,1].
    double integral() const { return integral_; }
    Sample sample(float u) const;
    float pdf(float x) const;
    /// Probability of the bin as a whole.
    float probability(int bin) const;

  private:
    int binOf(float x) const;

    std::vector<float> weights_;
    std::vector<double> cdf_; ///< size()+1 values from 0 to 1
    double integral_ = 0;
};

/// Piecewise-constant density on the unit square; rows along v.
class PiecewiseConstant2D {
  public:
    struct Sample {
        V2f p;
        float pdf;
    };
    PiecewiseConstant2D() = default;
    /// \param weights height x width, row-major, row 0 at v = 0.
    PiecewiseConstant2D(std::span<const float> weights, int width, int height);

    double integral() const { return marginal_.integral(); }
    Sample sample(const V2f& u) const;
    float pdf(const V2f& p) const;

  private:
    std::vector<PiecewiseConstant1D> rows_;
    PiecewiseConstant1D marginal_;
};

/// Discrete distribution with O(1) sampling (Walker 1977; Vose 1991); all zero means uniform.
///
/// The probabilities are the weights' rounded to multiples of 2^-24, as uniform numbers are: sample() draws each entry
/// for exactly so many of the 2^24 values of u, so that dividing by a probability is never off, however small it is. No
/// positive weight rounds to 0 while there are at most 2^23 of them. Of u's 24 bits the table's size takes some and the
/// choice within a bin has the rest.
class AliasTable {
  public:
    struct Sample {
        int index;
        float probability;
    };
    AliasTable() = default;
    /// \throws std::invalid_argument when there are none, or one is negative or not finite
    explicit AliasTable(std::span<const double> weights);

    int size() const { return int(probabilities_.size()); }
    float probability(int index) const { return probabilities_[std::size_t(index)]; }
    /// \param remapped if not null, receives a fresh uniform number made of what u had left.
    Sample sample(float u, float* remapped = nullptr) const;

  private:
    struct Bin {
        std::uint32_t threshold; ///< of the bin's values of u, so many are the entry's of the same number
        std::uint32_t alias;     ///< and the others this one's
    };
    void fill(std::vector<std::uint32_t> counts);

    std::vector<Bin> bins_; ///< 2^binBits_
    unsigned binBits_ = 0;
    std::vector<float> probabilities_;
};

} // namespace vitrine
