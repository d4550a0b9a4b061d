#include "textures/marble.h"

#include "spectrum/colorspace.h"

namespace vitrine {

namespace {

/// From vein to vein: of each four neighbours is made a cubic Bezier curve (so that the colour jumps where they meet: it is
/// pbrt-v4's marble).
const Rgb colours[] = {Rgb(.58f, .58f, .6f), Rgb(.58f, .58f, .6f), Rgb(.58f, .58f, .6f),
                       Rgb(.5f, .5f, .5f),   Rgb(.6f, .59f, .58f), Rgb(.58f, .58f, .6f),
                       Rgb(.58f, .58f, .6f), Rgb(.2f, .2f, .33f),  Rgb(.58f, .58f, .6f)};
constexpr int curves = int(std::size(colours)) - 3;
constexpr float brightness = 1.5f;

/// \param t in [0, 1], over all curves
Rgb colourAt(float t) {
    const int curve = std::min(int(t * curves), curves - 1);
    const float u = t * curves - float(curve), v = 1 - u;
    const Rgb* c = colours + curve;
    return (c[0] * (v * v * v) + c[1] * (3 * v * v * u) + c[2] * (3 * v * u * u) + c[3] * (u * u * u)) * brightness;
}

} // namespace

SampledSpectrum MarbleTexture::evaluate(const TexturePoint& at, const SampledWavelengths& lambda) const {
    const SpacePoint point = scaled(space_.map(at), scale_);
    const double phase = point.p.y + variation_ * fbm(point, octaves_);
    return RgbAlbedoSpectrum(RgbColorSpace::srgb(), colourAt(float(0.5 + 0.5 * std::sin(phase)))).sample(lambda);
}

} // namespace vitrine
