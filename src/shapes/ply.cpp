#include "shapes/ply.h"

#include "core/errors.h"
#include "shapes/ply_header.h"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cstring>

namespace vitrine {

namespace {

template <class T>
T loadBinary(const char* bytes, bool swapped) {
    char ordered[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i)
        ordered[i] = bytes[swapped ? sizeof(T) - 1 - i : i];
    T value;
    std::memcpy(&value, ordered, sizeof(T));
    return value;
}

/// Values one after the other, whatever the format.
class ValueReader {
  public:
    ValueReader(PlyStream& stream, PlyFormat format)
        : stream_(&stream), text_(format == PlyFormat::Ascii),
          swapped_((format == PlyFormat::BigEndian) != (std::endian::native == std::endian::big)) {}

    double next(PlyType type) { return text_ ? nextWord() : decode(type, stream_->take(sizeOf(type))); }
    /// A list's length.
    std::uint64_t nextCount(PlyType type) {
        const double count = next(type);
        if (!(count >= 0 && count <= 0xffffffffu) || count != std::floor(count))
            stream_->fail(fmt::format("{} is no length of a list", count));
        return std::uint64_t(count);
    }
    void skip(const PlyProperty& property) {
        std::uint64_t count = property.isList ? nextCount(property.countType) : 1;
        for (; count > 0; --count)
            next(property.type);
    }

  private:
    double decode(PlyType type, const char* bytes) const {
        switch (type) {
        case PlyType::Int8:
            return loadBinary<std::int8_t>(bytes, swapped_);
        case PlyType::Uint8:
            return loadBinary<std::uint8_t>(bytes, swapped_);
        case PlyType::Int16:
            return loadBinary<std::int16_t>(bytes, swapped_);
        case PlyType::Uint16:
            return loadBinary<std::uint16_t>(bytes, swapped_);
        case PlyType::Int32:
            return loadBinary<std::int32_t>(bytes, swapped_);
        case PlyType::Uint32:
            return loadBinary<std::uint32_t>(bytes, swapped_);
        case PlyType::Float32:
            return loadBinary<float>(bytes, swapped_);
        case PlyType::Float64:
            return loadBinary<double>(bytes, swapped_);
        }
        return 0;
    }
    double nextWord() {
        std::string_view word = stream_->takeWord();
        if (word.starts_with('+')) word.remove_prefix(1);
        double value = 0;
        const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        // Too large, or too small to matter.
        const bool outOfRange = error == std::errc::result_out_of_range;
        if (outOfRange) value = word.find("e-") == word.npos && word.find("E-") == word.npos ? infinityD : 0;
        if ((error != std::errc() && !outOfRange) || stop != word.data() + word.size())
            stream_->fail(fmt::format("\"{}\" is not a number", word.substr(0, 40)));
        return value;
    }

    PlyStream* stream_;
    bool text_, swapped_;
};

/// Reads the elements one after the other into a mesh.
class PlyReader {
  public:
    explicit PlyReader(const std::string& file)
        : file_(file), stream_(file), header_(readPlyHeader(stream_)), values_(stream_, header_.format) {}

    MeshInput read();

  private:
    enum Target { None, X, Y, Z, NX, NY, NZ, U, V, TargetCount };

    const PlyElement& elementNamed(const char* name) const;
    /// How many elements to make room for: what the header promises, if the file can hold it.
    std::size_t room(const PlyElement& element);
    std::vector<Target> vertexTargets(const PlyElement& element);
    void readVertices(const PlyElement& element);
    void readFaces(const PlyElement& element);
    void readFace(const PlyProperty& list, std::uint64_t face, std::uint64_t facesLeft);
    void addFan(std::uint64_t face, const std::vector<std::uint32_t>& corners);
    void skip(const PlyElement& element);

