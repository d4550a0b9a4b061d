// Material "coateddiffuse": a matt surface under a coat: varnished wood, glazed ware, plastic.
//
// | name           | type     | unit           | default   | meaning |
// |----------------|----------|----------------|-----------|---------|
// | reflectance    | spectrum | 1              | 0.5       | of the matt base; above 1 counts as 1 (as pbrt) |
// | eta            | spectrum | 1              | 1.5       | index of refraction of the coat; one that varies with wavelength disperses |
// | roughness      | float    | 1              | 0         | spread of the coat's facets in both directions; 0 is polished |
// | uroughness     | float    | 1              | roughness | along u |
// | vroughness     | float    | 1              | roughness | along v |
// | remaproughness | bool     |                | true      | the facets' slope alpha is sqrt(roughness); false: alpha is the roughness |
// | thickness      | float    | mean free path | 0.01      | of the coat: straight through it, exp(-thickness) of the light meets nothing |
// | albedo         | spectrum | 1              | 0         | share of what the coat's medium takes out that it scatters on; 0 only absorbs |
// | g              | float    | 1              | 0         | mean cosine of that scattering, in [-1, 1] |
// | maxdepth       | integer  |                | 10        | events between coat and base; light that needs more is left out |
// | nsamples       | integer  |                | 1         | random walks for each value of the BSDF: more are less noise, and slower |
#pragma once

#include "bsdfs/coat.h"

namespace vitrine {

class CoatedDiffuseMaterial final : public Material {
  public:
    /// \param reflectance null: 0.5
    /// \throws std::invalid_argument for values outside of their range.
    explicit CoatedDiffuseMaterial(SpectrumInput reflectance = nullptr, CoatParameters coat = {});

    Bsdf bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const override;
    bool filtersTextures() const override { return reflectance_.isFiltered() || coat_.isFiltered(); }

  private:
    SpectrumInput reflectance_;
    Coat coat_;
};

} // namespace vitrine
