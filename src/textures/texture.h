// Textures: numbers and spectra that vary over surfaces.
#pragma once

#include "core/vec.h"
#include "spectrum/spectrum.h"

#include <memory>

namespace vitrine {

/// Where a texture is looked up, and how large a patch of the surface is asked for: what a pixel sees spans about dpdx and
/// dpdy. They are zero where nothing is known of the pixel (photons, alpha), or where no filtering is wanted.
struct TexturePoint {
    V3d p{0, 0, 0};  ///< world
    V3f ng{0, 0, 1}; ///< unit geometric normal, world
    V2f uv{0, 0};    ///< the shape's
    V3f dpdx{0}, dpdy{0};
    V2f duvdx{0}, duvdy{0};
};

class FloatTexture {
  public:
    virtual ~FloatTexture() = default;
    virtual float evaluate(const TexturePoint& at) const = 0;
    /// Whether the footprint of the pixel makes a difference.
    virtual bool isFiltered() const { return false; }
};

/// What it stands for (a reflectance, an index, emission) was decided when it was made.
class SpectrumTexture {
  public:
    virtual ~SpectrumTexture() = default;
    virtual SampledSpectrum evaluate(const TexturePoint& at, const SampledWavelengths& lambda) const = 0;
    virtual bool isFiltered() const { return false; }
};

using FloatTexturePtr = std::shared_ptr<const FloatTexture>;
using SpectrumTexturePtr = std::shared_ptr<const SpectrumTexture>;

/// A number that a scene gives as one value or as a texture.
class FloatInput {
  public:
    FloatInput(float constant = 0) : constant_(constant) {}
    FloatInput(FloatTexturePtr texture) : texture_(std::move(texture)) {}

    bool isConstant() const { return !texture_; }
    float constant() const { return constant_; }
    const FloatTexturePtr& texture() const { return texture_; }
    bool isFiltered() const { return texture_ && texture_->isFiltered(); }
    float operator()(const TexturePoint& at) const { return texture_ ? texture_->evaluate(at) : constant_; }

  private:
    float constant_ = 0;
    FloatTexturePtr texture_;
};

/// A spectrum that a scene gives as one value or as a texture; or neither.
class SpectrumInput {
  public:
    SpectrumInput(std::nullptr_t = nullptr) {}
    template <class S>
    requires std::is_convertible_v<S, SpectrumPtr> SpectrumInput(S constant) : constant_(std::move(constant)) {}
    SpectrumInput(SpectrumTexturePtr texture) : texture_(std::move(texture)) {}

    explicit operator bool() const { return constant_ || texture_; }
    bool isConstant() const { return !texture_; }
    const SpectrumPtr& constant() const { return constant_; }
    const SpectrumTexturePtr& texture() const { return texture_; }
    bool isFiltered() const { return texture_ && texture_->isFiltered(); }
    /// \pre not empty
    SampledSpectrum operator()(const TexturePoint& at, const SampledWavelengths& lambda) const {
        return texture_ ? texture_->evaluate(at, lambda) : constant_->sample(lambda);
    }

  private:
    SpectrumPtr constant_;
    SpectrumTexturePtr texture_;
};

} // namespace vitrine