    std::string file_;
    PlyStream stream_;
    PlyHeader header_;
    ValueReader values_;
    MeshInput mesh_;
    std::uint64_t vertexCount_ = 0;
    struct Polygon {
        std::uint64_t face;
        std::vector<std::uint32_t> corners;
    };
    std::vector<Polygon> polygons_; ///< made fans of when the vertices are known
    std::vector<std::uint32_t> corners_;
};

const PlyElement& PlyReader::elementNamed(const char* name) const {
    for (const PlyElement& element : header_.elements)
        if (element.name == name) {
            if (element.count == 0) throw FileError(file_, fmt::format("the number of elements \"{}\" is zero", name));
            if (element.count > std::numeric_limits<std::int32_t>::max())
                throw FileError(file_,
                                fmt::format("{} elements \"{}\" are more than a mesh can hold", element.count, name));
            return element;
        }
    throw FileError(file_, fmt::format("there is no element \"{}\"", name));
}

std::size_t PlyReader::room(const PlyElement& element) {
    const std::uint64_t bytes = std::max<std::uint64_t>(1, element.fewestBytes(header_.format));
    // The last word of a text needs no space behind it: hence one more.
    if (element.count > (stream_.mostBytesLeft() + 1) / bytes)
        stream_.fail(fmt::format("{} elements \"{}\" do not fit into the file", element.count, element.name));
    return std::size_t(std::min(element.count, stream_.likelyBytesLeft() / bytes + 1));
}

std::vector<PlyReader::Target> PlyReader::vertexTargets(const PlyElement& element) {
    std::vector<Target> targets(element.properties.size(), None);
    const auto assign = [&](std::initializer_list<std::pair<const char*, Target>> names) {
        for (const auto& [name, target] : names)
            if (const int i = element.find(name); i < 0 || element.properties[std::size_t(i)].isList) return false;
        for (const auto& [name, target] : names)
            targets[std::size_t(element.find(name))] = target;
        return true;
    };
    if (!assign({{"x", X}, {"y", Y}, {"z", Z}})) throw FileError(file_, "vertices lack x, y or z");
    const std::size_t count = room(element);
    mesh_.p.reserve(count + 1); // Embree wants one more
    if (assign({{"nx", NX}, {"ny", NY}, {"nz", NZ}})) mesh_.n.reserve(count);
    if (assign({{"u", U}, {"v", V}}) || assign({{"s", U}, {"t", V}}) || assign({{"texture_u", U}, {"texture_v", V}}) ||
        assign({{"texture_s", U}, {"texture_t", V}}))
        mesh_.uv.reserve(count);
    return targets;
}

void PlyReader::readVertices(const PlyElement& element) {
    const std::vector<Target> targets = vertexTargets(element);
    const auto has = [&](Target target) { return std::find(targets.begin(), targets.end(), target) != targets.end(); };
    const bool hasNormals = has(NX), hasUv = has(U);
    for (std::uint64_t vertex = 0; vertex < element.count; ++vertex) {
        float value[TargetCount] = {};
        for (std::size_t i = 0; i < targets.size(); ++i) {
            if (targets[i] == None) {
                values_.skip(element.properties[i]);
                continue;
            }
            const float read = float(values_.next(element.properties[i].type));
            if (!std::isfinite(read))
                stream_.fail(fmt::format("{} of vertex {} is not finite", element.properties[i].name, vertex));
            value[targets[i]] = read;
        }
        mesh_.p.emplace_back(value[X], value[Y], value[Z]);
        if (hasNormals) mesh_.n.emplace_back(value[NX], value[NY], value[NZ]);
        if (hasUv) mesh_.uv.emplace_back(value[U], value[V]);
    }
}

void PlyReader::readFaces(const PlyElement& element) {
    int list = element.find("vertex_indices");
    if (list < 0) list = element.find("vertex_index");
    if (list < 0 || !element.properties[std::size_t(list)].isList)
        throw FileError(file_, "faces have no list \"vertex_indices\"");
    room(element);
    for (std::uint64_t face = 0; face < element.count; ++face)
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            if (int(i) == list)
                readFace(element.properties[i], face, element.count - face);
            else
                values_.skip(element.properties[i]);
        }
}

void PlyReader::readFace(const PlyProperty& list, std::uint64_t face, std::uint64_t facesLeft) {
    const std::uint64_t count = values_.nextCount(list.countType);
    if (count < 3) stream_.fail(fmt::format("face {} has {} corners", face, count));
    corners_.clear();
    for (std::uint64_t i = 0; i < count; ++i) {
        const double index = values_.next(list.type);
        if (!(index >= 0 && index < double(vertexCount_)) || index != std::floor(index))
            stream_.fail(fmt::format("face {} names vertex {}, but there are {}", face, index, vertexCount_));
        corners_.push_back(std::uint32_t(index));
    }
    // Room for all, were they all of this kind; what is not touched costs nothing.
    const auto makeRoom = [&](std::vector<std::uint32_t>& indices) {
        const std::uint64_t fits = stream_.likelyBytesLeft() / sizeOf(list.type) + count;
        if (indices.empty()) indices.reserve(std::size_t(std::min(facesLeft * count, fits)));
    };
    if (count == 3) {
        makeRoom(mesh_.triangles);
        mesh_.triangles.insert(mesh_.triangles.end(), corners_.begin(), corners_.end());
    } else if (count == 4) {
        makeRoom(mesh_.quads);
        for (const int k : {0, 1, 3, 2}) // around the face, to (u,v) = 00 10 01 11
            mesh_.quads.push_back(corners_[std::size_t(k)]);
    } else {
        polygons_.push_back({face, corners_});
    }
}

/// Cuts a convex polygon into triangles about its first corner.
void PlyReader::addFan(std::uint64_t face, const std::vector<std::uint32_t>& corners) {
    const auto p = [&](std::size_t i) { return toDouble(mesh_.p[corners[i]]); };
    std::vector<V3d> normals;
    V3d sum(0, 0, 0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        normals.push_back((p(i) - p(0)).cross(p(i + 1) - p(0)));
        sum += normals.back();
    }
    for (const V3d& normal : normals)
        if (normal.dot(sum) < -1e-6 * normal.length() * sum.length())
            throw FileError(file_, fmt::format("face {} is a polygon of {} corners that is not convex: cut it into "
                                               "triangles",
                                               face, corners.size()));
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        mesh_.triangles.insert(mesh_.triangles.end(), {corners[0], corners[i], corners[i + 1]});
}

void PlyReader::skip(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i)
        for (const PlyProperty& property : element.properties)
            values_.skip(property);
}

MeshInput PlyReader::read() {
    vertexCount_ = elementNamed("vertex").count;
    elementNamed("face");
    if (header_.format != PlyFormat::Ascii) stream_.countBytes();
    for (const PlyElement& element : header_.elements) {
        if (element.name == "vertex")
            readVertices(element);
        else if (element.name == "face")
            readFaces(element);
        else
            skip(element);
    }
    if (!stream_.onlySpaceLeft()) stream_.fail("there is more data than the header says");
    for (const Polygon& polygon : polygons_)
        addFan(polygon.face, polygon.corners);
    return std::move(mesh_);
}

} // namespace

MeshInput readPly(const std::string& file) {
    return PlyReader(file).read();
}

} // namespace vitrine
