#include "shapes/ply_writer.h"

#include "core/replace_file.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <stdexcept>

namespace vitrine {

namespace {

static_assert(std::endian::native == std::endian::little, "values are copied as they lie in memory");

std::string header(const MeshInput& mesh, const std::string& comment) {
    std::string text = "ply\nformat binary_little_endian 1.0\n";
    if (!comment.empty()) text += fmt::format("comment {}\n", comment);
    text += fmt::format("element vertex {}\n", mesh.p.size());
    const auto floats = [&](std::initializer_list<const char*> names) {
        for (const char* name : names)
            text += fmt::format("property float {}\n", name);
    };
    floats({"x", "y", "z"});
    if (!mesh.n.empty()) floats({"nx", "ny", "nz"});
    if (!mesh.uv.empty()) floats({"s", "t"});
    text +=
        fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", mesh.triangles.size() / 3);
    return text;
}

template <class T>
std::byte* put(std::byte* to, const T* values, std::size_t count) {
    std::memcpy(to, values, count * sizeof(T));
    return to + count * sizeof(T);
}

std::vector<std::byte> vertices(const MeshInput& mesh) {
    const std::size_t floats = 3 + (mesh.n.empty() ? 0 : 3) + (mesh.uv.empty() ? 0 : 2);
    std::vector<std::byte> bytes(mesh.p.size() * floats * sizeof(float));
    std::byte* to = bytes.data();
    for (std::size_t i = 0; i < mesh.p.size(); ++i) {
        to = put(to, &mesh.p[i].x, 3);
        if (!mesh.n.empty()) to = put(to, &mesh.n[i].x, 3);
        if (!mesh.uv.empty()) to = put(to, &mesh.uv[i].x, 2);
    }
    return bytes;
}

std::vector<std::byte> faces(const MeshInput& mesh) {
    std::vector<std::byte> bytes(mesh.triangles.size() / 3 * (1 + 3 * sizeof(std::uint32_t)));
    std::byte* to = bytes.data();
    constexpr std::uint8_t corners = 3;
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
        to = put(to, &corners, 1);
        to = put(to, &mesh.triangles[i], 3);
    }
    return bytes;
}

} // namespace

void writePly(const std::string& path, const MeshInput& mesh, const std::string& comment) {
    const auto fits = [&](const auto& values) { return values.empty() || values.size() == mesh.p.size(); };
    if (!mesh.quads.empty() || !mesh.s.empty() || mesh.triangles.size() % 3 != 0 || !fits(mesh.n) || !fits(mesh.uv))
        throw std::invalid_argument("a PLY file is written of triangles with one normal and one (u, v) a vertex");
    const std::string head = header(mesh, comment);
    const std::vector<std::byte> v = vertices(mesh), f = faces(mesh);
    replaceFile(path, {std::as_bytes(std::span(head)), v, f});
}

} // namespace vitrine
