#include "lights/distant_light.h"

#include "lights/emission.h"
#include "lights/moving_light.h"

#include <stdexcept>

namespace vitrine {

std::shared_ptr<DistantLight> DistantLight::create(const Transform& worldFromLight, const Parameters& parameters) {
    const V3d back = parameters.from - parameters.to;
    if (!(back.length2() > 0)) throw std::invalid_argument("a distant light's \"from\" and \"to\" must differ");
    SpectrumPtr irradiance = scaledEmission(parameters.l, parameters.scale, parameters.illuminance, 1);
    return std::make_shared<DistantLight>(worldFromLight.vector(back), std::move(irradiance));
}

LightPtr DistantLight::create(const Motion& worldFromLight, const Shutter& shutter, const Parameters& parameters) {
    const auto start = create(worldFromLight.start(), parameters);
    if (!worldFromLight.moves()) return start;
    return movingLight(worldFromLight, shutter, parameters.from,
                       [irradiance = start->irradiance_, back = parameters.from - parameters.to](
                           const Transform& pose) { return DistantLight(pose.vector(back), irradiance); });
}

SampledSpectrum DistantLight::powerInto(const SceneSphere& sphere, const SampledWavelengths& lambda) const {
    return irradiance_->sample(lambda) * float(sphere.crossSection());
}

std::optional<LightSample> DistantLight::sample(const LightReceiver&, const V2f&,
                                                const SampledWavelengths& lambda) const {
    LightSample sample;
    sample.l = irradiance_->sample(lambda);
    if (sample.l.isBlack()) return {};
    sample.wi = toFloat(wi_);
    sample.shadow = Ray{V3d(0, 0, 0), wi_, infinityD};
    sample.pdf = 1;
    sample.isDelta = true;
    return sample;
}

std::optional<LightEmission> DistantLight::emit(const V2f& uPosition, const V2f&, const SampledWavelengths& lambda,
                                                double) const {
    const SampledSpectrum all = power(lambda);
    if (all.isBlack()) return {};
    return LightEmission{scene_.beam(toFloat(-wi_), uPosition), all};
}

} // namespace vitrine
