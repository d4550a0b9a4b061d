// Texture "constant": the same everywhere.
//
// | name  | type              | unit | default | meaning                                                 |
// |-------|-------------------|------|---------|---------------------------------------------------------|
// | value | float or spectrum | 1    | 1       | a float in a float texture, a spectrum in a spectrum one |
#pragma once

#include "textures/texture.h"

namespace vitrine {

class ConstantFloatTexture final : public FloatTexture {
  public:
    explicit ConstantFloatTexture(float value) : value_(value) {}
    float evaluate(const TexturePoint&) const override { return value_; }

  private:
    float value_;
};

class ConstantSpectrumTexture final : public SpectrumTexture {
  public:
    explicit ConstantSpectrumTexture(SpectrumPtr value) : value_(std::move(value)) {}
    SampledSpectrum evaluate(const TexturePoint&, const SampledWavelengths& lambda) const override {
        return value_->sample(lambda);
    }

  private:
    SpectrumPtr value_;
};

} // namespace vitrine
