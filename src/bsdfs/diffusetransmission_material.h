// Material "diffusetransmission": a thin sheet that is matt on both sides and lets light through: paper, leaves.
//
// | name          | type     | unit | default | meaning                                                  |
// |---------------|----------|------|---------|----------------------------------------------------------|
// | reflectance   | spectrum | 1    | 0.25    | share of the light that is reflected                     |
// | transmittance | spectrum | 1    | 0.25    | share that is let through                                |
// | scale         | float    | 1    | 1       | factor of both; what is then above 1 counts as 1 (as pbrt) |
//
// Both shares together may exceed 1 (as in pbrt-v4): the sheet then makes light.
#pragma once

#include "bsdfs/material.h"

namespace vitrine {

class DiffuseTransmissionMaterial final : public Material {
  public:
    /// 0.25 for what is null. \throws std::invalid_argument for negative or non-finite values.
    explicit DiffuseTransmissionMaterial(SpectrumInput reflectance = nullptr, SpectrumInput transmittance = nullptr,
                                         float scale = 1);

    Bsdf bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const override;
    bool filtersTextures() const override { return reflectance_.isFiltered() || transmittance_.isFiltered(); }

  private:
    SpectrumInput reflectance_, transmittance_;
    float scale_;
};

} // namespace vitrine
