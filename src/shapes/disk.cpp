#include "shapes/disk.h"

#include "core/sampling.h"

namespace vitrine {

Disk::Disk(const Transform& worldFromObject, bool reverseOrientation, double height, double radius, double innerRadius,
           double phiMaxDegrees)
    : height_(requireFinite("height", height)), radius_(requirePositive("radius", radius)),
      innerRadius_(requireFinite("innerradius", innerRadius)), phi_(phiMaxDegrees),
      placement_(worldFromObject, reverseOrientation, std::max(radius, std::abs(height))) {
    if (innerRadius < 0) throw std::invalid_argument(fmt::format("\"innerradius\" is {}, is negative", innerRadius));
    requireRange("innerradius", innerRadius, "radius", radius);
    area_ = phi_.max() / 2 * (sqr(radius) - sqr(innerRadius)) * placement_.areaStretch(V3d(0, 0, 1));
}

Box3d Disk::bounds(unsigned) const {
    const auto& m = placement_.worldFromObject().matrix();
    const V3d center = placement_.worldFromObject().point(V3d(0, 0, height_));
    V3d reach;
    for (int i = 0; i < 3; ++i)
        reach[i] = radius_ * std::sqrt(sqr(m[0][i]) + sqr(m[1][i]));
    return Box3d(center - reach, center + reach);
}

bool Disk::cross(const Ray& ray, double sMin, double sMax, double& s, V2d& p) const {
    const Ray local = placement_.toObject(ray);
    const double above = local.o.z - height_;
    s = -above / local.d.z;
    if (!(s > sMin && s < sMax)) return false;
    p = V2d(local.o.x + s * local.d.x, local.o.y + s * local.d.y);
    const double r2 = p.length2();
    if (!(r2 <= sqr(radius_) && r2 >= sqr(innerRadius_)) || !phi_.contains(p.x, p.y)) return false;
    return !placement_.grazes(ray, above, local.d.z, V3d(0, 0, 1));
}

bool Disk::intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const {
    double s;
    V2d p;
    if (!cross(ray, sMin, sMax, s, p)) return false;
    hit = PrimitiveHit{s, p.x, p.y, prim};
    return true;
}

bool Disk::occludes(unsigned, const Ray& ray, double sMin, double sMax) const {
    double s;
    V2d p;
    return cross(ray, sMin, sMax, s, p);
}

SurfacePoint Disk::pointOf(const V2d& p) const {
    const double r = p.length();
    const V2d outwards = r > 0 ? p / r : V2d(1, 0);
    ObjectPoint point;
    point.p = V3d(p.x, p.y, height_);
    point.n = V3d(0, 0, 1);
    point.uv = V2d(phi_.u(p.x, p.y), std::clamp((radius_ - r) / (radius_ - innerRadius_), 0., 1.));
    point.dpdu = V3d(-p.y, p.x, 0) * phi_.max();
    point.dpdv = V3d(outwards.x, outwards.y, 0) * (innerRadius_ - radius_);
    return placement_.toWorld(point);
}

SurfacePoint Disk::pointAt(const Ray&, const PrimitiveHit& hit) const {
    return pointOf(V2d(hit.u, hit.v));
}

std::optional<ShapeSample> Disk::sample(const V2f& u) const {
    V2d p;
    if (phi_.isFull() && innerRadius_ == 0) {
        p = V2d(sampleUniformDisk(u)); // less distorted than the polar map
        p *= radius_ / std::max(1., p.length());
    } else {
        const double r = std::sqrt(lerp(double(u.x), sqr(innerRadius_), sqr(radius_))), phi = u.y * phi_.max();
        p = V2d(std::cos(phi), std::sin(phi)) * r;
    }
    return ShapeSample{pointOf(p), float(1 / area_)};
}

} // namespace vitrine
