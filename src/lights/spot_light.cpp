#include "lights/spot_light.h"

#include "lights/emission.h"
#include "lights/moving_light.h"

#include <stdexcept>

namespace vitrine {

namespace {

/// The light's own space, +z from `from` to `to`. The directions of x and y do not matter.
Transform aim(const V3d& from, const V3d& to) {
    const V3d axis = to - from;
    if (!(axis.length2() > 0)) throw std::invalid_argument("a spot light's \"from\" and \"to\" must differ");
    const V3d z = axis.normalized();
    const V3d x = (std::abs(z.x) < 0.5 ? V3d(1, 0, 0) : V3d(0, 1, 0)).cross(z).normalized();
    const V3d y = z.cross(x);
    return Transform(M44d(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, from.x, from.y, from.z, 1));
}

} // namespace

std::shared_ptr<SpotLight> SpotLight::create(const Transform& worldFromLight, const Parameters& parameters) {
    const Transform worldFromSpot = aim(parameters.from, parameters.to).then(worldFromLight);
    const double unit = SpotLight(worldFromSpot, nullptr, parameters.cone).solidAngle();
    SpectrumPtr intensity = scaledEmission(parameters.i, parameters.scale, parameters.power, unit);
    return std::make_shared<SpotLight>(worldFromSpot, std::move(intensity), parameters.cone);
}

LightPtr SpotLight::create(const Motion& worldFromLight, const Shutter& shutter, const Parameters& parameters) {
    const auto start = create(worldFromLight.start(), parameters);
    if (!worldFromLight.moves()) return start;
    return movingLight(worldFromLight, shutter, parameters.from,
                       [intensity = start->intensity_, cone = parameters.cone,
                        lightFromSpot = aim(parameters.from, parameters.to)](const Transform& pose) {
                           return SpotLight(lightFromSpot.then(pose), intensity, cone);
                       });
}

SpotLight::SpotLight(const Transform& worldFromSpot, SpectrumPtr intensity, const Cone& cone)
    : spotFromWorld_(worldFromSpot.inverse()), position_(worldFromSpot.point(V3d(0, 0, 0))),
      intensity_(std::move(intensity)), cosStart_(std::cos(radians(cone.angle - cone.delta))),
      cosEnd_(std::cos(radians(cone.angle))) {
    if (!(cone.angle > 0 && cone.angle <= 180))
        throw std::invalid_argument("a spot light's \"coneangle\" must be positive and at most 180 degrees");
    if (!(cone.delta >= 0 && cone.delta <= cone.angle))
        throw std::invalid_argument("a spot light's \"conedeltaangle\" must lie between 0 and its \"coneangle\"");
}

double SpotLight::falloff(double cosTheta) const {
    if (cosTheta >= cosStart_) return 1;
    if (cosTheta <= cosEnd_) return 0;
    const double t = (cosTheta - cosEnd_) / (cosStart_ - cosEnd_);
    return t * t * (3 - 2 * t);
}

double SpotLight::solidAngle() const {
    return 2 * piD * ((1 - cosStart_) + (cosStart_ - cosEnd_) / 2);
}

SampledSpectrum SpotLight::power(const SampledWavelengths& lambda) const {
    return intensity_->sample(lambda) * float(solidAngle());
}

LightBounds SpotLight::partBounds(unsigned) const {
    LightBounds bounds{Box3d(position_), {}, -1, false, 1 / solidAngle()};
    // A rim wider than a quarter turn, or a cone that its transform squeezes: all directions serve.
    const double reach = std::acos(cosEnd_) - std::acos(cosStart_);
    const Transform worldFromSpot = spotFromWorld_.inverse();
    const double mean = linearNorm(worldFromSpot.matrix()) / std::sqrt(3.);
    const bool keepsAngles = std::abs(linearDeterminant(worldFromSpot.matrix())) >= 0.999999 * mean * mean * mean;
    if (reach > piD / 2 || !keepsAngles) return bounds;
    bounds.normals = DirectionCone::about(worldFromSpot.vector(V3d(0, 0, 1)));
    bounds.normals.cosAngle = cosStart_;
    bounds.cosReach = std::cos(reach);
    return bounds;
}

std::optional<LightSample> SpotLight::sample(const LightReceiver& at, const V2f&,
                                             const SampledWavelengths& lambda) const {
    LightSample sample;
    sample.shadow = shadowTo(position_, at.p);
    const double distance2 = sample.shadow.d.length2();
    if (!(distance2 > 0)) return {};
    const double part = falloff(spotFromWorld_.vector(-sample.shadow.d).normalized().z);
    if (part == 0) return {};
    sample.wi = toFloat(sample.shadow.d / std::sqrt(distance2));
    sample.l = intensity_->sample(lambda) * float(part / distance2);
    if (sample.l.isBlack()) return {};
    sample.pdf = 1;
    sample.isDelta = true;
    return sample;
}

double SpotLight::sampleCosine(double u) const {
    const double inner = 1 - cosStart_, rim = (cosStart_ - cosEnd_) / 2;
    const double at = u * (inner + rim);
    if (at < inner || rim == 0) return 1 - at;
    // The smoothstep's integral from its dark side to t is the share t^3 (2 - t) of the whole. Newton's method, from a
    // start that errs by a few percent, is down to rounding after five steps.
    const double share = 1 - std::min((at - inner) / rim, 1.);
    double t = std::cbrt(share / 2) * (1 + 0.26 * share);
    for (int i = 0; i < 5; ++i) {
        const double slope = 2 * t * t * (3 - 2 * t);
        if (slope > 0) t -= (t * t * t * (2 - t) - share) / slope;
        t = std::clamp(t, 0., 1.);
    }
    return cosEnd_ + t * (cosStart_ - cosEnd_);
}

std::optional<LightEmission> SpotLight::emit(const V2f&, const V2f& uDirection, const SampledWavelengths& lambda,
                                             double) const {
    const SampledSpectrum intensity = intensity_->sample(lambda);
    if (intensity.isBlack()) return {};
    const double z = sampleCosine(uDirection.x), r = safeSqrt(1 - z * z), phi = 2 * piD * uDirection.y;
    const Transform worldFromSpot = spotFromWorld_.inverse();
    const V3d w = worldFromSpot.vector(V3d(r * std::cos(phi), r * std::sin(phi), z));
    const double length = w.length();
    // The falloff goes by angles in the spot's own space: a solid angle there is this many in the world.
    const double stretch = std::abs(linearDeterminant(worldFromSpot.matrix())) / (length * length * length);
    return LightEmission{Ray{position_, w / length, infinityD}, intensity * float(solidAngle() * stretch)};
}

} // namespace vitrine
