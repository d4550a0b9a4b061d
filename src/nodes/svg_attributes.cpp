#include "nodes/svg_attributes.h"

#include "nodes/svg_coordinates.h"

#include <algorithm>
#include <functional>

namespace vitrine {

namespace {

/// Bytes of a UTF-8 character by its first.
std::size_t characterLength(char lead) {
    const auto c = static_cast<unsigned char>(lead);
    return c < 0xc0 ? 1 : c < 0xe0 ? 2 : c < 0xf0 ? 3 : 4;
}

} // namespace

double SvgAttributes::length(const char* name, double hundredPercent, double fallback) const {
    if (!has(name) || text(name) == "auto") return fallback;
    return read(name, [&](std::string_view value) { return readSvgLength(value, hundredPercent); });
}

std::vector<std::size_t> SvgAttributes::offsetsInFile(const char* name) const {
    const std::string_view value = text(name);
    // An attribute that is not there has no place of its own.
    if (std::less<>()(value.data(), parsed_) || !std::less<>()(value.data(), parsed_ + original_.size()))
        return {offset()};
    std::vector<std::size_t> offsets;
    offsets.reserve(value.size() + 1);
    std::size_t at = std::size_t(value.data() - parsed_);
    while (offsets.size() < value.size()) {
        const char next = value[offsets.size()];
        // What pugixml does not know it leaves as it is.
        const std::size_t semicolon =
            original_[at] == '&' ? original_.substr(at, 12).find(';') : std::string_view::npos;
        const std::string_view reference = original_.substr(at, semicolon);
        const bool isAmpersand = reference == "&amp" || reference == "&#38" || reference == "&#x26";
        const bool isReference = semicolon != std::string_view::npos && (next != '&' || isAmpersand);
        offsets.insert(offsets.end(), isReference ? characterLength(next) : 1, at);
        at += isReference ? semicolon + 1 : 1;
    }
    offsets.resize(value.size());
    offsets.push_back(at);
    return offsets;
}

SvgTextError SvgAttributes::moved(const char* name, const SvgTextError& error) const {
    const std::vector<std::size_t> offsets = offsetsInFile(name);
    const std::size_t last = offsets.size() - 1;
    const std::size_t begin = offsets[std::min(error.offset, last)];
    const std::size_t end = offsets[std::min(error.offset + error.length, last)];
    return SvgTextError(begin, std::max(begin + 1, end) - begin, error.what(), error.hint);
}

SvgTextError SvgAttributes::error(const char* name, const std::string& message, const std::string& hint) const {
    return moved(name, SvgTextError(0, std::max<std::size_t>(1, text(name).size()), message, hint));
}

} // namespace vitrine
