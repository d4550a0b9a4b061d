// Sums that do not depend on the order of adding.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

namespace vitrine {

/// Sums in 96-bit fixed point of resolution 2^-44: adding is associative, so pictures are the same for any grouping of
/// samples into threads, passes or machines. The sun seen directly (1.6e9 nit) a million times fits beside light of
/// 1e-13. Sums saturate at +-2^51 and say so (Film::badSamples).
class FixedSum {
  public:
    static constexpr double scale = 0x1p44;

    /// Adds x, rounded to the nearest multiple of the resolution; returns false if the sum saturated (or x is not
    /// finite, then nothing is added).
    bool add(double x) {
        const double scaled = x * scale;
        if (!(std::abs(scaled) < 0x1p63)) [[unlikely]]
            return addLarge(x);
        const std::int64_t rounded = std::llrint(scaled);
        return addParts(std::uint64_t(rounded), rounded >> 63);
    }
    bool add(const FixedSum& other) { return addWide(other.wide()); }
    double value() const { return double(wide()) / scale; }
    bool operator==(const FixedSum& other) const = default;

  private:
    __extension__ using Wide = __int128;

    /// 2^19 or more, or not finite.
    [[gnu::noinline]] bool addLarge(double x) {
        if (!std::isfinite(x)) return false;
        if (std::abs(x) < 0x1p51) return addWide(Wide(x * scale));
        saturate(x < 0);
        return false;
    }
    bool addWide(Wide addend) { return addParts(std::uint64_t(addend), std::int64_t(addend >> 64)); }
    /// \param high beyond the lowest 64 bits, itself within 32
    bool addParts(std::uint64_t low, std::int64_t high) {
        std::uint64_t sum;
        std::memcpy(&sum, words_, sizeof sum);
        sum += low;
        high += std::int32_t(words_[2]) + std::int64_t(sum < low);
        set(sum, std::uint32_t(high));
        if (high == std::int32_t(high)) [[likely]]
            return true;
        saturate(high < 0);
        return false;
    }
    void saturate(bool low) {
        if (low)
            set(0, 0x80000000u);
        else
            set(~std::uint64_t(0), 0x7fffffffu);
    }

    Wide wide() const {
        std::uint64_t low;
        std::memcpy(&low, words_, sizeof low);
        return Wide(std::int32_t(words_[2])) * (Wide(1) << 64) + Wide(low);
    }
    void set(std::uint64_t low, std::uint32_t high) {
        std::memcpy(words_, &low, sizeof low);
        words_[2] = high;
    }

    std::uint32_t words_[3] = {0, 0, 0}; ///< two's complement, the lowest first
};

} // namespace vitrine
