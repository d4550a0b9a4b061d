#include "scene/image_texture_builder.h"
#include "scene/mapping_builder.h"
#include "scene/registry.h"
#include "textures/bilerp.h"
#include "textures/checkerboard.h"
#include "textures/constant.h"
#include "textures/direction_mix.h"
#include "textures/dots.h"
#include "textures/fbm.h"
#include "textures/marble.h"
#include "textures/mix.h"
#include "textures/scale.h"
#include "textures/windy.h"
#include "textures/wrinkled.h"

namespace vitrine {

namespace {

// Textures of numbers and of spectra are built alike. `Use` is empty for numbers, SpectrumUse for spectra.

template <class... Use>
using InputOf = std::conditional_t<sizeof...(Use) == 0, FloatInput, SpectrumInput>;
template <class... Use>
using TexturePtrOf = std::conditional_t<sizeof...(Use) == 0, FloatTexturePtr, SpectrumTexturePtr>;

FloatInput findInput(BuildContext& context, const ParameterSet& p, std::string_view name, float fallback) {
    return findFloatInput(context, p, name).value_or(fallback);
}

SpectrumInput orConstant(SpectrumInput found, float fallback) {
    return found ? std::move(found) : SpectrumInput(std::make_shared<ConstantSpectrum>(fallback));
}

SpectrumInput findInput(BuildContext& context, const ParameterSet& p, std::string_view name, float fallback,
                        SpectrumUse use) {
    return orConstant(findSpectrumInput(context, p, name, use), fallback);
}

// Where pbrt-v4 takes no texture.

FloatInput findConstant(BuildContext&, const ParameterSet& p, std::string_view name, float fallback) {
    return float(p.getFloat(name, fallback));
}

SpectrumInput findConstant(BuildContext& context, const ParameterSet& p, std::string_view name, float fallback,
                           SpectrumUse use) {
    return orConstant(findSpectrum(context, p, name, use), fallback);
}

template <class... Use>
TexturePtrOf<Use...> constant(BuildContext& context, const TextureNode& node, Use... use) {
    return std::make_shared<ConstantTexture<InputOf<Use...>>>(
        findConstant(context, node.parameters, "value", 1, use...));
}

template <class... Use>
TexturePtrOf<Use...> scale(BuildContext& context, const TextureNode& node, Use... use) {
    return std::make_shared<ScaleTexture<InputOf<Use...>>>(findInput(context, node.parameters, "tex", 1, use...),
                                                           findInput(context, node.parameters, "scale", 1));
}

template <class... Use>
TexturePtrOf<Use...> mix(BuildContext& context, const TextureNode& node, Use... use) {
    return std::make_shared<MixTexture<InputOf<Use...>>>(findInput(context, node.parameters, "tex1", 0, use...),
                                                         findInput(context, node.parameters, "tex2", 1, use...),
                                                         findInput(context, node.parameters, "amount", 0.5f));
}

template <class... Use>
TexturePtrOf<Use...> directionMix(BuildContext& context, const TextureNode& node, Use... use) {
    const ParameterSet& p = node.parameters;
    FloatTexturePtr weight = std::make_shared<DirectionWeight>(still(context, node.worldFromTexture, node.place),
                                                               p.getVector3("dir", V3d(0, 1, 0)));
    return std::make_shared<MixTexture<InputOf<Use...>>>(findInput(context, p, "tex1", 0, use...),
                                                         findInput(context, p, "tex2", 1, use...), std::move(weight));
}

FloatTexturePtr checkerboardWeight(BuildContext& context, const TextureNode& node) {
    const int dimension = node.parameters.getInteger("dimension", 2);
    if (dimension == 3) return std::make_shared<CubesWeight>(findTextureSpace(context, node));
    if (dimension != 2) node.parameters.errorAtValue("dimension", 0, "\"dimension\" must be 2 or 3");
    return std::make_shared<SquaresWeight>(findMapping(context, node));
}

template <class... Use>
TexturePtrOf<Use...> checkerboard(BuildContext& context, const TextureNode& node, Use... use) {
    return std::make_shared<MixTexture<InputOf<Use...>>>(findInput(context, node.parameters, "tex1", 1, use...),
                                                         findInput(context, node.parameters, "tex2", 0, use...),
                                                         checkerboardWeight(context, node));
}

template <class... Use>
TexturePtrOf<Use...> dots(BuildContext& context, const TextureNode& node, Use... use) {
    FloatTexturePtr weight = std::make_shared<DotsWeight>(findMapping(context, node));
    return std::make_shared<MixTexture<InputOf<Use...>>>(findInput(context, node.parameters, "outside", 0, use...),
                                                         findInput(context, node.parameters, "inside", 1, use...),
                                                         std::move(weight));
}

template <class... Use>
TexturePtrOf<Use...> bilerp(BuildContext& context, const TextureNode& node, Use... use) {
    const ParameterSet& p = node.parameters;
    using Input = InputOf<Use...>;
    const std::array<Input, 4> corners = {
        findConstant(context, p, "v00", 0, use...), findConstant(context, p, "v01", 1, use...),
        findConstant(context, p, "v10", 0, use...), findConstant(context, p, "v11", 1, use...)};
    return std::make_shared<BilerpTexture<Input>>(findMapping(context, node), corners);
}

Octaves findOctaves(const ParameterSet& p) {
    return Octaves(p.getInteger("octaves", 8), float(p.getFloat("roughness", 0.5)));
}

FloatTexturePtr fbm(BuildContext& context, const TextureNode& node) {
    return std::make_shared<FbmTexture>(findTextureSpace(context, node), findOctaves(node.parameters));
}

FloatTexturePtr wrinkled(BuildContext& context, const TextureNode& node) {
    return std::make_shared<WrinkledTexture>(findTextureSpace(context, node), findOctaves(node.parameters));
}

FloatTexturePtr windy(BuildContext& context, const TextureNode& node) {
    return std::make_shared<WindyTexture>(findTextureSpace(context, node));
}

SpectrumTexturePtr marble(BuildContext& context, const TextureNode& node, SpectrumUse) {
    const ParameterSet& p = node.parameters;
    return std::make_shared<MarbleTexture>(findTextureSpace(context, node), findOctaves(p),
                                           float(p.getFloat("scale", 1)), float(p.getFloat("variation", 0.2)));
}

using FloatTextureBuilder = FloatTexturePtr (*)(BuildContext&, const TextureNode&);
using SpectrumTextureBuilder = SpectrumTexturePtr (*)(BuildContext&, const TextureNode&, SpectrumUse);

constexpr RegistryEntry<FloatTextureBuilder> floatTextureTypes[] = {{"constant", constant},
                                                                    {"scale", scale},
                                                                    {"mix", mix},
                                                                    {"directionmix", directionMix},
                                                                    {"bilerp", bilerp},
                                                                    {"checkerboard", checkerboard},
                                                                    {"dots", dots},
                                                                    {"fbm", fbm},
                                                                    {"wrinkled", wrinkled},
                                                                    {"windy", windy},
                                                                    {"imagemap", buildFloatImageTexture},
                                                                    {"ptex"}};

constexpr RegistryEntry<SpectrumTextureBuilder> spectrumTextureTypes[] = {{"constant", constant},
                                                                          {"scale", scale},
                                                                          {"mix", mix},
                                                                          {"directionmix", directionMix},
                                                                          {"bilerp", bilerp},
                                                                          {"checkerboard", checkerboard},
                                                                          {"dots", dots},
                                                                          {"marble", marble},
                                                                          {"imagemap", buildSpectrumImageTexture},
                                                                          {"ptex"}};

} // namespace

FloatTexturePtr buildFloatTexture(BuildContext& context, const TextureNode& node) {
    return findBuilder<FloatTextureBuilder>(floatTextureTypes, node, "float texture")(context, node);
}

SpectrumTexturePtr buildSpectrumTexture(BuildContext& context, const TextureNode& node, SpectrumUse use) {
    return findBuilder<SpectrumTextureBuilder>(spectrumTextureTypes, node, "spectrum texture")(context, node, use);
}

} // namespace vitrine
