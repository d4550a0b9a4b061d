// Goes through the elements of an SVG file.
#pragma once

#include "nodes/svg_attributes.h"
#include "nodes/svg_coordinates.h"
#include "nodes/svg_file.h"
#include "nodes/svg_style.h"

namespace vitrine {

/// Places of ascending bytes of a text, without counting its lines from the start each time.
class LineCounter {
  public:
    explicit LineCounter(std::shared_ptr<const SourceFile> file) : file_(std::move(file)) {}
    Place at(std::size_t offset, std::size_t length);

  private:
    std::shared_ptr<const SourceFile> file_;
    std::size_t line_ = 1, lineStart_ = 0, counted_ = 0;
};

class SvgReader {
  public:
    explicit SvgReader(const std::shared_ptr<const SourceFile>& file);
    /// \throws SceneError
    SvgDrawing read();

  private:
    /// What an element has from its ancestors.
    struct Scope {
        M33d userFromLocal;
        SvgExtent extent;
        std::vector<std::string> prefixes; ///< of SVG's namespace; "" where it needs none
        bool namespaceKnown = false;       ///< false in a file that declares none: then "" is SVG's
        bool rendered = true;
        std::optional<Diagnostic> fault;
        int depth = 0;
    };

    void visitChildren(const pugi::xml_node& node, const Scope& scope);
    void visit(const pugi::xml_node& node, const Scope& parent);
    void visitShape(std::string_view tag, const pugi::xml_node& node, const Scope& scope);
    void openOutermost(const pugi::xml_node& root, Scope& scope);
    void openNested(const SvgAttributes& in, Scope& scope);
    void declareNamespaces(const pugi::xml_node& node, Scope& scope);
    /// The name without its prefix, "" when it is not SVG's.
    std::string_view svgTag(const pugi::xml_node& node, const Scope& scope) const;
    SceneError notSvg(const pugi::xml_node& root);
    /// The value of an entity of the file's DOCTYPE where a text is a reference to one and nothing else.
    std::string_view resolved(std::string_view value) const;
    void collectStyles();
    /// The style attribute, and the entities that it refers to.
    std::vector<std::string_view> stylesOf(const SvgAttributes& in) const;
    bool isHidden(const SvgAttributes& in) const;
    /// \throws SvgTextError for a style that would move the element's outline, its own or a sheet's
    void refuseMovingStyles(std::string_view tag, const SvgAttributes& in, bool isOutermost = false) const;
    SvgAttributes attributesOf(const pugi::xml_node& node) const;
    Diagnostic diagnostic(const SvgTextError& error);

    SvgDrawing drawing_;
    std::string buffer_; ///< pugixml works in it, and shortens references there
    pugi::xml_document document_;
    std::map<std::string, std::string, std::less<>> entities_;
    SvgStyleSheets sheets_;
    LineCounter lines_;
};

} // namespace vitrine
