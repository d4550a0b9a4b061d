#include "core/sampling.h"

#include <stdexcept>

namespace vitrine {

namespace {

constexpr float oneMinusEpsilon = 0x1.fffffep-1f;

template <class Weight>
void checkWeights(std::span<const Weight> weights) {
    if (weights.empty()) throw std::invalid_argument("a distribution needs at least one weight");
    double total = 0;
    for (const Weight w : weights) {
        if (!(w >= 0)) throw std::invalid_argument("the weights of a distribution must not be negative or NaN");
        total += double(w);
    }
    if (!std::isfinite(total)) throw std::invalid_argument("the weights of a distribution must be finite");
}

} // namespace

namespace {

/// sin and cos of |x| <= pi/4 by their Taylor series, to 3e-8: the library's reduce arguments of any size, which takes
/// longer than all else here.
float smallSin(float x) {
    const float z = x * x;
    return x * (1 + z * (-1 / 6.f + z * (1 / 120.f + z * (-1 / 5040.f + z * (1 / 362880.f)))));
}

float smallCos(float x) {
    const float z = x * x;
    return 1 + z * (-0.5f + z * (1 / 24.f + z * (-1 / 720.f + z * (1 / 40320.f))));
}

} // namespace

V2f sampleUniformDisk(const V2f& u) {
    const float x = 2 * u.x - 1, y = 2 * u.y - 1;
    if (x == 0 && y == 0) return V2f(0, 0);
    if (std::abs(x) > std::abs(y)) {
        const float theta = pi / 4 * (y / x);
        return V2f(x * smallCos(theta), x * smallSin(theta));
    }
    // The angle is pi/2 less this one.
    const float theta = pi / 4 * (x / y);
    return V2f(y * smallSin(theta), y * smallCos(theta));
}

PiecewiseConstant1D::PiecewiseConstant1D(std::span<const float> weights) : weights_(weights.begin(), weights.end()) {
    checkWeights(weights);
    const std::size_t n = weights_.size();
    cdf_.assign(n + 1, 0);
    for (std::size_t i = 0; i < n; ++i)
        cdf_[i + 1] = cdf_[i] + weights_[i];
    const double total = cdf_[n];
    integral_ = total / double(n);
    if (!(total > 0)) weights_.assign(n, 1.f);
    for (std::size_t i = 0; i <= n; ++i)
        cdf_[i] = total > 0 ? cdf_[i] / total : double(i) / double(n);
}

PiecewiseConstant1D::Sample PiecewiseConstant1D::sample(float u) const {
    // The last bin whose cdf is at most u and whose width is not zero.
    auto it = std::upper_bound(cdf_.begin(), cdf_.end(), double(u));
    std::size_t bin = std::size_t(std::max<std::ptrdiff_t>(0, it - cdf_.begin() - 1));
    bin = std::min(bin, weights_.size() - 1);
    const double width = cdf_[bin + 1] - cdf_[bin];
    const double within = width > 0 ? std::clamp((double(u) - cdf_[bin]) / width, 0., 1.) : 0;
    float x = std::min(float((double(bin) + within) / double(weights_.size())), oneMinusEpsilon);
    // Rounded to float, x may have left its bin for a neighbour of quite another density.
    while (binOf(x) > int(bin))
        x = std::nextafter(x, 0.f);
    while (binOf(x) < int(bin) && x < oneMinusEpsilon)
        x = std::nextafter(x, 1.f);
    return {x, probability(int(bin)) * float(size()), int(bin)};
}

int PiecewiseConstant1D::binOf(float x) const {
    return std::clamp(int(x * float(size())), 0, size() - 1);
}

float PiecewiseConstant1D::pdf(float x) const {
    return probability(binOf(x)) * float(size());
}

float PiecewiseConstant1D::probability(int bin) const {
    return float(cdf_[std::size_t(bin) + 1] - cdf_[std::size_t(bin)]);
}

PiecewiseConstant2D::PiecewiseConstant2D(std::span<const float> weights, int width, int height) {
    if (width < 1 || height < 1 || weights.size() != std::size_t(width) * std::size_t(height))
        throw std::invalid_argument("a two-dimensional distribution needs width x height weights");
    std::vector<float> sums;
    for (int y = 0; y < height; ++y) {
        rows_.emplace_back(weights.subspan(std::size_t(y) * std::size_t(width), std::size_t(width)));
        sums.push_back(float(rows_.back().integral()));
    }
    marginal_ = PiecewiseConstant1D(sums);
}

PiecewiseConstant2D::Sample PiecewiseConstant2D::sample(const V2f& u) const {
    const auto v = marginal_.sample(u.y);
    const auto h = rows_[std::size_t(v.bin)].sample(u.x);
    return {V2f(h.x, v.x), h.pdf * v.pdf};
}

float PiecewiseConstant2D::pdf(const V2f& p) const {
    const int row = std::clamp(int(p.y * float(marginal_.size())), 0, marginal_.size() - 1);
    return marginal_.pdf(p.y) * rows_[std::size_t(row)].pdf(p.x);
}

AliasTable::AliasTable(std::span<const double> weights) {
    checkWeights(weights);
    const std::size_t n = weights.size();
    double total = 0;
    for (double w : weights)
        total += w;
    bins_.resize(n);
    std::vector<double> scaled(n);
    std::vector<int> small, large;
    for (std::size_t i = 0; i < n; ++i) {
        const double p = total > 0 ? weights[i] / total : 1 / double(n);
        bins_[i] = {1, float(p), int(i)};
        scaled[i] = p * double(n);
        (scaled[i] < 1 ? small : large).push_back(int(i));
    }
    while (!small.empty() && !large.empty()) {
        const auto s = std::size_t(small.back()), l = std::size_t(large.back());
        small.pop_back();
        bins_[s].threshold = float(scaled[s]);
        bins_[s].alias = int(l);
        scaled[l] -= 1 - scaled[s];
        if (scaled[l] < 1) {
            large.pop_back();
            small.push_back(int(l));
        }
    }
}

AliasTable::Sample AliasTable::sample(float u, float* remapped) const {
    const float scaled = u * float(bins_.size());
    const int bin = std::min(int(scaled), size() - 1);
    const float rest = std::min(scaled - float(bin), oneMinusEpsilon);
    const Bin& b = bins_[std::size_t(bin)];
    const bool own = rest < b.threshold;
    if (remapped)
        *remapped = std::min(own ? rest / b.threshold : (rest - b.threshold) / (1 - b.threshold), oneMinusEpsilon);
    const int index = own ? bin : b.alias;
    return {index, bins_[std::size_t(index)].probability};
}

} // namespace vitrine
