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

std::optional<ShapeSample> MeshShape::sampleOn(unsigned prim, double probability, const V2f& u) const {
    const PrimitiveHit hit = drawPoint(prim, u);
    const auto pdf = float(density(probability, hit));
    if (!(pdf > 0) || !std::isfinite(pdf)) return std::nullopt;
    return ShapeSample{pointAt(Ray{}, hit), pdf};
}

std::optional<ShapeSample> MeshShape::sample(const V2f& u) const {
    V2f within = u;
    const unsigned prim = drawPrimitive(within);
    return sampleOn(prim, drawProbability(prim), within);
}

ShapePart MeshShape::part(unsigned part) const {
    ShapePart result{bounds(part), primitiveArea(part), {}};
    // Given normals say which side of a flat primitive is out. They are mixed from those at the corners: where these
    // agree, so do all.
    const std::vector<PrimitiveHit> corners = flatCorners(part);
    if (corners.empty()) return result;
    const V3f ng = pointAt(Ray{}, corners[0]).ng;
    for (const PrimitiveHit& corner : corners)
        if (pointAt(Ray{}, corner).ng.dot(ng) < 0) return result;
    result.normals = DirectionCone::about(toDouble(ng));
    return result;
}

std::optional<ShapeSample> MeshShape::samplePart(unsigned part, const V3d& from, const V2f& u) const {
    return primitiveCount() == 1 ? sample(from, u) : seen(sampleOn(part, 1, u), from);
}

float MeshShape::partPdf(const V3d& from, const PrimitiveHit& hit, const SurfacePoint& point) const {
    return primitiveCount() == 1 ? pdf(from, hit, point) : seenPdf(float(density(1, hit)), from, point);
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
