#include "scene/image_texture_builder.h"

#include "nodes/text.h"
#include "scene/mapping_builder.h"
#include "textures/image_texture.h"

#include <fmt/format.h>

#include <array>

namespace vitrine {

namespace {

template <class T, std::size_t n>
T choice(const ParameterSet& p, std::string_view name, const std::array<std::pair<const char*, T>, n>& choices,
         std::size_t fallback) {
    std::vector<std::string> names;
    for (const auto& [known, value] : choices)
        names.emplace_back(known);
    const std::string given = p.getChoice(name, names[fallback], names);
    return choices[std::size_t(std::find(names.begin(), names.end(), given) - names.begin())].second;
}

ImageSampling sampling(const ParameterSet& p) {
    ImageSampling s;
    s.filter = choice<ImageFilter, 4>(p, "filter",
                                      {{{"point", ImageFilter::Point},
                                        {"bilinear", ImageFilter::Bilinear},
                                        {"trilinear", ImageFilter::Trilinear},
                                        {"ewa", ImageFilter::Ewa}}},
                                      1);
    s.maxAnisotropy = float(p.getFloat("maxanisotropy", 8));
    if (!(s.maxAnisotropy >= 1 && s.maxAnisotropy <= 256))
        p.error("maxanisotropy", "\"maxanisotropy\" must lie in [1, 256]");
    if (p.getString("wrap", "") == "octahedralsphere")
        p.error("wrap", "\"wrap\" \"octahedralsphere\" is not yet supported");
    else
        s.wrap = choice<ImageWrap, 3>(
            p, "wrap", {{{"repeat", ImageWrap::Repeat}, {"black", ImageWrap::Black}, {"clamp", ImageWrap::Clamp}}}, 0);
    return s;
}

ImageEncoding encoding(const ParameterSet& p) {
    const auto text = p.findString("encoding");
    if (!text) return {};
    if (*text == "sRGB") return {ImageEncoding::Kind::Srgb};
    if (*text == "linear") return {ImageEncoding::Kind::Gamma, 1};
    double gamma = 0;
    if (text->starts_with("gamma ") && parseReal(text->substr(6), gamma) == NumberFault::None && gamma > 0)
        return {ImageEncoding::Kind::Gamma, gamma};
    p.error("encoding",
            fmt::format("\"encoding\" must be \"sRGB\", \"linear\" or \"gamma\" with a positive number, not {}",
                        inQuotes(*text)));
    return {};
}

/// Reads the image too.
ImageTextureInput input(BuildContext& context, const TextureNode& node,
                        const TextureImage& (TextureImages::*read)(const std::string&, const ImageEncoding&),
                        const TextureImage*& image) {
    const ParameterSet& p = node.parameters;
    const auto file = p.findString("filename");
    if (!file) throw SceneError(node.place, "an imagemap needs \"string filename\"");
    ImageTextureInput result;
    result.sampling = sampling(p);
    result.scale = float(p.getFloat("scale", 1));
    result.invert = p.getBool("invert", false);
    result.mapping = findMapping(context, node);
    image = &(context.images().*read)(context.file(p, "filename", *file), encoding(p));
    for (const auto& warning : image->warnings)
        context.diagnostics().warning(p.valuePlace("filename", 0), warning);
    result.image = image->image;
    return result;
}

} // namespace

FloatTexturePtr buildFloatImageTexture(BuildContext& context, const TextureNode& node) {
    const TextureImage* image = nullptr;
    ImageTextureInput common = input(context, node, &TextureImages::numbers, image);
    return std::make_shared<FloatImageTexture>(std::move(common), image->channel);
}

SpectrumTexturePtr buildSpectrumImageTexture(BuildContext& context, const TextureNode& node, SpectrumUse use) {
    const TextureImage* image = nullptr;
    ImageTextureInput common = input(context, node, &TextureImages::colours, image);
    return std::make_shared<SpectrumImageTexture>(std::move(common), *image->colorSpace, use);
}

} // namespace vitrine
