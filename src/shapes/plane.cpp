#include "shapes/plane.h"

#include "core/frame.h"
#include "shapes/placement.h"

namespace vitrine {

Plane::Plane(const Transform& worldFromObject, bool reverseOrientation, const V3d& normal, double d) {
    requireFinite("d", d);
    if (!isFinite(normal)) throw std::invalid_argument("\"n\" is not finite");
    const double length = normal.length();
    if (!(length > 0) || !std::isfinite(length)) throw std::invalid_argument("\"n\" has no direction");
    const V3d n = normal / length;
    const double height = d / length;
    const Placement placement(worldFromObject, reverseOrientation, std::abs(height));

    const V3d worldNormal = worldFromObject.normal(n);
    n_ = worldNormal / worldNormal.length();
    // The foot of the perpendicular from the object's origin; d_ from it, so that it takes part in all the rounding.
    origin_ = worldFromObject.point(n * height);
    d_ = n_.dot(origin_);
    ng_ = toFloat(placement.flips() ? -n_ : n_);

    // Made perpendicular in double: the frame is single precision.
    const V3d rough = toDouble(Frame(toFloat(n)).s);
    const V3d s = (rough - n * n.dot(rough)).normalized(), t = n.cross(s);
    dpdu_ = worldFromObject.vector(s);
    dpdv_ = worldFromObject.vector(t);
    // u = s.(W (p - origin)), and a transposed inverse is what carries normals.
    uOf_ = worldFromObject.normal(s);
    vOf_ = worldFromObject.normal(t);
}

Box3d Plane::bounds(unsigned) const {
    return Box3d(V3d(-infinityD), V3d(infinityD));
}

double Plane::error(const V3d& p) const {
    return 0x1p-49 * (maxAbs(p) + std::abs(d_));
}

bool Plane::intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const {
    const double above = height(ray.o), slope = n_.dot(ray.d);
    const double s = -above / slope;
    if (!(s > sMin && s < sMax) || !isFinite(ray.d)) return false;
    // A ray that starts on the plane and runs along it but for rounding stays on its side.
    if (sqr(slope) <= sqr(grazingSlope) * ray.d.length2() && std::abs(above) <= 4 * error(ray.o)) return false;
    const V3d p = ray.at(s) - origin_;
    hit = PrimitiveHit{s, uOf_.dot(p), vOf_.dot(p), prim};
    return true;
}

SurfacePoint Plane::pointAt(const Ray& ray, const PrimitiveHit& hit) const {
    SurfacePoint point;
    point.p = ray.at(hit.s);
    point.p -= n_ * height(point.p);
    point.error = error(point.p);
    point.ng = point.ns = ng_;
    point.uv = V2f(float(hit.u), float(hit.v));
    point.dpdu = toFloat(dpdu_);
    point.dpdv = toFloat(dpdv_);
    point.dndu = point.dndv = V3f(0, 0, 0);
    return point;
}

} // namespace vitrine
