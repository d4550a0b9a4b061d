#include "nodes/svg_file.h"

#include "nodes/source.h"
#include "nodes/svg_reader.h"
#include "nodes/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine {

namespace {

std::string nameOf(const SvgElement& element) {
    if (element.id.empty() && element.label.empty())
        return fmt::format("the {} in line {} (without id)", element.tag, element.place.line);
    if (element.id.empty()) return inQuotes(element.label);
    return inQuotes(element.id) + (element.label.empty() ? "" : " (" + inQuotes(element.label) + ")");
}

/// `"path1", "path2" ("foot"), the path in line 7 (without id)`.
std::string listOf(const std::vector<const SvgElement*>& elements) {
    constexpr std::size_t most = 10;
    std::string list;
    for (std::size_t i = 0; i < std::min(most, elements.size()); ++i)
        list += (i > 0 ? ", " : "") + nameOf(*elements[i]);
    return elements.size() > most ? fmt::format("{} and {} more", list, elements.size() - most) : list;
}

std::string whatIs(std::string_view tag) {
    if (tag == "use") return "a clone, not a shape";
    if (tag == "text" || tag == "tspan") return "text, not a shape";
    if (tag == "g") return "a group, not a shape";
    return fmt::format("a <{}>, not a shape", tag.substr(0, 40));
}

std::string remedyFor(std::string_view tag) {
    if (tag == "use") return "Inkscape: Edit > Clone > Unlink Clone";
    if (tag == "text" || tag == "tspan") return "Inkscape: Path > Object to Path, then Ungroup";
    return {};
}

SceneError unknownId(const SvgDrawing& drawing, const std::string& id, const Place& askedAt) {
    const std::string& file = drawing.file->name;
    std::vector<const SvgElement*> all;
    std::vector<std::string> names;
    for (const SvgElement& element : drawing.elements) {
        all.push_back(&element);
        for (const std::string& name : {element.id, element.label})
            if (!name.empty()) names.push_back(name);
    }
    const std::string list = all.empty() ? "there are no shapes in the file" : "the shapes are " + listOf(all);
    if (const auto other = drawing.others.find(id); other != drawing.others.end()) {
        const std::string remedy = remedyFor(other->second);
        return SceneError(askedAt, fmt::format("{} in {} is {}", inQuotes(id), file, whatIs(other->second)),
                          remedy.empty() ? list : remedy);
    }
    const std::string nearest = didYouMean(id, names);
    return SceneError(askedAt, fmt::format("{} has no shape with the id {}", file, inQuotes(id)),
                      nearest.empty() ? list : nearest);
}

} // namespace

Place SvgDrawing::placeOf(std::size_t offset, std::size_t length) const {
    return LineCounter(file).at(offset, length);
}

const SvgElement& SvgDrawing::choose(const std::optional<std::string>& id, const Place& askedAt) const {
    std::vector<const SvgElement*> byId, byLabel;
    for (const SvgElement& element : elements) {
        if (id ? element.id == *id : element.rendered) byId.push_back(&element);
        if (id && element.label == *id) byLabel.push_back(&element);
    }
    const auto& found = byId.empty() ? byLabel : byId;
    if (found.empty()) {
        if (id) throw unknownId(*this, *id, askedAt);
        throw SceneError(askedAt, fmt::format("{} has no shape that is shown", file->name));
    }
    if (found.size() > 1 && id)
        throw SceneError(askedAt, fmt::format("{} has {} shapes with the {} {}", file->name, found.size(),
                                              byId.empty() ? "label" : "id", inQuotes(*id)));
    if (found.size() > 1)
        throw SceneError(askedAt, fmt::format("{} has {} shapes: choose one by its id", file->name, found.size()),
                         "they are " + listOf(found));
    if (found[0]->fault) throw SceneError({*found[0]->fault});
    return *found[0];
}

SvgDrawing readSvgText(std::string text, const std::string& name, const Place& namedAt) {
    const auto file = std::make_shared<SourceFile>();
    file->name = name;
    file->text = std::move(text);
    file->includedFrom = namedAt.file;
    file->includedAtLine = namedAt.line;
    checkIsText(file, "an SVG file");
    return SvgReader(file).read();
}

SvgDrawing readSvgFile(const std::string& fileName, const Place& namedAt) {
    return readSvgText(readWholeFile(fileName), fileName, namedAt);
}

} // namespace vitrine
