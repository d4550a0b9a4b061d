// The complex index of refraction of a metal, as scenes give it.
#pragma once

#include "bsdfs/parameter_checks.h"

#include <string>

namespace vitrine {

/// "eta" and "k", or the "reflectance" that they shall come to.
class MetalIndex {
  public:
    struct Value {
        SampledSpectrum eta, k;
    };

    /// Copper's for what is null. \param prefix of the parameters' names in messages
    /// \throws std::invalid_argument for values that are negative, not finite or absurdly large.
    explicit MetalIndex(SpectrumInput eta = nullptr, SpectrumInput k = nullptr, const std::string& prefix = "");
    /// That of a metal which reflects this at normal incidence in air: eta = 1, k = 2 sqrt(r / (1 - r)) (pbrt-v4).
    /// \throws std::invalid_argument when it is null, negative or not finite.
    static MetalIndex ofReflectance(SpectrumInput reflectance);

    bool isByReflectance() const { return bool(reflectance_); }
    Value operator()(const TexturePoint& at, const SampledWavelengths& lambda) const;
    bool isFiltered() const { return eta_.isFiltered() || k_.isFiltered() || reflectance_.isFiltered(); }

  private:
    struct ByReflectance {};
    MetalIndex(ByReflectance, SpectrumInput reflectance) : reflectance_(std::move(reflectance)) {}

    SpectrumInput eta_, k_, reflectance_; ///< the first two, or the last
};

} // namespace vitrine
