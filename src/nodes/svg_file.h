// The shapes of an SVG file as plain outlines.
#pragma once

#include "core/errors.h"
#include "nodes/svg_path.h"

#include <map>
#include <optional>

namespace vitrine {

/// A path, line, polyline, polygon, rect, circle or ellipse.
struct SvgElement {
    std::string tag;   ///< "path", "rect" ... without a namespace prefix
    std::string id;    ///< or empty
    std::string label; ///< what Inkscape's list of objects shows (inkscape:label), or empty
    Place place;       ///< of the element's name
    /// In user units of the outermost svg element, y down: what the file's coordinates are after the transforms of the
    /// element and its ancestors. Offsets are bytes of the file's text.
    SvgPath path;
    bool rendered = true;            ///< false within defs, symbol, clipPath, marker ...
    std::optional<Diagnostic> fault; ///< why the path is empty; other elements of the file may be sound
};

struct SvgDrawing {
    std::shared_ptr<const SourceFile> file;
    std::vector<SvgElement> elements;          ///< in the order of the file
    std::map<std::string, std::string> others; ///< id -> tag of what is no shape: groups, text, clones ...
    /// What width, height and viewBox of the outermost svg element make of a unit, x and y (they differ with
    /// preserveAspectRatio="none"); 25.4/96 when they do not say.
    V2d millimetresPerUnit{25.4 / 96, 25.4 / 96};

    /// The place of some bytes of the file.
    Place placeOf(std::size_t offset, std::size_t length = 1) const;
    /// The shape with this id, or else with this label; without an id the only one that is rendered. One without fault.
    /// \param askedAt where the choice is made, for errors \throws SceneError that lists the ids that there are
    const SvgElement& choose(const std::optional<std::string>& id, const Place& askedAt) const;
};

/// \param namedAt the place in a scene that names the file, if any: shown with errors in the file.
/// \throws FileError when the file cannot be read, SceneError when it is no SVG. Styles and scripts are passed over.
SvgDrawing readSvgFile(const std::string& fileName, const Place& namedAt = {});

/// The same for a text; `name` stands in messages.
SvgDrawing readSvgText(std::string text, const std::string& name, const Place& namedAt = {});

} // namespace vitrine
