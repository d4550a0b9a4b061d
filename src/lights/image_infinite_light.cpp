#include "lights/image_infinite_light.h"

#include "lights/emission.h"

#include <stdexcept>

namespace vitrine {

namespace {

/// Anything but rotation, mirroring and uniform scale would squeeze solid angles.
void checkAngles(const V3d& x, const V3d& y, const V3d& z) {
    constexpr double tolerance = 1e-4;
    const double length2 = x.length2();
    const auto differs = [&](const V3d& v) { return !(std::abs(v.length2() - length2) <= tolerance * length2); };
    const auto leans = [&](const V3d& a, const V3d& b) { return !(std::abs(a.dot(b)) <= tolerance * length2); };
    if (differs(y) || differs(z) || leans(x, y) || leans(y, z) || leans(z, x))
        throw std::invalid_argument("an infinite light with an image may be turned and mirrored, but not sheared or "
                                    "scaled unevenly");
}

PiecewiseConstant2D densityOverSquare(const EnvironmentImage& image) {
    const EnvironmentGrid& grid = image.grid();
    std::vector<float> weights = image.texelMeans();
    for (std::size_t i = 0; i < weights.size(); ++i)
        weights[i] *= float(grid.solidAngle(int(i / std::size_t(grid.width()))) * double(weights.size()) / (4 * piD));
    return PiecewiseConstant2D(weights, grid.width(), grid.height());
}

} // namespace

std::shared_ptr<ImageInfiniteLight> ImageInfiniteLight::create(const Transform& worldFromLight, const Image& image,
                                                               const Parameters& parameters) {
    const RgbColorSpace& space = parameters.colorSpace ? *parameters.colorSpace : RgbColorSpace::srgb();
    const EnvironmentLookup byMapping =
        parameters.mapping == EnvironmentMapping::EqualArea ? EnvironmentLookup::Nearest : EnvironmentLookup::Bilinear;
    EnvironmentImage environment(image, space, parameters.mapping, parameters.lookup.value_or(byMapping));
    const double scale = emissionScale(parameters.scale, parameters.illuminance, environment.pbrtIlluminance()) /
                         photometric(space.illuminant());
    return std::make_shared<ImageInfiniteLight>(worldFromLight, std::move(environment), float(scale));
}

ImageInfiniteLight::ImageInfiniteLight(const Transform& worldFromLight, EnvironmentImage image, float scale)
    : image_(std::move(image)), scale_(scale), density_(densityOverSquare(image_)) {
    const V3d x = worldFromLight.vector(V3d(1, 0, 0));
    const V3d y = worldFromLight.vector(V3d(0, 1, 0));
    const V3d z = worldFromLight.vector(V3d(0, 0, 1));
    checkAngles(x, y, z);
    x_ = toFloat(x.normalized());
    y_ = toFloat(y.normalized());
    z_ = toFloat(z.normalized());
}

SampledSpectrum ImageInfiniteLight::powerInto(const SceneSphere& sphere, const SampledWavelengths& lambda) const {
    return image_.mean().sample(lambda) * float(4 * piD * sphere.crossSection() * scale_);
}

float ImageInfiniteLight::pdfOfSquare(const V2f& square) const {
    const EnvironmentGrid& grid = image_.grid();
    const double texels = double(grid.width()) * grid.height();
    return float(density_.pdf(square) / (texels * grid.solidAngle(grid.row(square.y))));
}

std::optional<LightSample> ImageInfiniteLight::sample(const LightReceiver&, const V2f& u,
                                                      const SampledWavelengths& lambda) const {
    const V3f d = image_.grid().uniformDirection(density_.sample(u).p);
    LightSample sample;
    sample.wi = (x_ * d.x + y_ * d.y + z_ * d.z).normalized();
    // Radiance and density of the direction as it was rounded: at a texel's edge it may have changed sides.
    const V2f square = squareFromWorld(sample.wi);
    sample.pdf = pdfOfSquare(square);
    sample.l = image_.radiance(square, lambda) * scale_;
    if (!(sample.pdf > 0) || sample.l.isBlack()) return {};
    sample.shadow = Ray{V3d(0, 0, 0), toDouble(sample.wi), infinityD};
    return sample;
}

std::optional<LightEmission> ImageInfiniteLight::emit(const V2f& uPosition, const V2f& uDirection,
                                                      const SampledWavelengths& lambda, double) const {
    const auto towards = sample(LightReceiver(scene_.center), uDirection, lambda);
    if (!towards) return {};
    return LightEmission{scene_.beam(-towards->wi, uPosition),
                         towards->l * float(scene_.crossSection() / towards->pdf)};
}

SampledSpectrum ImageInfiniteLight::escaped(const V3f& w, const SampledWavelengths& lambda) const {
    return image_.radiance(squareFromWorld(w), lambda) * scale_;
}

float ImageInfiniteLight::pdf(const V3f& w) const {
    return pdfOfSquare(squareFromWorld(w));
}

} // namespace vitrine
