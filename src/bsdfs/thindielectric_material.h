// Material "thindielectric": a thin sheet of glass, such as a window pane, modelled by one surface.
//
// | name | type     | unit | default | meaning                                                                        |
// |------|----------|------|---------|--------------------------------------------------------------------------------|
// | eta  | spectrum | 1    | 1.5     | index of refraction of the sheet                                               |
#pragma once

#include "bsdfs/material.h"

namespace vitrine {

class ThinDielectricMaterial final : public Material {
  public:
    /// \throws std::invalid_argument when the index is negative, 0 or not finite.
    explicit ThinDielectricMaterial(SpectrumPtr eta = nullptr);

    Bsdf bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const override;
    bool isPolished() const override { return true; }

  private:
    SpectrumPtr eta_;
};

} // namespace vitrine
