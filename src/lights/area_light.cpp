#include "core/frame.h"
#include "core/sampling.h"
#include "lights/emission.h"
#include "lights/light.h"

namespace vitrine {

std::shared_ptr<AreaLight> AreaLight::create(ShapePtr shape, const Parameters& parameters) {
    const double unit = piD * shape->area() * (parameters.twoSided ? 2 : 1);
    SpectrumPtr l = scaledEmission(parameters.l, parameters.scale, parameters.power, unit);
    return std::make_shared<AreaLight>(std::move(shape), std::move(l), parameters.twoSided, parameters.cutout,
                                       parameters.isUnseen);
}

namespace {

/// How much of a shape is there. Not 0, for what a few points miss may still be there and has to be chosen as a light now
/// and then.
float estimateOpacity(const Shape& shape, const Cutout& cutout) {
    constexpr int points = 256;
    // Roberts' R2 sequence: the plastic number's inverse powers.
    constexpr double stepX = 0.7548776662466927, stepY = 0.5698402909980532;
    double there = 0, all = 0;
    for (int i = 1; i <= points; ++i) {
        const double x = i * stepX, y = i * stepY;
        const auto sample = shape.sample(V2f(float(x - std::floor(x)), float(y - std::floor(y))));
        if (!sample || !(sample->pdf > 0)) continue;
        there += std::clamp(cutout.opacity(sample->point), 0.f, 1.f) / sample->pdf;
        all += 1 / sample->pdf;
    }
    return all > 0 ? std::max(float(there / all), 1.f / points) : 1;
}

} // namespace

AreaLight::AreaLight(ShapePtr shape, SpectrumPtr l, bool twoSided, CutoutPtr cutout, bool isUnseen)
    : shape_(std::move(shape)), moving_(dynamic_cast<const MovingShape*>(shape_.get())), l_(std::move(l)),
      twoSided_(twoSided), cutout_(std::move(cutout)), isUnseen_(isUnseen) {
    if (cutout_) meanOpacity_ = estimateOpacity(*shape_, *cutout_);
}

SampledSpectrum AreaLight::power(const SampledWavelengths& lambda) const {
    return l_->sample(lambda) * (float(piD * shape_->area() * (twoSided_ ? 2 : 1)) * meanOpacity_);
}

LightBounds AreaLight::partBounds(unsigned part) const {
    const ShapePart shape = shape_->part(part);
    const double share = shape.area / shape_->area();
    return {shape.bounds, shape.normals, 0, twoSided_, share / (piD * (twoSided_ ? 2 : 1))};
}

std::optional<LightSample> AreaLight::sample(const LightReceiver& at, const V2f& u,
                                             const SampledWavelengths& lambda) const {
    return lightFrom(moving_ ? moving_->sampleAt(at.time, at.p, u) : shape_->sample(at.p, u), at, lambda);
}

std::optional<LightSample> AreaLight::samplePart(unsigned part, const LightReceiver& at, const V2f& u,
                                                 const SampledWavelengths& lambda) const {
    return lightFrom(moving_ ? moving_->sampleAt(at.time, at.p, u) : shape_->samplePart(part, at.p, u), at, lambda);
}

std::optional<LightSample> AreaLight::lightFrom(const std::optional<ShapeSample>& onShape, const LightReceiver& at,
                                                const SampledWavelengths& lambda) const {
    if (!onShape || !(onShape->pdf > 0)) return {};
    const V3d toLight = onShape->point.p - at.p;
    const double distance = toLight.length();
    if (!(distance > 0)) return {};
    const V3f wi = toFloat(toLight * (1 / distance));
    SampledSpectrum l = emitted(onShape->point, -wi, lambda);
    if (cutout_) l *= opacity(onShape->point);
    if (l.isBlack()) return {};
    std::optional<LightSample> sample(std::in_place);
    sample->wi = wi;
    sample->l = l;
    sample->pdf = onShape->pdf;
    sample->isDelta = isUnseen_;
    // The error of a point of a mesh is what Embree's single precision does to rays that start there. Where they end, no
    // more counts than the double that meshes are solved in.
    const bool isMesh = shape_->kind() == GeometryKind::Triangles || shape_->kind() == GeometryKind::Quads;
    sample->shadow = shadowTo(isMesh ? onShape->point.p : offsetOrigin(onShape->point, -wi), at.p);
    return sample;
}

std::optional<LightEmission> AreaLight::emit(const V2f& uPosition, const V2f& uDirection,
                                             const SampledWavelengths& lambda, double time) const {
    const auto onShape = moving_ ? moving_->sampleAt(time, uPosition) : shape_->sample(uPosition);
    if (!onShape || !(onShape->pdf > 0)) return {};
    // Two sides: half of the first number picks one, what is left of it is as good as new.
    const bool back = twoSided_ && uDirection.x >= 0.5f;
    const V2f u(twoSided_ ? 2 * uDirection.x - (back ? 1 : 0) : uDirection.x, uDirection.y);
    const V3f local = sampleCosineHemisphere(u);
    if (!(local.z > 0)) return {};
    const SurfacePoint& point = onShape->point;
    const V3f w = Frame(back ? -point.ng : point.ng).toWorld(local);
    SampledSpectrum l = l_->sample(lambda);
    if (cutout_) l *= opacity(onShape->point);
    if (l.isBlack()) return {};
    return LightEmission{Ray{offsetOrigin(point, w), toDouble(w), infinityD},
                         l * (pi * (twoSided_ ? 2 : 1) / onShape->pdf)};
}

} // namespace vitrine
