#include "lights/constant_infinite_light.h"

#include "core/sampling.h"
#include "lights/emission.h"

namespace vitrine {

std::shared_ptr<ConstantInfiniteLight> ConstantInfiniteLight::create(const Parameters& parameters) {
    return std::make_shared<ConstantInfiniteLight>(
        scaledEmission(parameters.l, parameters.scale, parameters.illuminance, piD));
}

SampledSpectrum ConstantInfiniteLight::powerInto(const SceneSphere& sphere, const SampledWavelengths& lambda) const {
    return l_->sample(lambda) * float(4 * piD * sphere.crossSection());
}

std::optional<LightSample> ConstantInfiniteLight::sample(const LightReceiver&, const V2f& u,
                                                         const SampledWavelengths& lambda) const {
    LightSample sample;
    sample.l = l_->sample(lambda);
    if (sample.l.isBlack()) return {};
    sample.wi = sampleUniformSphere(u);
    sample.pdf = invPi / 4;
    sample.shadow = Ray{V3d(0, 0, 0), toDouble(sample.wi), infinityD};
    return sample;
}

std::optional<LightEmission> ConstantInfiniteLight::emit(const V2f& uPosition, const V2f& uDirection,
                                                         const SampledWavelengths& lambda, double) const {
    const SampledSpectrum all = power(lambda);
    if (all.isBlack()) return {};
    return LightEmission{scene_.beam(sampleUniformSphere(uDirection), uPosition), all};
}

} // namespace vitrine
