// Lights of no size, or at infinity, that move.
#pragma once

#include "core/motion.h"
#include "lights/light.h"
#include "lights/scene_sphere.h"

namespace vitrine {

/// Makes a light anew where it is at each time. It is chosen as where it starts.
/// \tparam Make Kind(const Transform& worldFromLight), cheap
template <class Make>
class MovingLight final : public Light {
  public:
    MovingLight(const Motion& worldFromLight, const Shutter& shutter, const V3d& position, const Make& make)
        : motion_(worldFromLight), make_(make), start_(make(worldFromLight.start())),
          bounds_(start_.bounds().isEmpty() ? Box3d() : worldFromLight.sweep(Box3d(position), shutter)) {}

    SampledSpectrum power(const SampledWavelengths& lambda) const override { return start_.power(lambda); }
    SampledSpectrum powerInto(const SceneSphere& sphere, const SampledWavelengths& lambda) const override {
        return start_.powerInto(sphere, lambda);
    }
    Box3d bounds() const override { return bounds_; }
    /// To all sides: it may turn.
    LightBounds partBounds(unsigned part) const override {
        return {bounds_, {}, -1, false, start_.partBounds(part).intensity};
    }
    std::optional<LightSample> sample(const LightReceiver& at, const V2f& u,
                                      const SampledWavelengths& lambda) const override {
        return make_(motion_.at(at.time)).sample(at, u, lambda);
    }
    std::optional<LightEmission> emit(const V2f& uPosition, const V2f& uDirection, const SampledWavelengths& lambda,
                                      double time) const override {
        auto light = make_(motion_.at(time));
        light.preprocess(scene_.center, scene_.radius);
        return light.emit(uPosition, uDirection, lambda, time);
    }
    bool isDelta() const override { return start_.isDelta(); }
    void preprocess(const V3d& center, double radius) override {
        scene_ = {center, radius};
        start_.preprocess(center, radius);
    }

  private:
    Motion motion_;
    Make make_;
    decltype(std::declval<Make>()(Transform())) start_;
    Box3d bounds_;
    SceneSphere scene_;
};

template <class Make>
LightPtr movingLight(const Motion& worldFromLight, const Shutter& shutter, const V3d& position, const Make& make) {
    return std::make_shared<MovingLight<Make>>(worldFromLight, shutter, position, make);
}

} // namespace vitrine
