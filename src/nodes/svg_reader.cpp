#include "nodes/svg_reader.h"

#include "nodes/svg_shapes.h"
#include "nodes/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace vitrine {

namespace {

constexpr int deepest = 500; ///< elements in elements
constexpr std::size_t mostPrefixes = 16;
constexpr std::string_view svgNamespace = "http://www.w3.org/2000/svg";
constexpr double millimetresPerPixel = 25.4 / 96;

/// Elements whose content is drawn where something refers to them, or never.
constexpr std::string_view unrendered[] = {"defs", "symbol", "clipPath", "mask", "pattern", "marker"};
constexpr std::string_view containers[] = {"svg", "g", "a", "switch"};

/// Properties of a style that would move or change an outline. They are refused, the others passed over.
constexpr std::string_view geometryProperties[] = {"transform",
                                                   "transform-origin",
                                                   "transform-box",
                                                   "translate",
                                                   "rotate",
                                                   "scale",
                                                   "offset-path",
                                                   "d",
                                                   "x",
                                                   "y",
                                                   "width",
                                                   "height",
                                                   "cx",
                                                   "cy",
                                                   "r",
                                                   "rx",
                                                   "ry"};

template <std::size_t N>
bool isOneOf(std::string_view word, const std::string_view (&words)[N]) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

std::string_view trimmed(std::string_view s) {
    const auto isBlank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    while (!s.empty() && isBlank(s.front()))
        s.remove_prefix(1);
    while (!s.empty() && isBlank(s.back()))
        s.remove_suffix(1);
    return s;
}

/// Calls visit(name, value) for each declaration of a style attribute.
template <class Visit>
void forEachProperty(std::string_view style, Visit&& visit) {
    while (!style.empty()) {
        const std::string_view declaration = style.substr(0, style.find(';'));
        style.remove_prefix(std::min(style.size(), declaration.size() + 1));
        const std::size_t colon = declaration.find(':');
        if (colon != std::string_view::npos)
            visit(trimmed(declaration.substr(0, colon)), trimmed(declaration.substr(colon + 1)));
    }
}

bool isHidden(const SvgAttributes& in) {
    bool hidden = trimmed(in.text("display")) == "none";
    forEachProperty(in.text("style"), [&](std::string_view name, std::string_view value) {
        if (name == "display") hidden = value.starts_with("none");
    });
    return hidden;
}

/// The element's own transformation.
M33d ownTransform(const SvgAttributes& in) {
    if (in.has("transform-origin")) throw in.error("transform-origin", "\"transform-origin\" is not supported");
    forEachProperty(in.text("style"), [&](std::string_view name, std::string_view) {
        if (isOneOf(name, geometryProperties))
            throw in.error("style", fmt::format("\"{}\" in a style is not supported", name),
                           "write it as an attribute of the element");
    });
    const M33d m = in.read("transform", readSvgTransform);
    const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    if (!std::isfinite(determinant) || !std::isfinite(m[2][0]) || !std::isfinite(m[2][1]) || determinant == 0)
        throw in.error("transform", "the transformation is singular or too large");
    return m;
}

/// Points by the matrix. What becomes shorter than any number is dropped.
SvgPath transformedPath(SvgPath path, const M33d& m, const SvgAttributes& in) {
    for (SvgSubpath& subpath : path.subpaths) {
        for (SvgSegment& segment : subpath.segments)
            for (V2d& p : segment.controls()) {
                p = transformed(p, m);
                if (!std::isfinite(p.x) || !std::isfinite(p.y))
                    throw SvgTextError(in.offset(), in.nameLength(), "the element's coordinates are too large");
            }
        std::erase_if(subpath.segments, [](const SvgSegment& segment) {
            const auto points = segment.controls();
            return std::all_of(points.begin(), points.end(), [&](const V2d& p) { return p == points[0]; });
        });
    }
    std::erase_if(path.subpaths, [](const SvgSubpath& subpath) { return subpath.segments.empty(); });
    return path;
}

} // namespace

