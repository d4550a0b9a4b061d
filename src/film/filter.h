// Pixel filters, importance sampled: a sample belongs to one pixel, so pixels stay independent of each other.
#pragma once

#include "core/vec.h"

#include <vector>

namespace vitrine {

enum class FilterKind { Box, Gaussian, Mitchell, Sinc, Triangle };

/// PixelFilter "box", "gaussian", "mitchell", "sinc", "triangle": how samples around a pixel make its value.
///
/// | name             | type  | unit   | default                            | meaning |
/// |------------------|-------|--------|------------------------------------|---------|
/// | xradius, yradius | float | pixels | 0.5, 1.5, 2, 4, 2 in the order above | half the filter's width and height |
/// | sigma            | float | pixels | 0.5                                | gaussian: standard deviation; the value at the radius is subtracted |
/// | B, C             | float |        | 1/3, 1/3                           | mitchell: Mitchell & Netravali's parameters |
/// | tau              | float |        | 3                                  | sinc: cycles of the inner sinc under the window's main lobe (Lanczos) |

/// A reconstruction filter on [-radius.x, radius.x] x [-radius.y, radius.y] (pixels), of integral 1. All kinds are
/// products of a function of x and one of y.
class Filter {
  public:
    struct Settings {
        FilterKind kind = FilterKind::Gaussian;
        V2f radius{1.5f, 1.5f};         ///< pixels
        float sigma = 0.5f;             ///< gaussian: standard deviation, pixels; its value at the radius is subtracted
        float b = 1 / 3.f, c = 1 / 3.f; ///< mitchell (Mitchell & Netravali 1988)
        float tau = 3;                  ///< sinc: cycles of the inner sinc under the window's main lobe (Lanczos)

        /// The kind with pbrt-v4's defaults: radius 0.5, 1.5, 2, 4, 2 in the order of FilterKind.
        static Settings defaults(FilterKind kind);
    };
    struct Sample {
        V2f p;        ///< offset from the pixel's centre
        float weight; ///< value over density; its sign is the filter's. 1 for filters that are never negative
    };
    /// \throws std::invalid_argument for radii, sigma or tau that are not positive and finite, radii above maxRadius,
    ///         or parameters that make the filter's integral vanish
    explicit Filter(const Settings& settings);

    static constexpr float maxRadius = 1000;

    /// Value at the offset p from the pixel's centre; 0 outside the radius.
    float operator()(const V2f& p) const;
    /// \param u uniform in the unit square; p grows with u in both coordinates
    Sample sample(const V2f& u) const;
    const Settings& settings() const { return settings_; }

  private:
    /// One factor of the product. Gaussian, mitchell and sinc are sampled by cells of about 1/16 pixel (as pbrt-v4 does)
    /// that carry the factor's exact means, so that what is drawn has the filter's own integral.
    struct Cell {
        double cdf;         ///< at its left border
        double left, scale; ///< offset = left + scale (u - cdf)
        float weight;       ///< sign x integral of |cells| / integral
    };
    struct Axis {
        double integral = 1; ///< of the factor before it is scaled to integral 1
        std::vector<Cell> cells;
        std::vector<int> guide; ///< per equal slice of u: the cell that its beginning falls in (Chen & Asau 1974)
    };
    struct Offset {
        float x, weight;
    };
    Axis makeAxis(double radius) const;
    double cellIntegral(double begin, double end, double radius) const;
    double factor(double x, double radius) const;
    Offset sampleAxis(const Axis& axis, float radius, float u) const;

    Settings settings_;
    Axis x_, y_;
};

} // namespace vitrine
