// What a PLY file says about itself.
#pragma once

#include "shapes/ply_stream.h"

namespace vitrine {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

/// Bytes of a binary value.
constexpr std::size_t sizeOf(PlyType type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[int(type)];
}

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    bool isList = false;
    PlyType countType = PlyType::Uint8; ///< of lists
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// The number of the property, or -1.
    int find(std::string_view property) const;
    /// The fewest bytes that one element takes.
    std::uint64_t fewestBytes(PlyFormat format) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
};

/// Reads up to and with "end_header". \throws FileError
PlyHeader readPlyHeader(PlyStream& stream);

} // namespace vitrine
