// Material "interface": no surface at all, only the boundary of a medium. It has no parameters.
#pragma once

#include "bsdfs/material.h"

namespace vitrine {

class InterfaceMaterial final : public Material {
  public:
    /// Passes everything straight on, for those who do not ask isInterface() first.
    Bsdf bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const override;
    bool isInterface() const override { return true; }
    bool isPolished() const override { return true; }
};

} // namespace vitrine
