// Refractive indices of optical glasses by formula.
#pragma once

#include "spectrum/spectrum.h"

namespace vitrine {

/// n^2 = 1 + sum b_i l^2 / (l^2 - c_i), l the vacuum wavelength in micrometres (W. Sellmeier 1871; the form in which
/// makers of glass publish their melts). \throws nothing; the poles sqrt(c_i) must lie outside [360, 830] nm.
class SellmeierSpectrum final : public Spectrum {
  public:
    struct Term {
        float b, c; ///< c in square micrometres
    };
    SellmeierSpectrum(Term first, Term second, Term third) : terms_{first, second, third} {}
    float operator()(float lambda) const override;
    SampledSpectrum sample(const SampledWavelengths& lambda) const override;
    /// Dispersion is normal between the poles: the index falls with the wavelength.
    float maxValue() const override { return (*this)(lambdaMin); }

  private:
    template <class T>
    T squaredIndex(T lambda) const;

    Term terms_[3];
};

} // namespace vitrine
