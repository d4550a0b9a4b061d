#include "lights/point_light.h"

#include "core/sampling.h"
#include "lights/emission.h"
#include "lights/moving_light.h"

namespace vitrine {

std::shared_ptr<PointLight> PointLight::create(const Transform& worldFromLight, const Parameters& parameters) {
    SpectrumPtr intensity = scaledEmission(parameters.i, parameters.scale, parameters.power, 4 * piD);
    return std::make_shared<PointLight>(worldFromLight.point(parameters.from), std::move(intensity));
}

LightPtr PointLight::create(const Motion& worldFromLight, const Shutter& shutter, const Parameters& parameters) {
    const auto start = create(worldFromLight.start(), parameters);
    if (!worldFromLight.moves()) return start;
    return movingLight(worldFromLight, shutter, parameters.from,
                       [intensity = start->intensity_, from = parameters.from](const Transform& pose) {
                           return PointLight(pose.point(from), intensity);
                       });
}

SampledSpectrum PointLight::power(const SampledWavelengths& lambda) const {
    return intensity_->sample(lambda) * (4 * pi);
}

std::optional<LightSample> PointLight::sample(const LightReceiver& at, const V2f&,
                                              const SampledWavelengths& lambda) const {
    LightSample sample;
    sample.shadow = shadowTo(position_, at.p);
    const double distance2 = sample.shadow.d.length2();
    if (!(distance2 > 0)) return {};
    sample.wi = toFloat(sample.shadow.d / std::sqrt(distance2));
    sample.l = intensity_->sample(lambda) * float(1 / distance2);
    if (sample.l.isBlack()) return {};
    sample.pdf = 1;
    sample.isDelta = true;
    return sample;
}

std::optional<LightEmission> PointLight::emit(const V2f&, const V2f& uDirection, const SampledWavelengths& lambda,
                                              double) const {
    const SampledSpectrum all = power(lambda);
    if (all.isBlack()) return {};
    return LightEmission{Ray{position_, toDouble(sampleUniformSphere(uDirection)), infinityD}, all};
}

} // namespace vitrine
