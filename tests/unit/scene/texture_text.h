// Textures of scene texts.
#pragma once

#include "nodes/parser.h"
#include "scene/context.h"

namespace vitrine {

/// The textures of a text, by name.
class Textures {
  public:
    explicit Textures(const std::string& text)
        : nodes_(parseSceneString("WorldBegin\n" + text, "scene.pbrt")), context_(nodes_, diagnostics_) {}

    float number(const std::string& name, const TexturePoint& at = {}) {
        const FloatTexturePtr texture = context_.textures().findFloat({}, "", name);
        diagnostics_.throwIfErrors();
        return texture->evaluate(at);
    }
    SampledSpectrum spectrum(const std::string& name, SpectrumUse use = SpectrumUse::Albedo,
                             const TexturePoint& at = {}, const SampledWavelengths& wavelengths = lambda()) {
        const SpectrumTexturePtr texture = context_.textures().findSpectrum({}, "", name, use);
        diagnostics_.throwIfErrors();
        return texture->evaluate(at, wavelengths);
    }
    /// What was said of them besides errors.
    const std::vector<Diagnostic>& warnings() const { return diagnostics_.all(); }
    static SampledWavelengths lambda() { return SampledWavelengths::uniform(0.4f); }

  private:
    SceneNodes nodes_;
    Diagnostics diagnostics_;
    BuildContext context_;
};

} // namespace vitrine
