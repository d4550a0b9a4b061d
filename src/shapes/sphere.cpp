#include "shapes/sphere.h"

#include "shapes/quadrature.h"

namespace vitrine {

namespace {

/// 1 - cos of the half angle of the cone that a sphere fills, without cancellation.
double coneHeight(double distance2, double radius2) {
    const double cosMax = std::sqrt((distance2 - radius2) / distance2);
    return radius2 / distance2 / (1 + cosMax);
}

/// Uniform density over that cone; 0 when it is too narrow for a float to say.
float conePdf(double distance2, double radius2) {
    const float pdf = float(1 / (2 * piD * coneHeight(distance2, radius2)));
    return std::isfinite(pdf) ? pdf : 0;
}

/// atan2 for y >= 0 to about 2e-7, without branches and in a fifth of the library's time (Abramowitz & Stegun 1964,
/// eq. 4.4.49).
float angleOf(float y, float x) {
    const float absX = std::abs(x);
    const float t = std::min(y, absX) / std::max({y, absX, std::numeric_limits<float>::min()}), z = t * t;
    float series = 0.0028662257f;
    for (const float c : {-0.0161657367f, 0.0429096138f, -0.0752896400f, 0.1065626393f, -0.1420889944f, 0.1999355085f,
                          -0.3333314528f, 1.f})
        series = series * z + c;
    // Mirrored at the diagonal, then at the y axis.
    const float octant = pi / 4 - (pi / 4 - t * series) * std::copysign(1.f, absX - y);
    return pi / 2 - (pi / 2 - octant) * std::copysign(1.f, x);
}

/// Some unit vector perpendicular to the unit vector n.
V3d perpendicular(const V3d& n) {
    const V3d v = std::abs(n.x) > 0.7 ? V3d(-n.y, n.x, 0) : V3d(0, -n.z, n.y);
    return v / v.length();
}

} // namespace

Sphere::Sphere(const Transform& worldFromObject, bool reverseOrientation, double radius, double zMin, double zMax,
               double phiMaxDegrees)
    : radius_(requirePositive("radius", radius)), phi_(phiMaxDegrees),
      placement_(worldFromObject, reverseOrientation, radius) {
    requireRange("zmin", zMin, "zmax", zMax);
    zMin_ = std::max(zMin, -radius);
    zMax_ = std::min(zMax, radius);
    if (!(zMin_ < zMax_))
        throw std::invalid_argument(fmt::format(
            "nothing of the sphere lies between \"zmin\" {} and \"zmax\" {}: \"radius\" is {}", zMin, zMax, radius));
    thetaZMin_ = std::acos(zMin_ / radius);
    thetaZMax_ = std::acos(zMax_ / radius);
    isFull_ = zMin_ == -radius && zMax_ == radius && phi_.isFull();
    isRound_ = isFull_ && placement_.isSimilarity();
    center_ = worldFromObject.point(V3d(0, 0, 0));
    worldRadius_ = radius * placement_.scale();
    worldRadius2_ = sqr(worldRadius_);
    for (int axis = 0; axis < 3; ++axis) {
        V3d e(0, 0, 0);
        e[axis] = 1 / placement_.scale();
        axes_[std::size_t(axis)] = toFloat(worldFromObject.vector(e));
    }
    const double maxAxis = radius * placement_.maxStretch(), minAxis = radius * placement_.minStretch();
    const double maxCurvatureRadius = isRound_ ? worldRadius_ : sqr(maxAxis) / minAxis;
    // A line that starts on a circle of radius r with slope t into it dips r t^2 / 2 deep; twice that.
    grazingError_ = maxCurvatureRadius * sqr(grazingSlope);
    area_ =
        placement_.isSimilarity() ? phi_.max() * radius * (zMax_ - zMin_) * sqr(placement_.scale()) : integrateArea();
}

double Sphere::integrateArea() const {
    const auto estimate = [&](int panels) {
        const auto ring = [&](double theta) {
            const double sinTheta = std::sin(theta), cosTheta = std::cos(theta);
            const auto stretch = [&](double phi) {
                return placement_.areaStretch(V3d(sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta));
            };
            return sinTheta * integratePanels(stretch, 0, phi_.max(), panels);
        };
        return integratePanels(ring, thetaZMax_, thetaZMin_, panels);
    };
    return sqr(radius_) * refinePanels(estimate, 64);
}

Box3d Sphere::bounds(unsigned) const {
    if (isRound_) return Box3d(center_ - V3d(worldRadius_), center_ + V3d(worldRadius_));
    // The support of the ellipsoid along each world axis, and of the clipped object box; both hold the surface.
    const auto& m = placement_.worldFromObject().matrix();
    const V3d reach = V3d(V3d(m[0][0], m[1][0], m[2][0]).length(), V3d(m[0][1], m[1][1], m[2][1]).length(),
                          V3d(m[0][2], m[1][2], m[2][2]).length()) *
                      radius_;
    const Box3d clipped =
        placement_.worldFromObject().box(Box3d(V3d(-radius_, -radius_, zMin_), V3d(radius_, radius_, zMax_)));
    Box3d result(center_ - reach, center_ + reach);
    for (int i = 0; i < 3; ++i) {
        result.min[i] = std::max(result.min[i], clipped.min[i]);
        result.max[i] = std::min(result.max[i], clipped.max[i]);
    }
    return result;
}

bool Sphere::covers(const V3d& p) const {
    // A limit at the pole is none: rounding must not pierce it.
    if (zMin_ > -radius_ && p.z < zMin_) return false;
    if (zMax_ < radius_ && p.z > zMax_) return false;
    return phi_.contains(p.x, p.y);
}

bool Sphere::cross(const Ray& ray, double sMin, double sMax, double& s, V3d& pObject) const {
    const Ray local = placement_.toObject(ray);
    Crossings roots;
    if (!crossSphere(local.o, local.d, sqr(radius_), roots)) return false;
    for (const double root : {roots.near, roots.far}) {
        if (!(root > sMin && root < sMax)) continue;
        const V3d p = local.at(root);
        pObject = p * (radius_ / p.length());
        if (!isFull_ && !covers(pObject)) continue;
        s = root;
        return true;
    }
    return false;
}

bool Sphere::intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const {
    if (isRound_) {
        Crossings roots;
        if (!crossSphere(ray.o - center_, ray.d, worldRadius2_, roots)) return false;
        const double s = roots.near > sMin ? roots.near : roots.far;
        if (!(s > sMin && s < sMax)) return false;
        hit = PrimitiveHit{s, 0, 0, prim};
        return true;
    }
    double s;
    V3d p;
    if (!cross(ray, sMin, sMax, s, p)) return false;
    const double theta = std::atan2(std::hypot(p.x, p.y), p.z);
    hit = PrimitiveHit{s, phi_.u(p.x, p.y), (theta - thetaZMin_) / (thetaZMax_ - thetaZMin_), prim};
    return true;
}

bool Sphere::occludes(unsigned prim, const Ray& ray, double sMin, double sMax) const {
    if (isRound_) {
        PrimitiveHit hit;
        return intersect(prim, ray, sMin, sMax, hit);
    }
    double s;
    V3d p;
    return cross(ray, sMin, sMax, s, p);
}

ObjectPoint Sphere::describe(const V3d& p) const {
    const double rho = std::sqrt(sqr(p.x) + sqr(p.y));
    const double cosPhi = rho > 0 ? p.x / rho : 1, sinPhi = rho > 0 ? p.y / rho : 0;
    const double thetaRange = thetaZMax_ - thetaZMin_, theta = std::atan2(rho, p.z);
    ObjectPoint result;
    result.p = p;
    result.n = p / radius_;
    result.uv = V2d(phi_.u(p.x, p.y), std::clamp((theta - thetaZMin_) / thetaRange, 0., 1.));
    result.dpdu = V3d(-p.y, p.x, 0) * phi_.max();
    result.dpdv = V3d(p.z * cosPhi, p.z * sinPhi, -rho) * thetaRange;
    result.dndu = result.dpdu / radius_;
    result.dndv = result.dpdv / radius_;
    return result;
}

SurfacePoint Sphere::roundPoint(const V3d& normal) const {
    SurfacePoint result;
    result.p = center_ + normal * worldRadius_;
    // Eight roundings of the world coordinates that subtraction of the centre cancels.
    result.error = grazingError_ + 0x1p-50 * maxAbs(result.p);
    result.ng = result.ns = toFloat(placement_.flips() ? -normal : normal);

    // Parameters and derivatives as in describe(), for the unit sphere turned as the object is; in single precision,
    // which is all that is wanted of them and several times quicker.
    const auto& [x, y, z] = axes_;
    const V3f n = toFloat(normal);
    const V3f local(n.dot(x), n.dot(y), n.dot(z));
    const float rho = std::sqrt(sqr(local.x) + sqr(local.y));
    const float cosPhi = rho > 0 ? local.x / rho : 1, sinPhi = rho > 0 ? local.y / rho : 0;
    const float halfTurn = angleOf(std::abs(local.y), local.x) * (invPi / 2);
    result.uv = V2f(local.y < 0 ? 1 - halfTurn : halfTurn, std::max(0.f, 1 - angleOf(rho, local.z) * invPi));
    const V3f dndu = (y * local.x - x * local.y) * (2 * pi);
    const V3f dndv = (z * rho - (x * cosPhi + y * sinPhi) * local.z) * pi;
    result.dpdu = dndu * float(worldRadius_);
    result.dpdv = dndv * float(worldRadius_);
    result.dndu = placement_.flips() ? -dndu : dndu;
    result.dndv = placement_.flips() ? -dndv : dndv;
    return result;
}

SurfacePoint Sphere::pointAt(const Ray& ray, const PrimitiveHit& hit) const {
    if (isRound_) {
        const V3d d = ray.o - center_ + ray.d * hit.s;
        return roundPoint(d / d.length());
    }
    const V3d p = placement_.toObject(ray).at(hit.s);
    SurfacePoint result = placement_.toWorld(describe(p * (radius_ / p.length())));
    result.error += grazingError_;
    return result;
}

std::optional<ShapeSample> Sphere::sample(const V2f& u) const {
    const double z = lerp(double(u.x), zMin_, zMax_), phi = u.y * phi_.max();
    const double rho = safeSqrt(sqr(radius_) - sqr(z));
    const V3d p(rho * std::cos(phi), rho * std::sin(phi), z);
    ShapeSample result;
    if (isRound_) {
        const V3d d = placement_.worldFromObject().vector(p);
        result.point = roundPoint(d / d.length());
        result.pdf = float(1 / area_);
    } else {
        result.point = placement_.toWorld(describe(p));
        result.point.error += grazingError_;
        const double pdfObject = 1 / (phi_.max() * radius_ * (zMax_ - zMin_));
        result.pdf = float(pdfObject / placement_.areaStretch(p / radius_));
    }
    return result;
}

float Sphere::pdf(const PrimitiveHit& hit) const {
    if (placement_.isSimilarity()) return float(1 / area_);
    const double theta = lerp(hit.v, thetaZMin_, thetaZMax_), phi = hit.u * phi_.max();
    const V3d n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    return float(1 / (phi_.max() * radius_ * (zMax_ - zMin_) * placement_.areaStretch(n)));
}

bool Sphere::isOutside(double distance2) const {
    // Points of the sphere itself may lie a rounding outside; from there the cone would show nothing but themselves.
    return isRound_ && distance2 > worldRadius2_ * (1 + 1e-9);
}

std::optional<ShapeSample> Sphere::sample(const V3d& from, const V2f& u) const {
    const V3d toFrom = from - center_;
    const double distance2 = toFrom.length2();
    if (!isOutside(distance2)) return Shape::sample(from, u);

    ShapeSample result;
    result.pdf = conePdf(distance2, worldRadius2_);
    if (!(result.pdf > 0)) return std::nullopt;
    // The direction makes the angle theta with that to the centre; seen from the centre the point lies at the angle
    // alpha = beta - theta from the way back, where sin(beta) = sin(theta) distance / radius (law of sines).
    const double height = u.x * coneHeight(distance2, worldRadius2_);
    const double cosTheta = 1 - height, sin2Theta = height * (2 - height), sinTheta = std::sqrt(sin2Theta);
    const double sin2Beta = std::min(1., sin2Theta * distance2 / worldRadius2_);
    const double sinBeta = std::sqrt(sin2Beta), cosBeta = std::sqrt(1 - sin2Beta);
    const double cosAlpha = cosBeta * cosTheta + sinBeta * sinTheta;
    const double sinAlpha = sinBeta * cosTheta - cosBeta * sinTheta;
    const double phi = 2 * piD * u.y;
    const V3d axis = toFrom / std::sqrt(distance2), s = perpendicular(axis), t = axis.cross(s);
    const V3d n = axis * cosAlpha + (s * std::cos(phi) + t * std::sin(phi)) * sinAlpha;
    result.point = roundPoint(n / n.length());
    return result;
}

float Sphere::pdf(const V3d& from, const PrimitiveHit& hit, const SurfacePoint& point) const {
    const double distance2 = (from - center_).length2();
    if (!isOutside(distance2)) return Shape::pdf(from, hit, point);
    // The far side, met through a near side that lets light pass, is never drawn. (At the rim rounding decides.)
    const V3d back = from - point.p;
    if ((point.p - center_).dot(back) < -1e-5 * worldRadius_ * back.length()) return 0;
    return conePdf(distance2, worldRadius2_);
}

} // namespace vitrine
