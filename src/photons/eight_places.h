// Places of photons, eight at a time: what a search reads, apart from what only those found are asked for.
#pragma once

#include "photons/photon_lookup.h"

#include <array>
#include <bit>
#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace vitrine {

struct EightPlaces {
    static constexpr std::uint32_t lanes = 8;
    using Floats [[gnu::vector_size(32)]] = float;
    using Mask [[gnu::vector_size(32)]] = std::int32_t;

    Floats x, y, z;

    void set(std::size_t lane, const V3f& p) {
        x[lane] = p.x;
        y[lane] = p.y;
        z[lane] = p.z;
    }

    /// Lanes in the disk. The same operations as distance2InDisk(), so that all searches agree to the last bit.
    Mask inDisk(const GatherDisk& disk, Floats& distance2) const {
        const V3f &c = disk.center, &n = disk.normal;
        const Floats dx = x - c.x, dy = y - c.y, dz = z - c.z;
        const Floats off = dx * n.x + dy * n.y + dz * n.z;
        const Floats d2 = dx * dx + dy * dy + dz * dz - off * off;
        const Floats height = off < 0 ? -off : off;
        distance2 = d2 > 0 ? d2 : Floats{};
        return (d2 < disk.radius2()) & (height <= GatherDisk::thickness * disk.radius);
    }

    static unsigned bitsOf(const Mask& mask) {
#ifdef __AVX2__
        return unsigned(_mm256_movemask_ps(__m256(mask)));
#else
        unsigned bits = 0;
        for (unsigned i = 0; i < lanes; ++i)
            bits |= unsigned(mask[i] != 0) << i;
        return bits;
#endif
    }

    /// Writes the photons of the lanes in `bits` one after the other, and anything behind them: there is room for eight.
    /// \param first index of lane 0
    static void write(unsigned bits, std::uint32_t first, const Floats& distance2, NearPhoton* out) {
#ifdef __AVX2__
        const __m256i from = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(std::int64_t(packing[bits])));
        const __m256i index = from + _mm256_set1_epi32(int(first));
        const __m256i d2 = _mm256_castps_si256(_mm256_permutevar8x32_ps(__m256(distance2), from));
        const __m256i low = _mm256_unpacklo_epi32(index, d2), high = _mm256_unpackhi_epi32(index, d2);
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_permute2x128_si256(low, high, 0x20));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(out + 4), _mm256_permute2x128_si256(low, high, 0x31));
#else
        for (; bits; bits &= bits - 1) {
            const auto lane = unsigned(std::countr_zero(bits));
            *out++ = {first + lane, distance2[lane]};
        }
#endif
    }

  private:
    /// For each set of lanes their numbers, a byte each, the lowest first.
    static constexpr std::array<std::uint64_t, 256> packing = [] {
        std::array<std::uint64_t, 256> numbers{};
        for (unsigned bits = 0; bits < 256; ++bits)
            for (unsigned lane = 0, to = 0; lane < lanes; ++lane)
                if (bits >> lane & 1) numbers[bits] |= std::uint64_t(lane) << (8 * to++);
        return numbers;
    }();
};

} // namespace vitrine
