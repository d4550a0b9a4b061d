// Material "coatedconductor": metal under a coat: lacquer on brass, car paint.
//
// | name                 | type     | unit           | default              | meaning |
// |----------------------|----------|----------------|----------------------|---------|
// | conductor.eta        | spectrum | 1              | metal-Cu-eta         | real part of the metal's index of refraction |
// | conductor.k          | spectrum | 1              | metal-Cu-k           | imaginary part: absorption |
// | reflectance          | spectrum | 1              | none                 | in place of both: the bare metal's reflectance in air at normal incidence, below 0.9999 |
// | conductor.roughness  | float    | 1              | 0                    | spread of the metal's facets in both directions; 0 is a mirror |
// | conductor.uroughness | float    | 1              | conductor.roughness  | along u |
// | conductor.vroughness | float    | 1              | conductor.roughness  | along v |
// | interface.eta        | spectrum | 1              | 1.5                  | index of refraction of the coat; one that varies with wavelength disperses |
// | interface.roughness  | float    | 1              | 0                    | spread of the coat's facets in both directions; 0 is polished |
// | interface.uroughness | float    | 1              | interface.roughness  | along u |
// | interface.vroughness | float    | 1              | interface.roughness  | along v |
// | remaproughness       | bool     |                | true                 | the facets' slope alpha is sqrt(roughness); false: alpha is the roughness |
// | thickness            | float    | mean free path | 0.01                 | of the coat: straight through it, exp(-thickness) of the light meets nothing |
// | albedo               | spectrum | 1              | 0                    | share of what the coat's medium takes out that it scatters on; 0 only absorbs |
// | g                    | float    | 1              | 0                    | mean cosine of that scattering, in [-1, 1] |
// | maxdepth             | integer  |                | 10                   | events between coat and metal; light that needs more is left out |
// | nsamples             | integer  |                | 1                    | random walks for each value of the BSDF: more are less noise, and slower |
#pragma once

#include "bsdfs/coat.h"
#include "bsdfs/metal_index.h"

namespace vitrine {

class CoatedConductorMaterial final : public Material {
  public:
    /// \throws std::invalid_argument for values outside of their range.
    explicit CoatedConductorMaterial(MetalIndex metal = MetalIndex(), FloatInput uroughness = 0,
                                     FloatInput vroughness = 0, CoatParameters coat = {});

    Bsdf bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const override;
    bool filtersTextures() const override { return metal_.isFiltered() || facets_.isFiltered() || coat_.isFiltered(); }
    bool isPolished() const override { return facets_.isPolished() && coat_.isPolished(); }

  private:
    MetalIndex metal_;
    Facets facets_;
    Coat coat_;
};

} // namespace vitrine
