// Material "conductor": metal.
//
// | name           | type     | unit         | default      | meaning |
// |----------------|----------|--------------|--------------|---------|
// | eta            | spectrum | 1            | metal-Cu-eta | real part of the index of refraction |
// | k              | spectrum | 1            | metal-Cu-k   | imaginary part: absorption |
// | reflectance    | spectrum | 1            | none         | in place of eta and k: reflectance at normal incidence, below 0.9999 |
// | roughness      | float    | 1            | 0            | spread of the facets in both directions; 0 is a mirror |
// | uroughness     | float    | 1            | roughness    | along u |
// | vroughness     | float    | 1            | roughness    | along v |
// | remaproughness | bool     |              | true         | the facets' slope alpha is sqrt(roughness); false: alpha is the roughness |
#pragma once

#include "bsdfs/material.h"
#include "bsdfs/parameter_checks.h"

namespace vitrine {

class ConductorMaterial final : public Material {
  public:
    /// Copper's for what is null. In a medium other than air both are taken relative to its index.
    /// \throws std::invalid_argument for negative or non-finite values.
    explicit ConductorMaterial(SpectrumInput eta = nullptr, SpectrumInput k = nullptr, FloatInput uroughness = 0,
                               FloatInput vroughness = 0, bool remaproughness = true);
    /// A metal that reflects this at normal incidence, whatever it lies in: eta = 1, k = 2 sqrt(r / (1 - r)) (pbrt-v4).
    static ConductorMaterial fromReflectance(SpectrumInput reflectance, FloatInput uroughness = 0,
                                             FloatInput vroughness = 0, bool remaproughness = true);

    Bsdf bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const override;
    bool filtersTextures() const override {
        return eta_.isFiltered() || k_.isFiltered() || reflectance_.isFiltered() || facets_.isFiltered();
    }

  private:
    struct ByReflectance {};
    ConductorMaterial(ByReflectance, SpectrumInput reflectance, Facets facets);

    SpectrumInput eta_, k_, reflectance_; ///< the first two, or the last
    Facets facets_;
};

} // namespace vitrine
