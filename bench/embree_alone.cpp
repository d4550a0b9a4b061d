// What Embree itself needs for a mesh: builds it with nothing but Embree and prints bytes as JSON. With --write FILE it
// makes the mesh and writes it as a binary PLY instead. See memory_ply.py.
#include <embree3/rtcore.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace {

struct Mesh {
    std::vector<float> vertices; ///< with the 16 bytes that Embree wants to read at the last
    std::vector<std::uint32_t> indices;
    std::size_t vertexCount = 0;
};

/// A square of side x side cells with hills of several sizes: 2 side^2 triangles.
Mesh hills(std::size_t side) {
    Mesh mesh;
    mesh.vertexCount = (side + 1) * (side + 1);
    mesh.vertices.reserve(3 * mesh.vertexCount + 1);
    mesh.indices.reserve(6 * side * side);
    for (std::size_t j = 0; j <= side; ++j)
        for (std::size_t i = 0; i <= side; ++i) {
            const float x = 2 * float(i) / float(side) - 1, y = 2 * float(j) / float(side) - 1;
            const float z = 0.2f * std::sin(5 * x) * std::cos(4 * y) + 0.002f * std::sin(300 * x) * std::sin(280 * y);
            mesh.vertices.insert(mesh.vertices.end(), {x, y, z});
        }
    mesh.vertices.push_back(0);
    for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i) {
            const auto a = std::uint32_t(j * (side + 1) + i), b = std::uint32_t(a + side + 1);
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, b, a + 1, b + 1, b});
        }
    return mesh;
}

void writePly(const Mesh& mesh, const std::string& file) {
    std::ofstream out(file, std::ios::binary);
    const std::size_t faces = mesh.indices.size() / 3;
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.vertexCount
        << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << faces
        << "\nproperty list uchar int vertex_indices\nend_header\n";
    out.write(reinterpret_cast<const char*>(mesh.vertices.data()), std::streamsize(12 * mesh.vertexCount));
    char face[13] = {3};
    for (std::size_t i = 0; i < faces; ++i) {
        std::memcpy(face + 1, &mesh.indices[3 * i], 12);
        out.write(face, sizeof face);
    }
    out.close();
    if (!out) throw std::runtime_error("cannot write " + file);
}

std::atomic<std::ptrdiff_t> held{0}, mostHeld{0};

bool countBytes(void*, ssize_t change, bool) {
    const std::ptrdiff_t now = held += change;
    for (std::ptrdiff_t most = mostHeld; now > most && !mostHeld.compare_exchange_weak(most, now);) {
    }
    return true;
}

/// Builds with the flags and the quality that src/accel asks for.
void buildAndTell(const Mesh& mesh) {
    RTCDevice device = rtcNewDevice("ignore_config_files=1");
    if (!device) throw std::runtime_error("Embree cannot start on this machine");
    rtcSetDeviceMemoryMonitorFunction(device, countBytes, nullptr);
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.vertices.data(), 0, 12,
                               mesh.vertexCount);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.indices.data(), 0, 12,
                               mesh.indices.size() / 3);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::runtime_error("Embree could not build the mesh");
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::printf("{\"triangles\": %zu, \"bufferBytes\": %zu, \"embreeBytes\": %td, \"embreePeakBytes\": %td, "
                "\"peakMemoryBytes\": %zu}\n",
                mesh.indices.size() / 3, 4 * (mesh.vertices.size() + mesh.indices.size()), held.load(), mostHeld.load(),
                std::size_t(usage.ru_maxrss) * 1024);
    rtcReleaseGeometry(geometry);
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2 && !(argc == 4 && std::string(argv[2]) == "--write")) {
        std::fprintf(stderr, "usage: bench_embree_alone CELLS_A_SIDE [--write FILE.ply]\n");
        return 1;
    }
    try {
        const Mesh mesh = hills(std::size_t(std::stoul(argv[1])));
        if (argc == 4)
            writePly(mesh, argv[3]);
        else
            buildAndTell(mesh);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "bench_embree_alone: %s\n", e.what());
        return 1;
    }
    return 0;
}
