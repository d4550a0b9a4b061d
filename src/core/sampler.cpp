#include "core/sampler.h"

#include <stdexcept>

namespace vitrine {

namespace {

constexpr std::uint32_t lowHalf(std::uint64_t bits) {
    return std::uint32_t(bits);
}

constexpr std::uint32_t highHalf(std::uint64_t bits) {
    return std::uint32_t(bits >> 32);
}

/// Owen scrambling of a number written lowest digit first: each bit is flipped by a hash of the bits below it (Laine &
/// Karras 2011 in the form of Burley 2020, section 3; the constants are N. Vegdahl's, "Building a better LK hash",
/// 2021).
constexpr std::uint32_t owenScrambleReversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    return x ^ (x * 0x53a22864u);
}

/// Dimension 1 of Sobol's sequence, lowest digit first. Its matrix is Pascal's triangle modulo 2, whose entry (k, j) is
/// 1 when the bits of k are a subset of j's; it factors into one exclusive-or per bit of the digit's number.
constexpr std::uint32_t pascalMatrix(std::uint32_t index) {
    index ^= (index >> 1) & 0x55555555u;
    index ^= (index >> 2) & 0x33333333u;
    index ^= (index >> 4) & 0x0f0f0f0fu;
    index ^= (index >> 8) & 0x00ff00ffu;
    return index ^ (index >> 16);
}

/// The index that the sample takes in the sequence of one dimension. A nested scramble maps aligned power-of-two blocks
/// to such blocks, so that every block of samples stays a net, but pairs different dimensions at random.
std::uint32_t shuffledIndex(std::uint32_t reversedSample, std::uint32_t seed) {
    return reverseBits(owenScrambleReversed(reversedSample, seed));
}

/// The place of i in a permutation of [0, n) chosen by `key` (Kensler 2013, "Correlated multi-jittered sampling",
/// section 3 and listing "permute"): a hash that is invertible modulo a power of two, repeated until it falls below n.
std::uint32_t permuted(std::uint32_t i, std::uint32_t n, std::uint32_t key) {
    const std::uint32_t mask = n <= 1 ? 0 : ~0u >> std::countl_zero(n - 1);
    const auto foldDown = [&](int shift) { i ^= (i & mask) >> shift; };
    do {
        i = (i ^ key) * 0xe170893du;
        i ^= key >> 16;
        foldDown(4);
        i = (i ^ (key >> 8)) * 0x0929eb3fu;
        i ^= key >> 23;
        foldDown(1);
        i *= (key >> 27) | 1u;
        i *= 0x6935fa69u;
        foldDown(11);
        i *= 0x74dcb303u;
        foldDown(2);
        i *= 0x9e501cc3u;
        foldDown(2);
        i = (i * 0xc860a3dfu) & mask;
        i ^= i >> 5;
    } while (i >= n);
    return std::uint32_t((std::uint64_t(i) + key) % n);
}

/// A multiple of 2^-24 in stratum `index` of `count` of the unit interval, by integers alone.
/// \param bits 32 uniform bits, the place within the stratum
float inStratum(std::uint32_t index, std::uint32_t count, std::uint32_t bits) {
    const auto firstMultiple = [&](std::uint64_t i) { return ((i << 24) + count - 1) / count; };
    const std::uint64_t first = firstMultiple(index), width = firstMultiple(index + 1ull) - first;
    const std::uint64_t multiple = first + ((width * bits) >> 32);
    return float(std::min<std::uint64_t>(multiple, (1u << 24) - 1)) * 0x1p-24f;
}

constexpr std::uint32_t middle = 1u << 31;

} // namespace

void checkSamplerSettings(const SamplerSettings& settings) {
    constexpr std::int64_t maxStrata = 1 << 24; // floats are multiples of 2^-24
    if (settings.xSamples < 1 || settings.ySamples < 1)
        throw std::invalid_argument("a stratified sampler needs at least one stratum in x and in y");
    if (std::int64_t(settings.xSamples) * settings.ySamples > maxStrata)
        throw std::invalid_argument("a stratified sampler takes at most 2^24 strata");
}

SampleStream::SampleStream(const SamplerSettings& settings, const V2i& pixel, std::uint64_t sample)
    : key_(streamKey(settings.seed, pixel.x, pixel.y)), xStrata_(std::uint32_t(settings.xSamples)),
      yStrata_(std::uint32_t(settings.ySamples)), kind_(settings.kind), jitter_(settings.jitter) {
    switch (kind_) {
    case SamplerKind::Independent:
        key_ = streamKey(key_, sample);
        break;
    case SamplerKind::Stratified: {
        // Samples beyond the count start a fresh set of strata.
        const std::uint64_t count = std::uint64_t(xStrata_) * yStrata_;
        key_ = streamKey(key_, sample / count);
        index_ = std::uint32_t(sample % count);
        break;
    }
    case SamplerKind::Sobol:
        // The sequence has 2^32 points; whoever needs more gets another one.
        if (sample >> 32) key_ = streamKey(key_, sample >> 32);
        index_ = reverseBits(std::uint32_t(sample));
        break;
    }
}

float SampleStream::stratified1D(std::uint64_t bits) const {
    const std::uint32_t count = xStrata_ * yStrata_;
    const std::uint32_t stratum = permuted(index_, count, lowHalf(bits));
    return inStratum(stratum, count, jitter_ ? highHalf(randomBits(bits, index_)) : middle);
}

V2f SampleStream::stratified2D(std::uint64_t bits) const {
    const std::uint32_t stratum = permuted(index_, xStrata_ * yStrata_, lowHalf(bits));
    const std::uint64_t jitter = randomBits(bits, index_);
    return V2f(inStratum(stratum % xStrata_, xStrata_, jitter_ ? lowHalf(jitter) : middle),
               inStratum(stratum / xStrata_, yStrata_, jitter_ ? highHalf(jitter) : middle));
}

float SampleStream::get1D() {
    const std::uint64_t bits = randomBits(key_, dimension_++);
    switch (kind_) {
    case SamplerKind::Stratified:
        return stratified1D(bits);
    case SamplerKind::Sobol:
        return unitFloat(reverseBits(owenScrambleReversed(shuffledIndex(index_, lowHalf(bits)), highHalf(bits))));
    case SamplerKind::Independent:
        break;
    }
    return unitFloat(highHalf(bits));
}

V2f SampleStream::get2D() {
    const std::uint64_t bits = randomBits(key_, dimension_++);
    switch (kind_) {
    case SamplerKind::Stratified:
        return stratified2D(bits);
    case SamplerKind::Sobol: {
        const std::uint32_t index = shuffledIndex(index_, lowHalf(bits));
        const std::uint32_t ySeed = highHalf(mixBits(bits + goldenGamma));
        return V2f(unitFloat(reverseBits(owenScrambleReversed(index, highHalf(bits)))),
                   unitFloat(reverseBits(owenScrambleReversed(pascalMatrix(index), ySeed))));
    }
    case SamplerKind::Independent:
        break;
    }
    return V2f(unitFloat(highHalf(bits)), unitFloat(lowHalf(bits)));
}

} // namespace vitrine
