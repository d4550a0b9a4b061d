// Sample streams of the integrators: numbers in [0,1) keyed by (seed, pixel, sample, dimension) and nothing else.
#pragma once

#include "core/random.h"
#include "core/vec.h"

#include <cstdint>
#include <string_view>

namespace vitrine {

enum class SamplerKind {
    Independent, ///< uncorrelated
    Stratified,  ///< jittered strata over the samples of a pixel, per dimension, shuffled
    Sobol        ///< padded Owen-scrambled (0,2)-sequences (Burley 2020, "Practical hash-based Owen scrambling")
};

/// Sampler "zsobol", "sobol", "paddedsobol", "pmj02bn", "halton": low-discrepancy samples. One here: padded Owen-scrambled
/// Sobol pairs.
///
/// | name          | type    | unit | default             | meaning |
/// |---------------|---------|------|---------------------|---------|
/// | pixelsamples  | integer |      | 16                  | samples a pixel (passes of photon integrators); any number |
/// | seed          | integer |      | that of Option "seed", else 0 | other seeds give other noise |
/// | randomization | string  |      | "fastowen"          | pbrt-v4's names are read; all but "none", which is refused, scramble in the same way |

/// Sampler "independent": uncorrelated random numbers.
///
/// | name         | type    | unit | default             | meaning |
/// |--------------|---------|------|---------------------|---------|
/// | pixelsamples | integer |      | 16                  | samples a pixel |
/// | seed         | integer |      | that of Option "seed", else 0 | other seeds give other noise |

/// Sampler "stratified": every dimension in strata of its own over a pixel's samples.
///
/// | name     | type    | unit | default             | meaning |
/// |----------|---------|------|---------------------|---------|
/// | xsamples | integer |      | 4                   | strata across; xsamples x ysamples are the samples a pixel |
/// | ysamples | integer |      | 4                   | strata down |
/// | jitter   | bool    |      | true                | samples lie anywhere in their stratum; false: in its middle |
/// | seed     | integer |      | that of Option "seed", else 0 | other seeds give other noise |

struct SamplerSettings {
    SamplerKind kind = SamplerKind::Sobol;
    std::uint64_t seed = 0;
    /// Stratified only: strata in x and y, and whether to jitter within them.
    int xSamples = 4, ySamples = 4;
    bool jitter = true;
};

/// \throws std::invalid_argument unless the strata are at least one and at most 2^24 in all.
void checkSamplerSettings(const SamplerSettings& settings);

/// The numbers of one sample of one pixel, handed out in a fixed order of dimensions. Multiples of 2^-24, made by
/// integer arithmetic alone, so the same on every machine.
class SampleStream {
  public:
    /// \param settings as checkSamplerSettings wants them
    SampleStream(const SamplerSettings& settings, const V2i& pixel, std::uint64_t sample);

    float get1D();
    V2f get2D();
    /// Continue at this dimension (one per get1D or get2D): lets walks skip numbers that they do not need.
    void setDimension(std::uint32_t dimension) { dimension_ = dimension; }
    std::uint32_t dimension() const { return dimension_; }

  private:
    // Apart from the others, which get by without saving registers.
    float stratified1D(std::uint64_t bits) const;
    V2f stratified2D(std::uint64_t bits) const;

    std::uint64_t key_;       ///< of (seed, pixel); for Independent also of the sample
    std::uint32_t index_ = 0; ///< Stratified: sample within the strata; Sobol: sample with its 32 bits reversed
    std::uint32_t dimension_ = 0;
    std::uint32_t xStrata_, yStrata_;
    SamplerKind kind_;
    bool jitter_;
};

} // namespace vitrine
