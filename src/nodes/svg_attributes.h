// The attributes of one SVG element, with errors that know their byte in the file.
#pragma once

#include "nodes/svg_path.h"

#include <pugixml.hpp>
#include <string_view>

namespace vitrine {

class SvgAttributes {
  public:
    /// \param original the file's text; \param parsed the buffer in which pugixml works, as long as the text
    SvgAttributes(const pugi::xml_node& node, std::string_view original, const char* parsed)
        : node_(node), original_(original), parsed_(parsed) {}

    bool has(const char* name) const { return bool(node_.attribute(name)); }
    /// The value, "" when it is not given.
    std::string_view text(const char* name) const { return node_.attribute(name).value(); }
    /// What `read` makes of the value. Its errors are moved to bytes of the file.
    template <class Read>
    auto read(const char* name, Read&& read) const {
        try {
            return read(text(name));
        } catch (const SvgTextError& error) {
            throw moved(name, error);
        }
    }
    double length(const char* name, double hundredPercent, double fallback) const;
    /// For each byte of a value, and its end, where it stands in the file: pugixml has shortened character references.
    std::vector<std::size_t> offsetsInFile(const char* name) const;
    /// An error about the whole of a value.
    SvgTextError error(const char* name, const std::string& message, const std::string& hint = {}) const;
    /// Byte of the element's name.
    std::size_t offset() const { return std::size_t(node_.offset_debug()); }
    /// Its bytes.
    std::size_t nameLength() const { return std::string_view(node_.name()).size(); }

  private:
    SvgTextError moved(const char* name, const SvgTextError& error) const;

    pugi::xml_node node_;
    std::string_view original_;
    const char* parsed_;
};

} // namespace vitrine
