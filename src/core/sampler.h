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

struct SamplerSettings {
    SamplerKind kind = SamplerKind::Sobol;
    std::uint64_t seed = 0;
    /// Stratified only: strata in x and y, and whether to jitter within them.
    int xSamples = 4, ySamples = 4;
    bool jitter = true;
};

/// The numbers of one sample of one pixel, handed out in a fixed order of dimensions.
class SampleStream {
  public:
    SampleStream(const SamplerSettings& settings, const V2i& pixel, std::uint64_t sample);

    float get1D();
    V2f get2D();
    /// Continue at this dimension (one per get1D or get2D): lets walks skip numbers that they do not need.
    void setDimension(std::uint32_t dimension) { dimension_ = dimension; }

  private:
    const SamplerSettings* settings_;
    std::uint64_t key_;    ///< of (seed, pixel); for Independent also of the sample
    std::uint64_t sample_;
    std::uint32_t dimension_ = 0;
};

} // namespace vitrine
