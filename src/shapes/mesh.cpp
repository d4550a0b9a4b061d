#include "shapes/mesh.h"

#include "shapes/mesh_topology.h"

namespace vitrine {

Box3d MeshShape::bounds(unsigned prim) const {
    Box3d box;
    const std::uint32_t* v = face(prim);
    for (unsigned i = 0; i < verticesPerFace(); ++i)
        box.extendBy(corner(v[i]));
    return box;
}

const MeshShape::Areas& MeshShape::areas() const {
    std::call_once(areasMade_, [&] {
        std::vector<double> each(primitiveCount());
        for (unsigned prim = 0; prim < primitiveCount(); ++prim) {
            each[prim] = primitiveArea(prim);
            areas_.total += each[prim];
        }
        if (primitiveCount() > 1) areas_.table = AliasTable(each);
    });
    return areas_;
}

unsigned MeshShape::drawPrimitive(V2f& u) const {
    if (primitiveCount() == 1) return 0;
    return unsigned(areas().table.sample(u.x, &u.x).index);
}

double MeshShape::drawProbability(unsigned prim) const {
    return primitiveCount() == 1 ? 1 : areas().table.probability(int(prim));
}

bool MeshShape::isClosed() const {
    std::call_once(closedKnown_, [&] {
        MeshTopology topology(mesh());
        for (unsigned prim = 0; prim < primitiveCount(); ++prim) {
            std::uint32_t corners[4];
            outline(prim, corners);
            topology.addFace(corners, verticesPerFace());
        }
        closed_ = topology.isClosedOutward();
    });
    return closed_;
}

std::size_t MeshShape::memoryBytes() const {
    const std::size_t vertexBytes = mesh().p.capacity() * sizeof(V3f) + mesh().n.capacity() * sizeof(V3f) +
                                    mesh().s.capacity() * sizeof(V3f) + mesh().uv.capacity() * sizeof(V2f);
    // Shared vertices are counted once over all that share them.
    return sizeof(*this) + indices_.capacity() * sizeof(std::uint32_t) +
           vertexBytes / std::size_t(std::max(1l, vertices_.use_count()));
}

} // namespace vitrine
