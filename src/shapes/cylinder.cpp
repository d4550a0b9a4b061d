#include "shapes/cylinder.h"

#include "shapes/quadratic.h"
#include "shapes/quadrature.h"

namespace vitrine {

Cylinder::Cylinder(const Transform& worldFromObject, bool reverseOrientation, double radius, double zMin, double zMax,
                   double phiMaxDegrees)
    : radius_(requirePositive("radius", radius)), zMin_(requireFinite("zmin", zMin)),
      zMax_(requireFinite("zmax", zMax)), phi_(phiMaxDegrees),
      placement_(worldFromObject, reverseOrientation, std::max({radius, std::abs(zMin), std::abs(zMax)})) {
    requireRange("zmin", zMin, "zmax", zMax);
    const auto meridian = [&](int panels) {
        const auto stretch = [&](double phi) { return placement_.areaStretch(V3d(std::cos(phi), std::sin(phi), 0)); };
        return integratePanels(stretch, 0, phi_.max(), panels);
    };
    area_ = radius * (zMax - zMin) * refinePanels(meridian, 1024);
}

Box3d Cylinder::bounds(unsigned) const {
    const auto& m = placement_.worldFromObject().matrix();
    const V3d low = placement_.worldFromObject().point(V3d(0, 0, zMin_));
    const V3d high = placement_.worldFromObject().point(V3d(0, 0, zMax_));
    Box3d result;
    for (int i = 0; i < 3; ++i) {
        const double reach = radius_ * std::sqrt(sqr(m[0][i]) + sqr(m[1][i]));
        result.min[i] = std::min(low[i], high[i]) - reach;
        result.max[i] = std::max(low[i], high[i]) + reach;
    }
    return result;
}

bool Cylinder::cross(const Ray& ray, double sMin, double sMax, double& s, V3d& pObject) const {
    Ray local = placement_.toObject(ray);
    const double r2 = sqr(local.o.x) + sqr(local.o.y);
    // A ray may follow the wall along the axis for so long that it meets the wall by rounding alone: it is then taken
    // to be tangent.
    if (std::abs(r2 - sqr(radius_)) < 1e-3 * sqr(radius_)) {
        const V3d n = V3d(local.o.x, local.o.y, 0) / std::sqrt(r2);
        const double slope = local.d.dot(n);
        if (placement_.grazes(ray, std::sqrt(r2) - radius_, slope, n)) local.d -= n * slope;
    }
    Crossings roots;
    if (!crossCylinder(local.o, local.d, sqr(radius_), roots)) return false;
    for (const double root : {roots.near, roots.far}) {
        if (!(root > sMin && root < sMax)) continue;
        V3d p = local.at(root);
        const double scale = radius_ / std::sqrt(sqr(p.x) + sqr(p.y));
        p.x *= scale;
        p.y *= scale;
        if (!(p.z >= zMin_ && p.z <= zMax_) || !phi_.contains(p.x, p.y)) continue;
        s = root;
        pObject = p;
        return true;
    }
    return false;
}

bool Cylinder::intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const {
    double s;
    V3d p;
    if (!cross(ray, sMin, sMax, s, p)) return false;
    hit = PrimitiveHit{s, phi_.u(p.x, p.y), (p.z - zMin_) / (zMax_ - zMin_), prim};
    return true;
}

bool Cylinder::occludes(unsigned, const Ray& ray, double sMin, double sMax) const {
    double s;
    V3d p;
    return cross(ray, sMin, sMax, s, p);
}

SurfacePoint Cylinder::pointOf(const V3d& p) const {
    ObjectPoint point;
    point.p = p;
    point.n = V3d(p.x, p.y, 0) / radius_;
    point.uv = V2d(phi_.u(p.x, p.y), std::clamp((p.z - zMin_) / (zMax_ - zMin_), 0., 1.));
    point.dpdu = V3d(-p.y, p.x, 0) * phi_.max();
    point.dpdv = V3d(0, 0, zMax_ - zMin_);
    point.dndu = point.dpdu / radius_;
    return placement_.toWorld(point);
}

SurfacePoint Cylinder::pointAt(const Ray& ray, const PrimitiveHit& hit) const {
    V3d p = placement_.toObject(ray).at(hit.s);
    const double scale = radius_ / std::sqrt(sqr(p.x) + sqr(p.y));
    return pointOf(V3d(p.x * scale, p.y * scale, std::clamp(p.z, zMin_, zMax_)));
}

float Cylinder::pdfAt(const V3d& n) const {
    return float(1 / (phi_.max() * radius_ * (zMax_ - zMin_) * placement_.areaStretch(n)));
}

std::optional<ShapeSample> Cylinder::sample(const V2f& u) const {
    const double phi = u.y * phi_.max();
    const V3d n(std::cos(phi), std::sin(phi), 0);
    return ShapeSample{pointOf(V3d(n.x * radius_, n.y * radius_, lerp(double(u.x), zMin_, zMax_))), pdfAt(n)};
}

float Cylinder::pdf(const PrimitiveHit& hit) const {
    const double phi = hit.u * phi_.max();
    return pdfAt(V3d(std::cos(phi), std::sin(phi), 0));
}

} // namespace vitrine
