#include "shapes/shape.h"

namespace vitrine {

Box3d Shape::bounds() const {
    Box3d all;
    for (unsigned prim = 0, count = primitiveCount(); prim < count; ++prim)
        all.extendBy(bounds(prim));
    return all;
}

std::optional<ShapeSample> Shape::seen(std::optional<ShapeSample> drawn, const V3d& from) {
    if (!drawn) return drawn;
    const V3d d = drawn->point.p - from;
    const double distance2 = d.length2();
    if (!(distance2 > 0)) return std::nullopt;
    drawn->pdf =
        areaToSolidAngle(drawn->pdf, distance2, std::abs(d.dot(toDouble(drawn->point.ng))) / std::sqrt(distance2));
    // Seen edge on, the density overflows: such a point subtends nothing.
    if (!(drawn->pdf > 0) || !std::isfinite(drawn->pdf)) return std::nullopt;
    return drawn;
}

float Shape::seenPdf(float pdfArea, const V3d& from, const SurfacePoint& point) {
    const V3d d = point.p - from;
    const double distance2 = d.length2();
    if (!(distance2 > 0)) return 0;
    const double absCos = std::abs(d.dot(toDouble(point.ng))) / std::sqrt(distance2);
    const float solidAngle = areaToSolidAngle(pdfArea, distance2, absCos);
    return std::isfinite(solidAngle) ? solidAngle : 0;
}

std::optional<ShapeSample> Shape::sample(const V3d& from, const V2f& u) const {
    return seen(sample(u), from);
}

float Shape::pdf(const V3d& from, const PrimitiveHit& hit, const SurfacePoint& point) const {
    return seenPdf(pdf(hit), from, point);
}

} // namespace vitrine
