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

template <std::size_t N>
bool isOneOf(std::string_view word, const std::string_view (&words)[N]) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

/// The values of `<!ENTITY name "value">` in what stands before the first element.
std::map<std::string, std::string, std::less<>> entitiesIn(std::string_view prolog) {
    constexpr std::string_view mark = "<!ENTITY", blanks = " \t\r\n";
    std::map<std::string, std::string, std::less<>> entities;
    for (auto at = prolog.find(mark); at != std::string_view::npos; at = prolog.find(mark, at + 1)) {
        const auto name = prolog.find_first_not_of(blanks, at + mark.size());
        const auto nameEnd = prolog.find_first_of(blanks, name);
        const auto quote = prolog.find_first_not_of(blanks, nameEnd);
        if (quote == std::string_view::npos || (prolog[quote] != '"' && prolog[quote] != '\'')) continue;
        const auto end = prolog.find(prolog[quote], quote + 1);
        if (end == std::string_view::npos) break;
        entities.emplace(prolog.substr(name, nameEnd - name), prolog.substr(quote + 1, end - quote - 1));
    }
    return entities;
}

/// "name" of "&name;" alone, else "".
std::string_view referredEntity(std::string_view value) {
    const bool isReference = value.size() > 2 && value.front() == '&' && value.find(';') == value.size() - 1;
    return isReference ? value.substr(1, value.size() - 2) : std::string_view();
}

/// The element's own transformation.
M33d ownTransform(const SvgAttributes& in) {
    if (in.has("transform-origin")) throw in.error("transform-origin", "\"transform-origin\" is not supported");
    const M33d m = in.read("transform", readSvgTransform);
    const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    if (!std::isfinite(determinant) || !std::isfinite(m[2][0]) || !std::isfinite(m[2][1]) || determinant == 0)
        throw in.error("transform", "the transformation is singular or too large");
    return m;
}

/// Gathers the style sheets of a document.
struct StyleCollector : pugi::xml_tree_walker {
    explicit StyleCollector(SvgStyleSheets& to) : sheets(to) {}
    bool for_each(pugi::xml_node& node) override {
        const std::string_view name = node.name();
        if (name.substr(name.rfind(':') + 1) != "style") return true;
        for (const pugi::xml_node& text : node.children())
            if (!text.first_child() && !sheets.add(text.value(), std::size_t(text.offset_debug()))) {
                overflow = node;
                return false;
            }
        return true;
    }
    SvgStyleSheets& sheets;
    pugi::xml_node overflow;
};

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
    const pugi::xml_parse_result result = document_.load_buffer_inplace(
        buffer_.data(), buffer_.size(), pugi::parse_escapes | pugi::parse_cdata, pugi::encoding_utf8);
    if (!result) {
        std::string what = result.description();
        what[0] = char(std::tolower(static_cast<unsigned char>(what[0])));
        throw SceneError(lines_.at(std::size_t(result.offset), 1), "the file is not well-formed XML: " + what);
    }
    const pugi::xml_node root = document_.document_element();
    entities_ = entitiesIn(std::string_view(drawing_.file->text).substr(0, std::size_t(root.offset_debug())));
    Scope scope;
    declareNamespaces(root, scope);
    if (svgTag(root, scope) != "svg") throw notSvg(root);
    collectStyles();
    try {
        openOutermost(root, scope);
    } catch (const SvgTextError& error) {
        throw SceneError({diagnostic(error)});
    }
    visitChildren(root, scope);
    return std::move(drawing_);
}

SceneError SvgReader::notSvg(const pugi::xml_node& root) {
    const std::string_view name = root.name();
    const std::size_t colon = name.find(':');
    const std::string declaration(colon == std::string_view::npos ? "xmlns"
                                                                  : "xmlns:" + std::string(name.substr(0, colon)));
    const Place place = lines_.at(std::size_t(root.offset_debug()), name.size());
    const std::string_view space = root.attribute(declaration.c_str()).value();
    if (name.substr(colon + 1) != "svg" || space.empty())
        return SceneError(place, fmt::format("the file is no SVG: it begins with {}", inQuotes(name)));
    const std::string hint = fmt::format("SVG's is {}=\"{}\"", declaration, svgNamespace);
    const std::string_view entity = referredEntity(space);
    if (!entity.empty() && !entities_.contains(entity))
        return SceneError(
            place, fmt::format("the namespace is the entity {}, which the file does not define", inQuotes(space)),
            hint);
    return SceneError(place, fmt::format("the file is no SVG: its namespace is {}", inQuotes(resolved(space))), hint);
}

std::string_view SvgReader::resolved(std::string_view value) const {
    const auto entity = entities_.find(referredEntity(value));
    return entity == entities_.end() ? value : std::string_view(entity->second);
}

void SvgReader::collectStyles() {
    StyleCollector collector(sheets_);
    document_.traverse(collector);
    if (collector.overflow)
        throw SceneError(
            lines_.at(std::size_t(collector.overflow.offset_debug()), 5),
            fmt::format("more than {} rules of the style sheets would move outlines", SvgStyleSheets::mostRules));
}

std::vector<std::string_view> SvgReader::stylesOf(const SvgAttributes& in) const {
    std::string_view style = in.text("style");
    std::vector<std::string_view> styles{style};
    for (auto at = style.find('&'); at != std::string_view::npos; at = style.find('&', at + 1))
        if (const auto entity = entities_.find(style.substr(at + 1, style.find(';', at) - at - 1));
            entity != entities_.end())
            styles.push_back(entity->second);
    return styles;
}

bool SvgReader::isHidden(const SvgAttributes& in) const {
    bool hidden = in.text("display").find("none") != std::string_view::npos;
    for (const std::string_view style : stylesOf(in))
        hidden = isHiddenBy(style, hidden);
    return hidden;
}

void SvgReader::refuseMovingStyles(std::string_view tag, const SvgAttributes& in, bool isOutermost) const {
    constexpr const char* remedy = "write it as an attribute of the element";
    if (!isOutermost)
        for (const std::string_view style : stylesOf(in))
            if (const auto name = geometryProperty(style); !name.empty())
                throw in.error("style", fmt::format("\"{}\" in a style is not supported", name), remedy);
    if (sheets_.empty()) return;
    if (const auto* rule = sheets_.find(tag, in.text("id"), in.text("class"), isOutermost))
        throw SvgTextError(rule->offset, rule->length,
                           fmt::format("\"{}\" in a style sheet is not supported", rule->property), remedy);
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
        const bool isSvg = resolved(attribute.value()) == svgNamespace;
        if (isSvg) scope.prefixes.push_back(prefix);
        if (scope.prefixes.size() > mostPrefixes)
            throw SceneError(lines_.at(std::size_t(node.offset_debug()), 1),
                             fmt::format("more than {} prefixes for SVG's namespace", mostPrefixes));
        scope.namespaceKnown |= prefix.empty() || isSvg;
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
    refuseMovingStyles("svg", in, true);
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
            refuseMovingStyles(tag, in);
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
            refuseMovingStyles(tag, in);
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
