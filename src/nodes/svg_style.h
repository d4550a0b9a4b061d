// What matters of CSS for outlines: whether a style would move one, or hides an element. Everything else is passed over.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// The first property of a list of declarations that would move or change an outline (transform, d, x ...); "" if none.
std::string_view geometryProperty(std::string_view declarations);

/// Whether the declarations say `display: none` in the end; `before` when they say nothing.
bool isHiddenBy(std::string_view declarations, bool before);

/// The style sheets of a file: those of their rules that would move outlines.
class SvgStyleSheets {
  public:
    struct Rule {
        std::string property;
        std::size_t offset, length; ///< of the property's name in the file

        /// What the right end of the selector asks for; empty: anything. What is left of it, attributes and
        /// pseudo-classes are not looked at: then the rule counts as one that may hold.
        std::string tag, id;
        std::vector<std::string> classes;
    };
    static constexpr std::size_t mostRules = 1000;

    /// \param offset of the text's first byte in the file
    /// \return whether there is room for all of its rules
    bool add(std::string_view css, std::size_t offset);
    bool empty() const { return rules_.empty(); }
    /// The first rule that may hold for an element, or none.
    /// \param isOutermost the svg element itself, whose place and size are the page's
    const Rule* find(std::string_view tag, std::string_view id, std::string_view classNames, bool isOutermost) const;

  private:
    void addRules(std::string_view selectors, std::string_view declarations, std::size_t offset);

    std::vector<Rule> rules_;
};

} // namespace vitrine
