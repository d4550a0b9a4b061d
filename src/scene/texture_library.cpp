#include "scene/texture_library.h"

#include "scene/context.h"

#include <fmt/format.h>

namespace vitrine {

namespace {

/// What there is, for "did you mean".
template <class Table>
std::vector<std::string> namesIn(const Table& table) {
    std::vector<std::string> names;
    for (const auto& [name, entry] : table)
        names.push_back(name);
    return names;
}

} // namespace

TextureLibrary::TextureLibrary(BuildContext& context, const SceneNodes& nodes) : context_(context) {
    for (const TextureNode& node : nodes.floatTextures)
        floats_[node.name].node = &node;
    for (const TextureNode& node : nodes.spectrumTextures)
        spectra_[node.name].node = &node;
}

template <class TexturePtr, class Build>
TexturePtr TextureLibrary::make(Entry<TexturePtr>& entry, SpectrumUse use, Build&& build) {
    if (entry.failed) return nullptr; // said once
    if (const auto known = entry.built.find(use); known != entry.built.end()) return known->second;
    entry.isUnderWay = true;
    TexturePtr made = context_.guarded(*entry.node, [&]() -> TexturePtr { return build(*entry.node); });
    entry.isUnderWay = false;
    entry.failed = !made;
    return entry.built[use] = std::move(made);
}

template <class TexturePtr, class Build>
TexturePtr TextureLibrary::find(Table<TexturePtr>& table, const ParameterSet& parameters, std::string_view parameter,
                                const std::string& name, SpectrumUse use, Build&& build) {
    constexpr bool isFloat = std::is_same_v<TexturePtr, FloatTexturePtr>;
    const auto entry = table.find(name);
    if (entry == table.end()) {
        const bool isOther = isFloat ? spectra_.contains(name) : floats_.contains(name);
        const std::string hint = isOther
                                     ? fmt::format("there is a {} texture of that name", isFloat ? "spectrum" : "float")
                                     : didYouMean(name, namesIn(table));
        parameters.error(parameter, fmt::format("no {} texture \"{}\"", isFloat ? "float" : "spectrum", name), hint);
        return nullptr;
    }
    if (entry->second.isUnderWay) {
        parameters.error(parameter, fmt::format("texture \"{}\" refers to itself", name));
        return nullptr;
    }
    return make(entry->second, use, build);
}

FloatTexturePtr TextureLibrary::findFloat(const ParameterSet& parameters, std::string_view parameter,
                                          const std::string& name) {
    return find(floats_, parameters, parameter, name, SpectrumUse::Unbounded,
                [&](const TextureNode& node) { return buildFloatTexture(context_, node); });
}

SpectrumTexturePtr TextureLibrary::findSpectrum(const ParameterSet& parameters, std::string_view parameter,
                                                const std::string& name, SpectrumUse use) {
    return find(spectra_, parameters, parameter, name, use,
                [&](const TextureNode& node) { return buildSpectrumTexture(context_, node, use); });
}

void TextureLibrary::buildRest() {
    for (auto& [name, entry] : floats_)
        make(entry, SpectrumUse::Unbounded, [&](const TextureNode& node) { return buildFloatTexture(context_, node); });
    for (auto& [name, entry] : spectra_)
        if (entry.built.empty())
            make(entry, SpectrumUse::Unbounded,
                 [&](const TextureNode& node) { return buildSpectrumTexture(context_, node, SpectrumUse::Unbounded); });
}

} // namespace vitrine
