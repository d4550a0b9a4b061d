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
    // The same in all four triangles of the square, but for the axis that the angle is counted from: chosen without a
    // branch, which would be mispredicted every second time.
    const bool aboutX = std::abs(x) > std::abs(y);
    const float radius = aboutX ? x : y, across = aboutX ? y : x;
    const float theta = pi / 4 * (radius != 0 ? across / radius : 0);
    const float c = radius * smallCos(theta), s = radius * smallSin(theta);
    return V2f(aboutX ? c : s, aboutX ? s : c);
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

namespace {

/// Values that a uniform number takes.
constexpr unsigned uniformBits = 24;
constexpr std::uint32_t uniformValues = 1u << uniformBits;

/// How many of the values of u each weight gets: their share, rounded so that all add up.
std::vector<std::uint32_t> apportion(std::span<const double> weights) {
    double total = 0;
    std::size_t positive = 0;
    for (const double w : weights) {
        total += w;
        positive += w > 0;
    }
    const bool isUniform = positive == 0;
    if (isUniform) positive = weights.size();
    // One apiece first, if that leaves something to share out.
    const std::uint32_t each = positive <= uniformValues / 2 ? 1 : 0;
    const double rest = uniformValues - double(each) * double(positive);
    std::vector<std::uint32_t> counts(weights.size(), 0);
    double sum = 0;
    std::uint32_t shared = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (!isUniform && weights[i] == 0) continue;
        sum += isUniform ? 1 / double(weights.size()) : weights[i] / total;
        // The last one gets what is left.
        const auto upTo = --positive == 0 ? std::uint32_t(rest) : std::uint32_t(std::min(sum, 1.) * rest);
        counts[i] = each + upTo - shared;
        shared = upTo;
    }
    return counts;
}

} // namespace

AliasTable::AliasTable(std::span<const double> weights) {
    checkWeights(weights);
    std::vector<std::uint32_t> counts = apportion(weights);
    probabilities_.reserve(counts.size());
    for (const std::uint32_t count : counts)
        probabilities_.push_back(float(count) / float(uniformValues));
    while (binBits_ < uniformBits && (std::size_t(1) << binBits_) < weights.size())
        ++binBits_;
    bins_.resize(std::size_t(1) << binBits_);
    fill(std::move(counts));
}

void AliasTable::fill(std::vector<std::uint32_t> counts) {
    const std::uint32_t capacity = uniformValues >> binBits_;
    if (capacity == 1) {
        // Each value of u is a bin, and entries may be more than bins.
        std::size_t bin = 0;
        for (std::size_t i = 0; i < counts.size(); ++i)
            for (; counts[i] > 0; --counts[i])
                bins_[bin++] = {0, std::uint32_t(i)};
        return;
    }
    counts.resize(bins_.size(), 0);
    std::vector<std::uint32_t> small, large;
    for (std::uint32_t i = 0; i < counts.size(); ++i)
        (counts[i] < capacity ? small : large).push_back(i);
    // All is in whole numbers: while a bin has room, an entry has more than fits into its own.
    while (!small.empty()) {
        const std::uint32_t s = small.back(), l = large.back();
        small.pop_back();
        bins_[s] = {counts[s], l};
        counts[l] -= capacity - counts[s];
        if (counts[l] < capacity) {
            large.pop_back();
            small.push_back(l);
        }
    }
    for (const std::uint32_t l : large)
        bins_[l] = {capacity, l};
}

AliasTable::Sample AliasTable::sample(float u, float* remapped) const {
    const auto value = std::min(std::uint32_t(u * float(uniformValues)), uniformValues - 1);
    const unsigned restBits = uniformBits - binBits_;
    const std::uint32_t bin = value >> restBits, capacity = 1u << restBits, rest = value & (capacity - 1);
    const Bin& b = bins_[bin];
    const bool own = rest < b.threshold;
    if (remapped) {
        const float at =
            (float(own ? rest : rest - b.threshold) + 0.5f) / float(own ? b.threshold : capacity - b.threshold);
        *remapped = std::min(at, oneMinusEpsilon);
    }
    const std::uint32_t index = own ? bin : b.alias;
    return {int(index), probabilities_[index]};
}

} // namespace vitrine
