// Scene text in pbrt-v4's format -> SceneNodes.
#pragma once

#include "nodes/nodes.h"

namespace vitrine {

/// What a text gives, whether or not it is right.
struct ParsedScene {
    SceneNodes nodes;
    std::vector<Diagnostic> diagnostics; ///< errors (at most Diagnostics::maxErrors) and warnings, in the order found
    bool hasErrors = false;
    /// Errors of these nodes are errors of the text too: nothing is lost that others depend on. True without errors.
    bool nodesTellMore = true;

    /// \throws SceneError if there is an error
    SceneNodes checkedNodes() &&;
};

/// What a scene from standard input is called.
inline constexpr const char* standardInputName = "<stdin>";

/// Reads a scene file (".gz": compressed; "-": standard input) and what it includes.
/// \throws FileError when the file itself cannot be read
ParsedScene readSceneFile(const std::string& fileName);
/// The same for a text, as parseSceneString().
ParsedScene readSceneString(std::string text, const std::string& name, const std::string& baseDirectory);

/// As readSceneFile(). \throws SceneError with every error found when the scene is wrong
SceneNodes parseSceneFile(const std::string& fileName);

/// The same for a text. `name` stands in messages; file names are relative to `baseDirectory` (empty: the current one).
SceneNodes parseSceneString(std::string text, const std::string& name = "<string>",
                            const std::string& baseDirectory = {});

/// A parameter list as it stands in a scene file: `"integer maxdepth" 5 "bool nee" false`. \throws SceneError
ParameterList parseParameters(const std::string& text, const std::string& name = "<string>");

/// `key=value`, or `type key=value`, of the command line's --set, for ParameterSet::addOverride(). Without a type the
/// value takes the one it is asked for; several values are separated by commas or spaces. \throws SceneError with the
/// place in "--set"
ParameterPtr parseSetting(const std::string& text);

/// Where a file named in a scene lies: relative to the scene's directory (as in pbrt-v4), or else, when there is no
/// such file, to the directory of the included file that names it. Absolute names stay.
std::string resolveFile(const SceneNodes& scene, const Place& namedAt, const std::string& fileName);

/// The error for a type that no registry knows, with the nearest valid name or what pbrt-v3 called it: `unknown shape
/// "sphear"`. `family` is "shape", "material", ...
SceneError unknownType(const Node& node, const std::string& family, const std::vector<std::string>& validTypes);

} // namespace vitrine