Place LineCounter::at(std::size_t offset, std::size_t length) {
    if (offset < counted_) {
        line_ = 1;
        lineStart_ = counted_ = 0;
    }
    const std::string& text = file_->text;
    for (offset = std::min(offset, text.size()); counted_ < offset; ++counted_)
        if (text[counted_] == '\n') {
            ++line_;
            lineStart_ = counted_ + 1;
        }
    return Place{file_, int(line_), int(offset - lineStart_) + 1, int(length)};
}

SvgReader::SvgReader(const std::shared_ptr<const SourceFile>& file) : buffer_(file->text), lines_(file) {
    drawing_.file = file;
}

SvgDrawing SvgReader::read() {
    // Entities of a DOCTYPE are not expanded by pugixml: nothing grows.
    const pugi::xml_parse_result result =
        document_.load_buffer_inplace(buffer_.data(), buffer_.size(), pugi::parse_escapes, pugi::encoding_utf8);
    if (!result) {
        std::string what = result.description();
        what[0] = char(std::tolower(static_cast<unsigned char>(what[0])));
        throw SceneError(lines_.at(std::size_t(result.offset), 1), "the file is not well-formed XML: " + what);
    }
    const pugi::xml_node root = document_.document_element();
    Scope scope;
    declareNamespaces(root, scope);
    if (svgTag(root, scope) != "svg")
        throw SceneError(lines_.at(std::size_t(root.offset_debug()), attributesOf(root).nameLength()),
                         fmt::format("the file is no SVG: it begins with {}", inQuotes(root.name())));
    try {
        openOutermost(root, scope);
    } catch (const SvgTextError& error) {
        throw SceneError({diagnostic(error)});
    }
    visitChildren(root, scope);
    return std::move(drawing_);
}

SvgAttributes SvgReader::attributesOf(const pugi::xml_node& node) const {
    return SvgAttributes(node, drawing_.file->text, buffer_.data());
}

Diagnostic SvgReader::diagnostic(const SvgTextError& error) {
    return {Diagnostic::Severity::Error, lines_.at(error.offset, error.length), error.what(), error.hint};
}

void SvgReader::declareNamespaces(const pugi::xml_node& node, Scope& scope) {
    for (const pugi::xml_attribute& attribute : node.attributes()) {
        const std::string_view name = attribute.name();
        if (name != "xmlns" && !name.starts_with("xmlns:")) continue;
        const std::string prefix(name == "xmlns" ? "" : name.substr(6));
        std::erase(scope.prefixes, prefix);
        if (attribute.value() == svgNamespace) scope.prefixes.push_back(prefix);
        if (scope.prefixes.size() > mostPrefixes)
            throw SceneError(lines_.at(std::size_t(node.offset_debug()), 1),
                             fmt::format("more than {} prefixes for SVG's namespace", mostPrefixes));
        scope.namespaceKnown |= prefix.empty() || attribute.value() == svgNamespace;
    }
}

std::string_view SvgReader::svgTag(const pugi::xml_node& node, const Scope& scope) const {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    const std::string_view prefix = colon == std::string_view::npos ? "" : name.substr(0, colon);
    const bool isSvg = scope.namespaceKnown
                           ? std::find(scope.prefixes.begin(), scope.prefixes.end(), prefix) != scope.prefixes.end()
                           : prefix.empty();
    return !isSvg ? std::string_view() : colon == std::string_view::npos ? name : name.substr(colon + 1);
}

void SvgReader::openOutermost(const pugi::xml_node& root, Scope& scope) {
    const SvgAttributes in = attributesOf(root);
    if (in.has("transform")) throw in.error("transform", "a transformation of the whole file is not supported");
    const auto side = [&](const char* name) {
        // Of what is around the file, which nobody knows.
        const bool isKnown = !in.text(name).ends_with('%');
        return isKnown ? in.length(name, 0, 0) : 0.;
    };
    const V2d size(side("width"), side("height"));
    if (!in.has("viewBox")) {
        scope.extent.size = size;
        return;
    }
    const Imath::Box2d box = in.read("viewBox", readSvgViewBox);
    scope.extent.size = box.size();
    if (!(size.x > 0) && !(size.y > 0)) return;
    // Where one side is missing it follows from the other.
    const V2d viewport(size.x > 0 ? size.x : size.y * box.size().x / box.size().y,
                       size.y > 0 ? size.y : size.x * box.size().y / box.size().x);
    const M33d fit =
        in.read("preserveAspectRatio", [&](std::string_view text) { return readSvgFit(text, box, viewport); });
    drawing_.millimetresPerUnit = V2d(fit[0][0], fit[1][1]) * millimetresPerPixel;
}

