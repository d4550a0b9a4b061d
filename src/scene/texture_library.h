// The textures of a scene by name, each built when it is first asked for.
#pragma once

#include "nodes/nodes.h"
#include "textures/spectrum_use.h"
#include "textures/texture.h"

#include <map>
#include <optional>

namespace vitrine {

class BuildContext;

class TextureLibrary {
  public:
    TextureLibrary(BuildContext& context, const SceneNodes& nodes);

    /// The texture that a parameter names; null when it is wrong (then recorded) or refers to itself.
    FloatTexturePtr findFloat(const ParameterSet& parameters, std::string_view parameter, const std::string& name);
    SpectrumTexturePtr findSpectrum(const ParameterSet& parameters, std::string_view parameter, const std::string& name,
                                    SpectrumUse use);
    /// Also builds what nothing uses: what stands in it shall be right.
    void buildRest();

  private:
    template <class TexturePtr>
    struct Entry {
        const TextureNode* node = nullptr;
        std::map<SpectrumUse, TexturePtr> built;
        bool isUnderWay = false, failed = false;
    };
    template <class TexturePtr>
    using Table = std::map<std::string, Entry<TexturePtr>, std::less<>>;

    template <class TexturePtr, class Build>
    TexturePtr find(Table<TexturePtr>& table, const ParameterSet& parameters, std::string_view parameter,
                    const std::string& name, SpectrumUse use, Build&& build);
    template <class TexturePtr, class Build>
    TexturePtr make(Entry<TexturePtr>& entry, SpectrumUse use, Build&& build);

    BuildContext& context_;
    Table<FloatTexturePtr> floats_;
    Table<SpectrumTexturePtr> spectra_;
};

// The families, one table each (texture_builder.cpp).

FloatTexturePtr buildFloatTexture(BuildContext& context, const TextureNode& node);
SpectrumTexturePtr buildSpectrumTexture(BuildContext& context, const TextureNode& node, SpectrumUse use);

} // namespace vitrine
