// Material "diffuse": a matt surface.
//
// | name        | type     | unit | default | meaning                                                             |
// |-------------|----------|------|---------|---------------------------------------------------------------------|
// | reflectance | spectrum | 1    | 0.5     | share of the light that is reflected; above 1 counts as 1 (as pbrt) |
#pragma once

#include "bsdfs/material.h"

namespace vitrine {

class DiffuseMaterial final : public Material {
  public:
    /// \throws std::invalid_argument when the reflectance is negative or not finite.
    explicit DiffuseMaterial(SpectrumInput reflectance = nullptr);

    Bsdf bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const override;
    bool filtersTextures() const override { return reflectance_.isFiltered(); }

  private:
    SpectrumInput reflectance_;
};

} // namespace vitrine
