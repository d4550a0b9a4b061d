#include "accel/coincident_faces.h"

#include <tuple>

namespace vitrine::embree {

namespace {

struct Face {
    V3d normal; ///< its largest component 1, so that coplanar faces along an axis have the very same plane
    double distance;
    Box3d box;
    std::size_t index;

    auto plane() const { return std::tuple(normal.x, normal.y, normal.z, distance); }
    int axis() const { return normal.x == 1 ? 1 : 0; } ///< one that the face extends along
};

bool makeFace(const PrimitiveRef& ref, std::size_t index, Face& face) {
    const Shape& shape = *ref.shape;
    const bool quad = shape.kind() == GeometryKind::Quads;
    const std::uint32_t* v = shape.indices() + std::size_t(ref.prim) * (quad ? 4 : 3);
    const auto corner = [&](int k) {
        const float* p = shape.vertices() + 3 * std::size_t(v[k]);
        return V3d(p[0], p[1], p[2]);
    };
    const V3d p0 = corner(0), n = (corner(1) - p0).cross(corner(quad ? 3 : 2) - p0);
    if (!(maxAbs(n) > 0)) return false;
    double largest = n.x;
    for (const double component : {n.y, n.z})
        if (std::abs(component) > std::abs(largest)) largest = component;
    face.normal = n / largest + V3d(0, 0, 0); // no negative zeros
    face.distance = face.normal.dot(p0) + 0.;
    face.box = shape.bounds(ref.prim);
    face.index = index;
    return true;
}

bool overlap(const Box3d& a, const Box3d& b) {
    for (int k = 0; k < 3; ++k) {
        const double low = std::max(a.min[k], b.min[k]), high = std::min(a.max[k], b.max[k]);
        // Along an axis that the plane is normal to, both are flat; along the others, touching is not enough.
        const bool flat = a.min[k] == a.max[k] && b.min[k] == b.max[k];
        if (!(low < high || (flat && low == high))) return false;
    }
    return true;
}

} // namespace

CoincidentFaces::CoincidentFaces(std::vector<PrimitiveRef>& table) {
    std::vector<Face> faces;
    for (std::size_t i = 0; i < table.size(); ++i)
        if (Face face; makeFace(table[i], i, face)) faces.push_back(face);
    const auto order = [](const Face& a, const Face& b) {
        if (a.plane() != b.plane()) return a.plane() < b.plane();
        return a.box.min[a.axis()] < b.box.min[b.axis()];
    };
    std::sort(faces.begin(), faces.end(), order);
    const auto givesWay = [&](const Face& loser, const Face& winner) {
        PrimitiveRef& ref = table[loser.index];
        if (!(table[winner.index].id < ref.id)) return;
        if (!ref.rivals) {
            lists_.emplace_back();
            ref.rivals = std::uint32_t(lists_.size()) & 0x7fffffffu;
        }
        lists_[ref.rivals - 1].push_back(table[winner.index]);
    };
    for (auto face = faces.begin(); face != faces.end(); ++face)
        for (auto other = face + 1; other != faces.end() && other->plane() == face->plane() &&
                                    other->box.min[face->axis()] < face->box.max[face->axis()];
             ++other)
            if (overlap(face->box, other->box)) {
                givesWay(*face, *other);
                givesWay(*other, *face);
            }
}

} // namespace vitrine::embree
