#include "shapes/revolution/revolution.h"

#include "shapes/quadrature.h"

namespace vitrine {

namespace {

int highestDegree(const Profile& profile) {
    int degree = 1;
    for (const BezierCurve& segment : profile.segments())
        degree = std::max(degree, segment.degree());
    return degree;
}

/// (y', -x') turned to phi = 0 in the xy plane; unit when d is.
V2d turnedRight(const V2d& d) {
    return V2d(d.y, -d.x);
}

V3d atAngle(const V2d& p, double cosPhi, double sinPhi) {
    return V3d(p.x * cosPhi, p.y, p.x * sinPhi);
}

} // namespace

Revolution::Revolution(const Transform& worldFromObject, bool reverseOrientation, Profile profile, double phiMaxDegrees,
                       VMap vmap)
    : profile_(std::move(profile)), phi_(phiMaxDegrees),
      placement_(Placement::solid(worldFromObject, reverseOrientation, profile_.size())), roots_(profile_),
      table_(profile_) {
    if (vmap == VMap::ArcLength) arcLength_.emplace(profile_);
    // Horner's rule for the point, the same again for what the next ray makes of it.
    constexpr double eps = std::numeric_limits<double>::epsilon();
    profileError_ = (8 + 2 * highestDegree(profile_)) * eps * profile_.size() * placement_.maxStretch();
    area_ = placement_.isSimilarity() ? phi_.max() * table_.total() * sqr(placement_.scale()) : integrateArea();
}

double Revolution::integrateArea() const {
    const auto estimate = [&](int panels) {
        double sum = 0;
        for (const ProfilePart& part : profile_.parts()) {
            const auto ring = [&](double v) {
                const CurvePoint c = profile_.evaluate(v);
                const double length = c.d1.length();
                if (!(length > 0)) return 0.;
                const V2d n = turnedRight(c.d1 / length);
                const auto stretch = [&](double phi) {
                    return placement_.areaStretch(atAngle(n, std::cos(phi), std::sin(phi)));
                };
                return areaDensity(c) * integratePanels(stretch, 0, phi_.max(), 4 * panels);
            };
            sum += integratePanels(ring, part.v0, part.v1, panels);
        }
        return sum;
    };
    return refinePanels(estimate, 16);
}

Box3d Revolution::bounds(unsigned prim) const {
    Box3d box;
    for (const Ring& ring : roots_.rings(prim))
        box.extendBy(phi_.isFull() ? ringBox(ring) : sectorBox(ring));
    const double margin = placement_.error(V3d(std::max(maxAbs(box.min), maxAbs(box.max)))) + profileError_;
    return Box3d(box.min - V3d(margin), box.max + V3d(margin));
}

Box3d Revolution::ringBox(const Ring& ring) const {
    const auto& m = placement_.worldFromObject().matrix();
    Box3d box;
    for (int i = 0; i < 3; ++i) {
        const double reach = ring.rMax * std::sqrt(sqr(m[0][i]) + sqr(m[2][i]));
        const double a = ring.yMin * m[1][i], b = ring.yMax * m[1][i];
        box.min[i] = m[3][i] + std::min(a, b) - reach;
        box.max[i] = m[3][i] + std::max(a, b) + reach;
    }
    return box;
}

/// Of the sector's corners, and where it reaches farthest along an axis.
Box3d Revolution::sectorBox(const Ring& ring) const {
    Box3d sector;
    const auto add = [&](double x, double z) {
        sector.extendBy(V3d(x, ring.yMin, z));
        sector.extendBy(V3d(x, ring.yMax, z));
    };
    for (const double u : {0., 1.}) {
        const Angle a = angle(u);
        add(ring.rMin * a.cos, ring.rMin * a.sin);
        add(ring.rMax * a.cos, ring.rMax * a.sin);
    }
    for (const V2d& axis : {V2d(0, 1), V2d(-1, 0), V2d(0, -1)})
        if (phi_.contains(axis.x, axis.y)) add(ring.rMax * axis.x, ring.rMax * axis.y);
    return placement_.worldFromObject().box(sector);
}

PrimitiveHit Revolution::primitiveHit(const Ray& objectRay, const ProfileHit& hit, unsigned prim) const {
    const ProfilePart& part = profile_.parts()[hit.part];
    const double x = objectRay.o.x + hit.s * objectRay.d.x, z = objectRay.o.z + hit.s * objectRay.d.z;
    return PrimitiveHit{hit.s, phi_.u(x, z), lerp(hit.t, part.v0, part.v1), prim};
}

bool Revolution::intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const {
    const Ray local = placement_.toObject(ray);
    const AxialRay axial(local);
    if (!axial.valid()) return false;
    HitCollector hits(axial, phi_, roots_.size(), sMin, sMax, HitCollector::Mode::First);
    roots_.search(prim, hits);
    if (!hits.found()) return false;
    hit = primitiveHit(local, hits.first(), prim);
    return true;
}

bool Revolution::occludes(unsigned prim, const Ray& ray, double sMin, double sMax) const {
    const AxialRay axial(placement_.toObject(ray));
    if (!axial.valid()) return false;
    HitCollector hits(axial, phi_, roots_.size(), sMin, sMax, HitCollector::Mode::Any);
    roots_.search(prim, hits);
    return hits.found();
}

std::vector<PrimitiveHit> Revolution::allHits(const Ray& ray, double sMin, double sMax) const {
    const Ray local = placement_.toObject(ray);
    std::vector<PrimitiveHit> result;
    for (const ProfileHit& hit : roots_.allHits(AxialRay(local), phi_, sMin, sMax))
        result.push_back(primitiveHit(local, hit, 0));
    return result;
}

Revolution::Angle Revolution::angle(double u) const {
    const double phi = u * phi_.max();
    return {std::cos(phi), std::sin(phi)};
}

/// The direction of the curve where its derivative vanishes (a cusp, coinciding control points): that of a point a
/// little farther inside the part.
V2d Revolution::tangentNear(double v) const {
    const ProfilePart& part = profile_.parts()[profile_.partAt(v)];
    const V2d d = profile_.evaluate(lerp(1e-4, v, (part.v0 + part.v1) / 2)).d1;
    const double length = d.length();
    return length > 0 ? d / length : V2d(0, 1);
}

ObjectPoint Revolution::describe(double u, double v, const Angle& phi) const {
    const CurvePoint c = profile_.evaluate(v);
    const double speed = c.d1.length(), sign = profile_.drawnInsideOut() ? -1 : 1;
    const bool regular = speed > 1e-9 * profile_.size();
    const V2d tangent = regular ? c.d1 / speed : tangentNear(v);
    const V2d p(std::max(c.p.x, 0.), c.p.y), n = turnedRight(tangent) * sign;
    ObjectPoint point;
    point.p = atAngle(p, phi.cos, phi.sin);
    point.n = atAngle(n, phi.cos, phi.sin);
    point.uv = V2d(u, textureV(v));
    point.dpdu = V3d(-p.x * phi.sin, 0, p.x * phi.cos) * phi_.max();
    V2d dpdv = c.d1;
    double dvPerParameter = 1;
    if (arcLength_) {
        dpdv = tangent * arcLength_->total();
        dvPerParameter = speed / arcLength_->total();
    }
    point.dpdv = atAngle(dpdv, phi.cos, phi.sin);
    point.dndu = V3d(-n.x * phi.sin, 0, n.x * phi.cos) * phi_.max();
    if (regular) {
        // Frenet: the normal turns along the tangent at the curvature times the speed.
        const double turn = (tangent.x * c.d2.y - tangent.y * c.d2.x) / speed;
        point.dndv = atAngle(tangent * (turn * sign / dvPerParameter), phi.cos, phi.sin);
    }
    return point;
}

SurfacePoint Revolution::toWorld(const ObjectPoint& point) const {
    SurfacePoint result = placement_.toWorld(point);
    result.error += profileError_;
    return result;
}

SurfacePoint Revolution::pointAt(const Ray& ray, const PrimitiveHit& hit) const {
    const V3d p = placement_.toObject(ray).at(hit.s);
    const double r = std::sqrt(p.x * p.x + p.z * p.z);
    // Next to the axis the ray's rounding leaves no angle.
    const bool hasAngle = r > 1e-12 * profile_.size();
    return toWorld(describe(hit.u, hit.v, hasAngle ? Angle{p.x / r, p.z / r} : angle(hit.u)));
}

double Revolution::pdfAt(double v, const V3d& normal) const {
    return table_.pdf(v, areaDensity(profile_.evaluate(v))) / (phi_.max() * placement_.areaStretch(normal));
}

std::optional<ShapeSample> Revolution::sample(const V2f& u) const {
    const double v = table_.sample(u.y);
    const ObjectPoint point = describe(u.x, v, angle(u.x));
    return ShapeSample{toWorld(point), float(pdfAt(v, point.n))};
}

float Revolution::pdf(const PrimitiveHit& hit) const {
    return float(pdfAt(hit.v, describe(hit.u, hit.v, angle(hit.u)).n));
}

std::string_view Revolution::whyOpen() const {
    if (!profile_.isClosed())
        return "its profile neither ends on the axis at both ends nor comes back to its beginning";
    return phi_.isFull() ? "" : "\"phimax\" is below 360";
}

std::size_t Revolution::memoryBytes() const {
    return sizeof(*this) + roots_.memoryBytes() + table_.memoryBytes() + (arcLength_ ? arcLength_->memoryBytes() : 0) +
           profile_.parts().size() * sizeof(ProfilePart);
}

} // namespace vitrine
