// Pixel filters, importance sampled: a sample belongs to one pixel, so pixels stay independent of each other.
#pragma once

#include "core/sampling.h"

#include <functional>

namespace vitrine {

enum class FilterKind { Box, Gaussian, Mitchell, Sinc, Triangle };

/// A reconstruction filter on [-radius.x, radius.x] x [-radius.y, radius.y] (pixels).
class Filter {
  public:
    struct Settings {
        FilterKind kind = FilterKind::Gaussian;
        V2f radius{1.5f, 1.5f};
        float sigma = 0.5f;           ///< gaussian
        float b = 1 / 3.f, c = 1 / 3.f; ///< mitchell
        float tau = 3;                ///< sinc
    };
    struct Sample {
        V2f p;        ///< offset from the pixel's centre
        float weight; ///< value over density; its sign is the filter's
    };
    /// \throws std::invalid_argument for radii or parameters that are not positive and finite
    explicit Filter(const Settings& settings);

    float operator()(const V2f& p) const;
    /// Integral over the support.
    float integral() const { return integral_; }
    Sample sample(const V2f& u) const;
    const Settings& settings() const { return settings_; }

  private:
    float value1D(float x, float radius) const;

    Settings settings_;
    float integral_ = 1;
    PiecewiseConstant2D table_; ///< of |value|, for the filters without a closed inverse
    std::vector<float> values_; ///< tabulated values, so that weights are exactly value over density
    int tableWidth_ = 0, tableHeight_ = 0;
};

} // namespace vitrine
