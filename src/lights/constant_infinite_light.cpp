#include "lights/constant_infinite_light.h"

#include "core/sampling.h"
#include "lights/emission.h"

namespace vitrine {

std::shared_ptr<ConstantInfiniteLight> ConstantInfiniteLight::create(const Parameters& parameters) {
    return std::make_shared<ConstantInfiniteLight>(
        scaledEmission(parameters.l, parameters.scale, parameters.illuminance, piD));
}

SampledSpectrum ConstantInfiniteLight::power(const SampledWavelengths& lambda) const {
    return l_->sample(lambda) * float(4 * piD * piD * sqr(sceneRadius_));
}

std::optional<LightSample> ConstantInfiniteLight::sample(const V3d&, const V2f& u,
                                                         const SampledWavelengths& lambda) const {
    LightSample sample;
    sample.l = l_->sample(lambda);
    if (sample.l.isBlack()) return {};
    sample.wi = sampleUniformSphere(u);
    sample.pdf = invPi / 4;
    sample.shadow = Ray{V3d(0, 0, 0), toDouble(sample.wi), infinityD};
    return sample;
}

} // namespace vitrine
