#include "shapes/mesh_topology.h"

#include <numeric>
#include <tuple>

namespace vitrine {

MeshTopology::MeshTopology(const MeshVertices& mesh) : mesh_(&mesh), welded_(mesh.count()) {
    std::vector<std::uint32_t> order(mesh.count());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) { return std::tuple(mesh.p[i].x, mesh.p[i].y, mesh.p[i].z); };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple_cat(key(a), std::tuple(a)) < std::tuple_cat(key(b), std::tuple(b));
    });
    for (std::size_t i = 0; i < order.size(); ++i)
        welded_[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? welded_[order[i - 1]] : order[i];
}

void MeshTopology::addFace(const std::uint32_t* corners, unsigned count) {
    // The volume is taken about a vertex of the mesh, so that it keeps its digits far from the origin.
    const V3d origin = toDouble(mesh_->p[0]);
    V3d areaVector(0, 0, 0), normals(0, 0, 0);
    double volume = 0;
    for (unsigned i = 0; i < count; ++i) {
        const std::uint32_t a = corners[i], b = corners[(i + 1) % count];
        if (welded_[a] != welded_[b]) edges_.push_back(std::uint64_t(welded_[a]) << 32 | welded_[b]);
        if (!mesh_->n.empty()) normals += toDouble(mesh_->n[a]);
        areaVector += (toDouble(mesh_->p[a]) - origin).cross(toDouble(mesh_->p[b]) - origin);
        if (i >= 1 && i + 1 < count) {
            const V3d p0 = toDouble(mesh_->p[corners[0]]) - origin;
            volume += p0.dot((toDouble(mesh_->p[a]) - origin).cross(toDouble(mesh_->p[b]) - origin));
        }
    }
    const bool turned = mesh_->n.empty() ? mesh_->flips : areaVector.dot(normals) < 0;
    volume_ += turned ? -volume : volume;
}

bool MeshTopology::isClosedOutward() {
    std::sort(edges_.begin(), edges_.end());
    if (edges_.empty() || std::adjacent_find(edges_.begin(), edges_.end()) != edges_.end()) return false;
    for (const std::uint64_t edge : edges_)
        if (!std::binary_search(edges_.begin(), edges_.end(), edge << 32 | edge >> 32)) return false;
    return volume_ > 0;
}

} // namespace vitrine
