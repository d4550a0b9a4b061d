// Material "mix": of two materials each is there at a share of the points, by a texture.
//
// | name      | type    | unit | default | meaning                                                                   |
// |-----------|---------|------|---------|---------------------------------------------------------------------------|
// | materials | strings |      |         | names of the two materials (MakeNamedMaterial); mixes may be mixed again   |
// | amount    | float   | 1    | 0.5     | share of the second: 0 shows the first alone, 1 the second                |
//
// Where the amount lies between, a path meets one of them by chance. Dielectrics in a mix bound one solid: if both are,
// they may differ in roughness alone (a frosted decor), and what is painted on glass lies on it. An "interface" cannot be
// mixed.
#pragma once

#include "bsdfs/material.h"

namespace vitrine {

class MixMaterial final : public Material {
  public:
    /// \param amount of the second; finite if constant  \param salt another for each mix: tells nested ones apart
    /// \throws std::invalid_argument when one is an interface, or they bound different solids.
    MixMaterial(MaterialPtr first, MaterialPtr second, FloatInput amount, std::uint64_t salt);

    /// Which of the materials is there; not a mix. The same for the same way of seeing the point.
    const Material& resolve(const MaterialPoint& point, const SampledWavelengths& lambda) const override;
    Bsdf bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const override {
        return resolve(point, lambda).bsdf(point, lambda);
    }
    bool hasDetail() const override { return first_->hasDetail() || second_->hasDetail(); }
    const Interior* interior() const override { return interior_; }
    bool isPolished() const override { return first_->isPolished() && second_->isPolished(); }
    bool filtersTextures() const override {
        return amount_.isFiltered() || first_->filtersTextures() || second_->filtersTextures();
    }

  private:
    MaterialPtr first_, second_;
    FloatInput amount_;
    std::uint64_t salt_;
    const Interior* interior_;
};

} // namespace vitrine
