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
#include "bsdfs/metal_index.h"

namespace vitrine {

class ConductorMaterial final : public Material {
  public:
    /// A metal in a medium other than air has contrast to that; of one that is given by its reflectance, whatever it
    /// lies in, that is it.
    /// \throws std::invalid_argument for negative or non-finite values.
    explicit ConductorMaterial(MetalIndex index = MetalIndex(), FloatInput uroughness = 0, FloatInput vroughness = 0,
                               bool remaproughness = true);
    explicit ConductorMaterial(SpectrumInput eta, SpectrumInput k, FloatInput uroughness = 0, FloatInput vroughness = 0,
                               bool remaproughness = true)
        : ConductorMaterial(MetalIndex(std::move(eta), std::move(k)), std::move(uroughness), std::move(vroughness),
                            remaproughness) {}
    static ConductorMaterial fromReflectance(SpectrumInput reflectance, FloatInput uroughness = 0,
                                             FloatInput vroughness = 0, bool remaproughness = true) {
        return ConductorMaterial(MetalIndex::ofReflectance(std::move(reflectance)), std::move(uroughness),
                                 std::move(vroughness), remaproughness);
    }

    Bsdf bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const override;
    bool filtersTextures() const override { return index_.isFiltered() || facets_.isFiltered(); }
    bool isPolished() const override { return facets_.isPolished(); }

  private:
    MetalIndex index_;
    Facets facets_;
};

} // namespace vitrine
