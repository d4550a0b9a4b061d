#include "shapes/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace vitrine {

namespace {

/// The words of a header line.
std::vector<std::string_view> wordsOf(std::string_view line) {
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t begin = line.find_first_not_of(" \t");
        if (begin == std::string_view::npos) return words;
        line.remove_prefix(begin);
        const std::size_t length = std::min(line.find_first_of(" \t"), line.size());
        words.push_back(line.substr(0, length));
        line.remove_prefix(length);
    }
}

PlyType typeOf(std::string_view word, PlyStream& stream) {
    constexpr std::pair<std::string_view, PlyType> types[] = {
        {"char", PlyType::Int8},      {"uchar", PlyType::Uint8},    {"short", PlyType::Int16},
        {"ushort", PlyType::Uint16},  {"int", PlyType::Int32},      {"uint", PlyType::Uint32},
        {"float", PlyType::Float32},  {"double", PlyType::Float64}, {"int8", PlyType::Int8},
        {"uint8", PlyType::Uint8},    {"int16", PlyType::Int16},    {"uint16", PlyType::Uint16},
        {"int32", PlyType::Int32},    {"uint32", PlyType::Uint32},  {"float32", PlyType::Float32},
        {"float64", PlyType::Float64}};
    for (const auto& [name, type] : types)
        if (word == name) return type;
    stream.fail(fmt::format("\"{}\" is no type of PLY's", word));
}

PlyFormat formatOf(const std::vector<std::string_view>& words, PlyStream& stream) {
    if (words.size() == 3 && words[2] == "1.0") {
        if (words[1] == "ascii") return PlyFormat::Ascii;
        if (words[1] == "binary_little_endian") return PlyFormat::LittleEndian;
        if (words[1] == "binary_big_endian") return PlyFormat::BigEndian;
    }
    stream.fail("the format is neither ascii, binary_little_endian nor binary_big_endian, version 1.0");
}

PlyElement elementOf(const std::vector<std::string_view>& words, const PlyHeader& header, PlyStream& stream) {
    if (words.size() != 3) stream.fail("expected \"element\", a name and a number");
    PlyElement element;
    element.name = words[1];
    const char* end = words[2].data() + words[2].size();
    const auto [stop, error] = std::from_chars(words[2].data(), end, element.count);
    if (error != std::errc() || stop != end) stream.fail(fmt::format("\"{}\" is no number of elements", words[2]));
    for (const PlyElement& other : header.elements)
        if (other.name == element.name) stream.fail(fmt::format("a second element \"{}\"", element.name));
    return element;
}

void addProperty(const std::vector<std::string_view>& words, PlyHeader& header, PlyStream& stream) {
    if (header.elements.empty()) stream.fail("a property of no element");
    PlyProperty property;
    if (words.size() == 5 && words[1] == "list") {
        property.isList = true;
        property.countType = typeOf(words[2], stream);
        if (property.countType >= PlyType::Float32) stream.fail("a list's length must be an integer");
    } else if (words.size() != 3) {
        stream.fail("expected \"property\", a type and a name");
    }
    property.type = typeOf(words[words.size() - 2], stream);
    property.name = words.back();
    PlyElement& element = header.elements.back();
    if (element.find(property.name) >= 0)
        stream.fail(fmt::format("a second property \"{}\" of \"{}\"", property.name, element.name));
    element.properties.push_back(std::move(property));
}

} // namespace

int PlyElement::find(std::string_view property) const {
    for (std::size_t i = 0; i < properties.size(); ++i)
        if (properties[i].name == property) return int(i);
    return -1;
}

std::uint64_t PlyElement::fewestBytes(PlyFormat format) const {
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : properties)
        bytes += format == PlyFormat::Ascii ? 2 : sizeOf(property.isList ? property.countType : property.type);
    return bytes;
}

PlyHeader readPlyHeader(PlyStream& stream) {
    /// A header with more has no end.
    constexpr int mostElements = 1000;
    if (stream.peek() != 'p' || stream.takeLine() != "ply")
        stream.fail("not a PLY file: it does not begin with \"ply\"");
    PlyHeader header;
    bool hasFormat = false;
    while (true) {
        const std::string line(stream.takeLine());
        const std::vector<std::string_view> words = wordsOf(line);
        const std::string_view keyword = words.empty() ? std::string_view() : words[0];
        if (keyword == "end_header") break;
        if (keyword.empty() || keyword == "comment" || keyword == "obj_info") continue;
        if (keyword == "format") {
            header.format = formatOf(words, stream);
            hasFormat = true;
        } else if (keyword == "element") {
            header.elements.push_back(elementOf(words, header, stream));
            if (header.elements.size() > mostElements) stream.fail("too many elements");
        } else if (keyword == "property") {
            addProperty(words, header, stream);
            if (header.elements.back().properties.size() > mostElements) stream.fail("too many properties");
        } else {
            stream.fail(fmt::format("\"{}\" means nothing in a PLY header", keyword.substr(0, 40)));
        }
    }
    if (!hasFormat) stream.fail("the header names no format");
    return header;
}

} // namespace vitrine
