#include "accel/instance.h"

namespace vitrine {

Placed::Placed(const CasterInstance& instance)
    : group_(instance.group), worldFromInstance_(instance.worldFromInstance),
      instanceFromWorld_(instance.worldFromInstance.inverse()), stretch_(linearNorm(worldFromInstance_.matrix())),
      inverseStretch_(linearNorm(instanceFromWorld_.matrix())) {}

void Placed::toWorld(SurfacePoint& point) const {
    const V3d local = point.p;
    point.p = worldFromInstance_.point(local);
    // Double rounding on the way to the world and back: four operations a coordinate, both ways.
    const M44d& m = worldFromInstance_.matrix();
    const double reach = stretch_ * maxAbs(local) + maxAbs(V3d(m[3][0], m[3][1], m[3][2])) + maxAbs(point.p);
    point.error = stretch_ * point.error + 16 * 0x1p-53 * (1 + stretch_ * inverseStretch_) * reach;
    const V3d normal = worldFromInstance_.normal(toDouble(point.ng));
    const V3d shading = worldFromInstance_.normal(toDouble(point.ns));
    const double length = shading.length();
    const V3d ns = shading / length;
    const auto unitDerivative = [&](const V3f& dn) {
        const V3d d = worldFromInstance_.normal(toDouble(dn)) / length;
        return toFloat(d - ns * ns.dot(d));
    };
    point.dndu = unitDerivative(point.dndu);
    point.dndv = unitDerivative(point.dndv);
    point.ng = toFloat(normal.normalized());
    point.ns = toFloat(ns);
    // Inverse transposes keep both normals on one side but for rounding.
    if (point.ns.dot(point.ng) < 0) point.ns = -point.ns;
    point.dpdu = toFloat(worldFromInstance_.vector(toDouble(point.dpdu)));
    point.dpdv = toFloat(worldFromInstance_.vector(toDouble(point.dpdv)));
}

Box3d boundsOf(const std::vector<CasterShape>& shapes) {
    Box3d box;
    for (const CasterShape& entry : shapes)
        if (entry.shape->kind() != GeometryKind::Unbounded) box.extendBy(entry.shape->bounds());
    return box;
}

std::size_t memoryOf(const std::vector<CasterShape>& shapes) {
    std::size_t bytes = 0;
    for (const CasterShape& entry : shapes)
        bytes += entry.shape->memoryBytes();
    return bytes;
}

} // namespace vitrine
