#include "scene/context.h"
#include "scene/registry.h"
#include "textures/constant.h"

namespace vitrine {

namespace {

FloatTexturePtr constantFloat(BuildContext&, const TextureNode& node) {
    return std::make_shared<ConstantFloatTexture>(float(node.parameters.getFloat("value", 1)));
}

SpectrumTexturePtr constantSpectrum(BuildContext& context, const TextureNode& node, SpectrumUse use) {
    SpectrumPtr value = findSpectrum(context, node.parameters, "value", use);
    return std::make_shared<ConstantSpectrumTexture>(value ? std::move(value)
                                                           : std::make_shared<ConstantSpectrum>(1.f));
}

using FloatTextureBuilder = FloatTexturePtr (*)(BuildContext&, const TextureNode&);
using SpectrumTextureBuilder = SpectrumTexturePtr (*)(BuildContext&, const TextureNode&, SpectrumUse);

constexpr RegistryEntry<FloatTextureBuilder> floatTextureTypes[] = {{"constant", constantFloat},
                                                                    {"bilerp"},
                                                                    {"checkerboard"},
                                                                    {"directionmix"},
                                                                    {"dots"},
                                                                    {"fbm"},
                                                                    {"imagemap"},
                                                                    {"mix"},
                                                                    {"ptex"},
                                                                    {"scale"},
                                                                    {"windy"},
                                                                    {"wrinkled"}};

constexpr RegistryEntry<SpectrumTextureBuilder> spectrumTextureTypes[] = {{"constant", constantSpectrum},
                                                                          {"bilerp"},
                                                                          {"checkerboard"},
                                                                          {"directionmix"},
                                                                          {"dots"},
                                                                          {"imagemap"},
                                                                          {"marble"},
                                                                          {"mix"},
                                                                          {"ptex"},
                                                                          {"scale"}};

} // namespace

FloatTexturePtr buildFloatTexture(BuildContext& context, const TextureNode& node) {
    return findBuilder<FloatTextureBuilder>(floatTextureTypes, node, "float texture")(context, node);
}

SpectrumTexturePtr buildSpectrumTexture(BuildContext& context, const TextureNode& node, SpectrumUse use) {
    return findBuilder<SpectrumTextureBuilder>(spectrumTextureTypes, node, "spectrum texture")(context, node, use);
}

} // namespace vitrine
