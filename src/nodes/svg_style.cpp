#include "nodes/svg_style.h"

#include <algorithm>
#include <cctype>

namespace vitrine {

namespace {

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
constexpr std::string_view pageProperties[] = {"x", "y", "width", "height"};
/// At-rules whose content is rules like those outside.
constexpr std::string_view conditions[] = {"@media", "@supports", "@layer", "@container", "@scope"};
constexpr std::string_view blanks = " \t\r\n\f";

template <std::size_t N>
bool isOneOf(std::string_view word, const std::string_view (&words)[N]) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

std::string_view trimmed(std::string_view s) {
    s.remove_prefix(std::min(s.find_first_not_of(blanks), s.size()));
    return s.substr(0, s.find_last_not_of(blanks) + 1);
}

std::string lowered(std::string_view s) {
    std::string result(s);
    std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return std::tolower(c); });
    return result;
}

bool isGeometry(std::string_view name) {
    return isOneOf(lowered(name), geometryProperties);
}

/// Calls visit(name, value) for each declaration.
template <class Visit>
void forEachProperty(std::string_view declarations, Visit&& visit) {
    while (!declarations.empty()) {
        const std::string_view declaration = declarations.substr(0, declarations.find(';'));
        declarations.remove_prefix(std::min(declarations.size(), declaration.size() + 1));
        const std::size_t colon = declaration.find(':');
        if (colon != std::string_view::npos)
            visit(trimmed(declaration.substr(0, colon)), trimmed(declaration.substr(colon + 1)));
    }
}

/// Comments and strings become blanks: no brace, comma or semicolon in them counts.
std::string withoutCommentsAndStrings(std::string_view css) {
    std::string text(css);
    for (std::size_t i = 0; i < text.size();) {
        const bool isComment = text.compare(i, 2, "/*") == 0;
        if (!isComment && text[i] != '"' && text[i] != '\'') {
            ++i;
            continue;
        }
        const std::size_t close = isComment ? text.find("*/", i + 2) : text.find(text[i], i + 1);
        const std::size_t end = close == std::string::npos ? text.size() : close + (isComment ? 2 : 1);
        std::fill(text.begin() + std::ptrdiff_t(i), text.begin() + std::ptrdiff_t(end), ' ');
        i = end;
    }
    return text;
}

/// Past the brace that closes the block whose content begins at `from`.
std::size_t endOfBlock(std::string_view css, std::size_t from) {
    int depth = 1;
    for (; from < css.size() && depth > 0; ++from)
        depth += css[from] == '{' ? 1 : css[from] == '}' ? -1 : 0;
    return from;
}

/// What stands behind the last combinator, brackets and parentheses emptied.
std::string lastCompound(std::string_view selector) {
    std::string compound;
    int depth = 0;
    for (const char c : trimmed(selector)) {
        if (c == ')' || c == ']') --depth;
        if (depth == 0 && (blanks.find(c) != std::string_view::npos || c == '>' || c == '+' || c == '~'))
            compound.clear();
        else if (depth == 0)
            compound += c;
        if (c == '(' || c == '[') ++depth;
    }
    return compound;
}

/// The parts of `path.a.b#c:hover`.
SvgStyleSheets::Rule ruleFor(std::string_view selector) {
    SvgStyleSheets::Rule rule{};
    const std::string compound = lastCompound(selector);
    if (compound.find('\\') != std::string::npos) return rule; // an escaped name: anything
    for (std::size_t i = 0; i < compound.size();) {
        const std::size_t end = std::min(compound.find_first_of(".#:[", i + 1), compound.size());
        const std::string_view part = std::string_view(compound).substr(i, end - i);
        const std::string_view name = part.substr(1);
        if (part[0] == '.')
            rule.classes.emplace_back(name);
        else if (part[0] == '#')
            rule.id = name;
        else if (part[0] != ':' && part[0] != '[' && part != "*")
            rule.tag = part.substr(part.rfind('|') + 1);
        i = end;
    }
    return rule;
}

bool hasWord(std::string_view list, std::string_view word) {
    while (!list.empty()) {
        list.remove_prefix(std::min(list.find_first_not_of(blanks), list.size()));
        const std::string_view first = list.substr(0, list.find_first_of(blanks));
        if (first == word) return true;
        list.remove_prefix(first.size());
    }
    return false;
}

} // namespace

std::string_view geometryProperty(std::string_view declarations) {
    std::string_view found;
    forEachProperty(declarations, [&](std::string_view name, std::string_view) {
        if (found.empty() && isGeometry(name)) found = name;
    });
    return found;
}

bool isHiddenBy(std::string_view declarations, bool before) {
    bool hidden = before;
    forEachProperty(declarations, [&](std::string_view name, std::string_view value) {
        if (name == "display") hidden = value.starts_with("none");
    });
    return hidden;
}

bool SvgStyleSheets::add(std::string_view css, std::size_t offset) {
    const std::string text = withoutCommentsAndStrings(css);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t stop = text.find_first_of("{};", at);
        if (stop == std::string::npos) break;
        const std::string_view prelude = trimmed(std::string_view(text).substr(at, stop - at));
        at = stop + 1;
        if (text[stop] != '{') continue;
        if (prelude.starts_with('@')) {
            if (!isOneOf(prelude.substr(0, prelude.find_first_of(" \t\r\n\f({")), conditions))
                at = endOfBlock(text, at);
            continue;
        }
        const std::size_t end = endOfBlock(text, at);
        addRules(prelude, std::string_view(text).substr(at, end - at - (text[end - 1] == '}')), offset + at);
        at = end;
        if (rules_.size() > mostRules) return false;
    }
    return true;
}

void SvgStyleSheets::addRules(std::string_view selectors, std::string_view declarations, std::size_t offset) {
    forEachProperty(declarations, [&](std::string_view name, std::string_view) {
        if (!isGeometry(name)) return;
        for (std::string_view rest = selectors; !rest.empty() && rules_.size() <= mostRules;) {
            const std::string_view selector = rest.substr(0, rest.find(','));
            rest.remove_prefix(std::min(rest.size(), selector.size() + 1));
            Rule& rule = rules_.emplace_back(ruleFor(selector));
            rule.property = lowered(name);
            rule.offset = offset + std::size_t(name.data() - declarations.data());
            rule.length = name.size();
        }
    });
}

const SvgStyleSheets::Rule* SvgStyleSheets::find(std::string_view tag, std::string_view id, std::string_view classNames,
                                                 bool isOutermost) const {
    for (const Rule& rule : rules_)
        if ((rule.tag.empty() || rule.tag == tag) && (rule.id.empty() || rule.id == id) &&
            !(isOutermost && isOneOf(rule.property, pageProperties)) &&
            std::all_of(rule.classes.begin(), rule.classes.end(),
                        [&](const std::string& name) { return hasWord(classNames, name); }))
            return &rule;
    return nullptr;
}

} // namespace vitrine
