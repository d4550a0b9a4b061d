#include "textures/image_texture.h"

namespace vitrine {

namespace {

Texel look(const ImageTextureInput& input, const TexturePoint& at) {
    const PlanePoint point = input.mapping->map(at);
    // Rows of images go down, t goes up.
    const auto down = [](const V2d& step) { return V2d(step.x, -step.y); };
    return filtered(*input.image, input.sampling, V2d(point.st.x, 1 - point.st.y),
                    {down(point.dstdx), down(point.dstdy)});
}

} // namespace

float FloatImageTexture::evaluate(const TexturePoint& at) const {
    const float value = input_.scale * look(input_, at)[std::size_t(channel_)];
    return input_.invert ? std::max(0.f, 1 - value) : value;
}

SampledSpectrum SpectrumImageTexture::evaluate(const TexturePoint& at, const SampledWavelengths& lambda) const {
    const Texel texel = look(input_, at);
    const bool isGrey = input_.image->channels() == 1;
    Rgb rgb(texel[0], texel[isGrey ? 0 : 1], texel[isGrey ? 0 : 2]);
    rgb *= input_.scale;
    if (input_.invert) rgb = Rgb(1) - rgb;
    for (int i = 0; i < 3; ++i)
        rgb[i] = std::max(0.f, rgb[i]);
    switch (use_) {
    case SpectrumUse::Unbounded:
        return RgbUnboundedSpectrum(*colorSpace_, rgb).sample(lambda);
    case SpectrumUse::Illuminant:
        return RgbIlluminantSpectrum(*colorSpace_, rgb).sample(lambda);
    case SpectrumUse::Albedo:
        break;
    }
    return colorSpace_->sigmoid(rgb).sample(lambda);
}

} // namespace vitrine
