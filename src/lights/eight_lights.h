// What the bounds of up to eight lights say about the light that comes to a point: all at once.
#pragma once

#include "lights/light_bounds.h"
#include "lights/light_receiver.h"

#include <span>

namespace vitrine {

class EightLights {
  public:
    static constexpr unsigned lanes = 8;

    EightLights() = default;
    /// \param bounds one to eight, of positive intensity
    explicit EightLights(std::span<const LightBounds> bounds);

    /// Roughly the irradiance from each, all in one unknown unit; 0 only where no light comes from there at all. The bound
    /// of Conty Estevez & Kulla 2018, eq. 3.
    void importances(const LightReceiver& receiver, float importance[lanes]) const;

  private:
    using Floats [[gnu::vector_size(32)]] = float;

    // The spheres round the boxes, about center_ in units of size_: wider by what floats may be off.
    Floats x_{}, y_{}, z_{}, radius_{};
    Floats intensity_{}; ///< of all together
    Floats axisX_{}, axisY_{}, axisZ_{};
    Floats cosNormals_{}, sinNormals_{}, cosReach_{};
    Floats twoSided_{}; ///< 1 or 0
    V3d center_{0, 0, 0};
    double size_ = 0; ///< of all together
};

} // namespace vitrine
