// What "coateddiffuse" and "coatedconductor" have in common: the coat and what lies under it.
#pragma once

#include "bsdfs/layered_bsdf.h"
#include "bsdfs/material.h"
#include "bsdfs/parameter_checks.h"

namespace vitrine {

/// The parameters as scenes give them.
struct CoatParameters {
    SpectrumPtr eta; ///< null: 1.5
    FloatInput uroughness = 0, vroughness = 0;
    bool remaproughness = true;
    FloatInput thickness = 0.01f;
    SpectrumInput albedo; ///< null: 0
    FloatInput g = 0;
    int maxdepth = 10, nsamples = 1;
};

class Coat {
  public:
    /// \param prefix of the names of the coat's own parameters in messages
    /// \throws std::invalid_argument for values outside of their range.
    explicit Coat(CoatParameters parameters, const std::string& prefix = "");

    /// The coat's index in vacuum. Ends the secondary wavelengths if it disperses.
    float index(SampledWavelengths& lambda) const { return relativeIndex(*eta_, 1, lambda); }
    /// \param index as index() returned it
    template <class Base>
    LayeredBsdf<Base> over(const Base& base, float index, const MaterialPoint& at,
                           const SampledWavelengths& lambda) const {
        return {DielectricBsdf(index / at.etaOutside, facets_(at)), base, medium(at, lambda),
                std::uint32_t(chanceKey(at, lambda))};
    }
    bool isFiltered() const {
        return facets_.isFiltered() || thickness_.isFiltered() || albedo_.isFiltered() || g_.isFiltered();
    }
    bool isPolished() const { return facets_.isPolished() && isEmpty_; }

  private:
    CoatMedium medium(const TexturePoint& at, const SampledWavelengths& lambda) const;

    SpectrumPtr eta_;
    Facets facets_;
    FloatInput thickness_;
    SpectrumInput albedo_;
    FloatInput g_;
    std::uint16_t maxDepth_, samples_;
    bool isEmpty_; ///< nothing scatters between coat and base
};

} // namespace vitrine