void SvgReader::openNested(const SvgAttributes& in, Scope& scope) {
    const V2d around = scope.extent.size;
    const V2d corner(in.length("x", around.x, 0), in.length("y", around.y, 0));
    const V2d viewport(in.length("width", around.x, around.x), in.length("height", around.y, around.y));
    if (!(viewport.x > 0) || !(viewport.y > 0))
        throw SvgTextError(in.offset(), in.nameLength(), "the width and height of a nested svg must be positive");
    M33d fit;
    scope.extent.size = viewport;
    if (in.has("viewBox")) {
        const Imath::Box2d box = in.read("viewBox", readSvgViewBox);
        fit = in.read("preserveAspectRatio", [&](std::string_view text) { return readSvgFit(text, box, viewport); });
        scope.extent.size = box.size();
    }
    fit[2][0] += corner.x;
    fit[2][1] += corner.y;
    scope.userFromLocal = fit * scope.userFromLocal;
}

void SvgReader::visitChildren(const pugi::xml_node& node, const Scope& scope) {
    for (const pugi::xml_node& child : node.children())
        visit(child, scope);
}

void SvgReader::visit(const pugi::xml_node& node, const Scope& parent) {
    const bool declares = std::any_of(node.attributes_begin(), node.attributes_end(), [](const auto& attribute) {
        return std::string_view(attribute.name()).starts_with("xmlns");
    });
    std::optional<Scope> own;
    if (declares) declareNamespaces(node, own.emplace(parent));
    const Scope& known = own ? *own : parent;
    const std::string_view tag = svgTag(node, known);
    if (tag.empty()) return;
    if (isSvgShape(tag)) return visitShape(tag, node, known);
    if (const std::string_view id = node.attribute("id").value(); !id.empty())
        drawing_.others.emplace(std::string(id), std::string(tag));
    const bool isUnrendered = isOneOf(tag, unrendered);
    if (!isUnrendered && !isOneOf(tag, containers)) return;

    if (!own) own.emplace(parent);
    Scope& scope = *own;
    const SvgAttributes in = attributesOf(node);
    if (++scope.depth > deepest)
        throw SceneError(lines_.at(in.offset(), in.nameLength()),
                         fmt::format("elements are nested more than {} deep", deepest));
    scope.rendered = scope.rendered && !isUnrendered && !isHidden(in);
    if (!scope.fault) try {
            scope.userFromLocal = ownTransform(in) * scope.userFromLocal;
            if (tag == "svg") openNested(in, scope);
        } catch (const SvgTextError& error) {
            scope.fault = diagnostic(error);
        }
    visitChildren(node, scope);
}

void SvgReader::visitShape(std::string_view tag, const pugi::xml_node& node, const Scope& scope) {
    const SvgAttributes in = attributesOf(node);
    SvgElement element;
    element.tag = tag;
    element.id = in.text("id");
    element.label = in.text("inkscape:label");
    element.place = lines_.at(in.offset(), in.nameLength());
    element.rendered = scope.rendered && !isHidden(in);
    element.fault = scope.fault;
    if (!element.fault) try {
            const M33d m = ownTransform(in) * scope.userFromLocal;
            element.path = transformedPath(readSvgShape(tag, in, scope.extent), m, in);
            if (element.path.subpaths.empty())
                throw SvgTextError(in.offset(), in.nameLength(), fmt::format("the {} draws nothing", tag));
        } catch (const SvgTextError& error) {
            element.path = {};
            element.fault = diagnostic(error);
        }
    drawing_.elements.push_back(std::move(element));
}

} // namespace vitrine
