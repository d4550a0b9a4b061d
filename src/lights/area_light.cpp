#include "core/frame.h"
#include "core/sampling.h"
#include "lights/emission.h"
#include "lights/light.h"

namespace vitrine {

std::shared_ptr<AreaLight> AreaLight::create(ShapePtr shape, const Parameters& parameters) {
    const double unit = piD * shape->area() * (parameters.twoSided ? 2 : 1);
    SpectrumPtr l = scaledEmission(parameters.l, parameters.scale, parameters.power, unit);
    return std::make_shared<AreaLight>(std::move(shape), std::move(l), parameters.twoSided);
}

SampledSpectrum AreaLight::power(const SampledWavelengths& lambda) const {
    return l_->sample(lambda) * float(piD * shape_->area() * (twoSided_ ? 2 : 1));
}

LightBounds AreaLight::partBounds(unsigned part) const {
    const ShapePart shape = shape_->part(part);
    const double share = shape.area / shape_->area();
    return {shape.bounds, shape.normals, 0, twoSided_, share / (piD * (twoSided_ ? 2 : 1))};
}

std::optional<LightSample> AreaLight::sample(const LightReceiver& at, const V2f& u,
                                             const SampledWavelengths& lambda) const {
    return lightFrom(shape_->sample(at.p, u), at, lambda);
}

std::optional<LightSample> AreaLight::samplePart(unsigned part, const LightReceiver& at, const V2f& u,
                                                 const SampledWavelengths& lambda) const {
    return lightFrom(shape_->samplePart(part, at.p, u), at, lambda);
}

std::optional<LightSample> AreaLight::lightFrom(const std::optional<ShapeSample>& onShape, const LightReceiver& at,
                                                const SampledWavelengths& lambda) const {
    if (!onShape || !(onShape->pdf > 0)) return {};
    const V3d toLight = onShape->point.p - at.p;
    const double distance = toLight.length();
    if (!(distance > 0)) return {};
    const V3f wi = toFloat(toLight * (1 / distance));
    const SampledSpectrum l = emitted(onShape->point, -wi, lambda);
    if (l.isBlack()) return {};
    std::optional<LightSample> sample(std::in_place);
    sample->wi = wi;
    sample->l = l;
    sample->pdf = onShape->pdf;
    // The error of a point of a mesh is what Embree's single precision does to rays that start there. Where they end, no
    // more counts than the double that meshes are solved in.
    const bool isMesh = shape_->kind() == GeometryKind::Triangles || shape_->kind() == GeometryKind::Quads;
    sample->shadow = shadowTo(isMesh ? onShape->point.p : offsetOrigin(onShape->point, -wi), at.p);
    return sample;
}

std::optional<LightEmission> AreaLight::emit(const V2f& uPosition, const V2f& uDirection,
                                             const SampledWavelengths& lambda) const {
    const auto onShape = shape_->sample(uPosition);
    if (!onShape || !(onShape->pdf > 0)) return {};
    // Two sides: half of the first number picks one, what is left of it is as good as new.
    const bool back = twoSided_ && uDirection.x >= 0.5f;
    const V2f u(twoSided_ ? 2 * uDirection.x - (back ? 1 : 0) : uDirection.x, uDirection.y);
    const V3f local = sampleCosineHemisphere(u);
    if (!(local.z > 0)) return {};
    const SurfacePoint& point = onShape->point;
    const V3f w = Frame(back ? -point.ng : point.ng).toWorld(local);
    const SampledSpectrum l = l_->sample(lambda);
    if (l.isBlack()) return {};
    return LightEmission{Ray{offsetOrigin(point, w), toDouble(w), infinityD},
                         l * (pi * (twoSided_ ? 2 : 1) / onShape->pdf)};
}

} // namespace vitrine
