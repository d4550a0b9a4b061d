// Material "dielectric": glass, water and other solids that let light through.
//
// | name           | type     | unit         | default      | meaning |
// |----------------|----------|--------------|--------------|---------|
// | eta            | spectrum | 1            | 1.5          | index of refraction; one that varies with wavelength disperses |
// | absorption     | spectrum | 1/scene unit | 0            | light loses exp(-absorption x distance) inside (Beer-Lambert). Not in pbrt-v4 |
// | priority       | integer  |              | none         | where solids overlap the one of higher priority is there. Not in pbrt-v4 |
// | roughness      | float    | 1            | 0            | spread of the facets in both directions; 0 is polished |
// | uroughness     | float    | 1            | roughness    | along u |
// | vroughness     | float    | 1            | roughness    | along v |
// | remaproughness | bool     |              | true         | the facets' slope alpha is sqrt(roughness); false: alpha is the roughness |
//
// Without a priority the surface is pbrt-v4's: eta is relative to whatever lies around, which counts as air. With one the
// index is relative to the solid outside, and surfaces inside a solid of higher priority are not there.
#pragma once

#include "bsdfs/material.h"
#include "bsdfs/parameter_checks.h"

namespace vitrine {

class DielectricMaterial final : public Material {
  public:
    /// A null eta is 1.5.
    /// \throws std::invalid_argument for negative or non-finite values, or an index that is 0.
    explicit DielectricMaterial(Interior interior = {}, FloatInput uroughness = 0, FloatInput vroughness = 0,
                                bool remaproughness = true);

    /// Of the index relative to what lies outside; without a priority what lies outside counts as air (as pbrt-v4).
    Bsdf bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const override;
    const Interior* interior() const override { return &interior_; }
    bool filtersTextures() const override { return facets_.isFiltered(); }
    bool isPolished() const override { return facets_.isPolished(); }

  private:
    Interior interior_;
    Facets facets_;
};

} // namespace vitrine
