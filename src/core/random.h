// Counter-based random numbers: every number is a pure function of a key and a counter, never of a thread or a call
// order. The mixer is the 64-bit finaliser of SplitMix64 (Steele, Lea & Flood 2014), Stafford's variant 13.
#pragma once

#include <bit>
#include <cstdint>

namespace vitrine {

inline constexpr std::uint64_t goldenGamma = 0x9e3779b97f4a7c15ull;

constexpr std::uint64_t mixBits(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

/// A key from the numbers that name a stream, as in streamKey(seed, pass, pixel).
template <class... Ints>
constexpr std::uint64_t streamKey(Ints... parts) {
    std::uint64_t key = 0x243f6a8885a308d3ull;
    ((key = mixBits((key ^ std::uint64_t(parts)) + goldenGamma)), ...);
    return key;
}

/// The `counter`-th 64 random bits of the stream `key`.
constexpr std::uint64_t randomBits(std::uint64_t key, std::uint64_t counter) {
    return mixBits(key + (counter + 1) * goldenGamma);
}

/// The lowest bit first: what van der Corput and Sobol write behind the binary point.
constexpr std::uint32_t reverseBits(std::uint32_t x) {
    x = __builtin_bswap32(x);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

/// Uniform float in [0,1), a multiple of 2^-24.
constexpr float unitFloat(std::uint32_t bits) {
    return float(bits >> 8) * 0x1p-24f;
}

/// Uniform double in [0,1), a multiple of 2^-53.
constexpr double unitDouble(std::uint64_t bits) {
    return double(bits >> 11) * 0x1p-53;
}

/// A named stream of numbers, drawn in order; for tests, tools and set-up code.
class RandomStream {
  public:
    template <class... Ints>
    explicit constexpr RandomStream(Ints... parts) : key_(streamKey(parts...)) {}

    constexpr std::uint64_t bits() { return randomBits(key_, counter_++); }
    constexpr float uniform() { return unitFloat(std::uint32_t(bits() >> 32)); }
    constexpr double uniformDouble() { return unitDouble(bits()); }
    /// Uniform in [a, b).
    constexpr double uniform(double a, double b) { return a + (b - a) * uniformDouble(); }

  private:
    std::uint64_t key_;
    std::uint64_t counter_ = 0;
};

} // namespace vitrine
