// What all builders share while a scene's nodes are turned into objects.
#pragma once

#include "core/motion.h"
#include "scene/texture_images.h"
#include "scene/texture_library.h"
#include "spectrum/colorspace.h"

#include <set>

namespace vitrine {

/// Building never stops at the first error: a builder records what is wrong and the next one goes on.
class BuildContext {
  public:
    BuildContext(const SceneNodes& nodes, Diagnostics& diagnostics)
        : nodes_(nodes), diagnostics_(diagnostics), textures_(*this, nodes), images_(nodes) {}
    BuildContext(const BuildContext&) = delete;

    const SceneNodes& nodes() const { return nodes_; }
    Diagnostics& diagnostics() { return diagnostics_; }
    TextureLibrary& textures() { return textures_; }
    TextureImages& images() { return images_; }

    /// Runs `build()` for a node, turns what it throws into diagnostics at the node's place, and reports unread
    /// parameters. Empty (value-initialised) result after an error.
    template <class Build>
    auto guarded(const Node& node, Build&& build) -> decltype(build()) {
        decltype(build()) result{};
        // Nothing more would be shown, and half a million wrong shapes shall not each be looked at.
        if (diagnostics_.full()) return result;
        bool finished = false;
        try {
            result = build();
            finished = true;
        } catch (const SceneError& e) {
            for (const auto& d : e.diagnostics())
                diagnostics_.error(d.place, d.message, d.hint);
        } catch (const std::invalid_argument& e) {
            diagnostics_.error(node.place, e.what());
        } catch (const std::domain_error& e) {
            diagnostics_.error(node.place, e.what());
        } catch (const FileError& e) {
            // A file that the scene names: the scene is wrong there, and may be wrong elsewhere too.
            const bool named = node.parameters.has("filename");
            diagnostics_.error(named ? node.parameters.valuePlace("filename", 0) : node.place, e.what());
        }
        // After a failure not everything has been asked for: unread parameters would be false alarms.
        if (finished)
            node.parameters.report(diagnostics_);
        else
            node.parameters.reportErrors(diagnostics_);
        return result;
    }

    /// Where the file named by a parameter lies; remembers it as one that the picture depends on.
    std::string file(const ParameterSet& parameters, std::string_view name, const std::string& value);
    /// Files besides scene texts that were read.
    const std::set<std::string>& files() const { return files_; }

    /// For `vitrine info`.
    void countPrimitives(std::size_t n) { primitives_ += n; }
    std::size_t primitives() const { return primitives_; }

    /// Named spectra and .spd files are shared.
    SpectrumPtr namedOrFile(const SpectrumNode& node);

  private:
    const SceneNodes& nodes_;
    Diagnostics& diagnostics_;
    TextureLibrary textures_;
    TextureImages images_;
    std::set<std::string> files_;
    std::size_t primitives_ = 0;
    std::map<std::string, SpectrumPtr> spectra_;
};

/// The spectrum of a parameter; null when it is not given or wrong (then recorded). A single float is allowed for Albedo
/// and Unbounded where pbrt-v4 takes one for a texture's constant.
SpectrumPtr findSpectrum(BuildContext& context, const ParameterSet& parameters, std::string_view name, SpectrumUse use);

/// The same where a texture may stand.
SpectrumInput findSpectrumInput(BuildContext& context, const ParameterSet& parameters, std::string_view name,
                                SpectrumUse use);

/// A float or a float texture; empty when it is not given or wrong (then recorded).
std::optional<FloatInput> findFloatInput(BuildContext& context, const ParameterSet& parameters, std::string_view name);

/// Says that a parameter is valid in pbrt-v4 but not yet supported, if it is given (whatever its type).
void refuse(const ParameterSet& parameters, std::initializer_list<std::string_view> names);

/// Parameters that change nothing here by design: read so that they are no error.
void acceptWithoutEffect(const ParameterSet& parameters, std::initializer_list<std::string_view> names);

/// Where a node is at each time. Records an error for a movement that cannot be.
Motion motionOf(BuildContext& context, const MovingTransformPtr& transform, const Place& place);

/// The transformation of a node that must not move. Records an error when it does.
const Transform& still(BuildContext& context, const MovingTransformPtr& transform, const Place& place);

} // namespace vitrine
