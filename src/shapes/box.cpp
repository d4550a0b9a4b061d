#include "shapes/box.h"

namespace vitrine {

namespace {

/// Faces are numbered 2 * axis, plus 1 for the greater one.
V3d unitAxis(int axis) {
    V3d e(0, 0, 0);
    e[axis] = 1;
    return e;
}

/// The largest coordinate. \throws std::invalid_argument unless pMin is less than pMax, both finite
double checkedReach(const V3d& pMin, const V3d& pMax) {
    requireRange("pmin.x", pMin.x, "pmax.x", pMax.x);
    requireRange("pmin.y", pMin.y, "pmax.y", pMax.y);
    requireRange("pmin.z", pMin.z, "pmax.z", pMax.z);
    return std::max(maxAbs(pMin), maxAbs(pMax));
}

} // namespace

Box::Box(const Transform& worldFromObject, bool reverseOrientation, const V3d& pMin, const V3d& pMax)
    : min_(pMin), max_(pMax),
      placement_(Placement::solid(worldFromObject, reverseOrientation, checkedReach(pMin, pMax))) {
    const V3d size = pMax - pMin;
    area_ = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const V3d e = unitAxis(axis);
        normalLength_[axis] = placement_.normalLength(e);
        faceArea_[std::size_t(axis)] = size[(axis + 1) % 3] * size[(axis + 2) % 3] * placement_.areaStretch(e);
        area_ += 2 * faceArea_[std::size_t(axis)];
    }
}

Box3d Box::bounds(unsigned) const {
    return placement_.worldFromObject().box(Box3d(min_, max_));
}

bool Box::intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const {
    if (!isFinite(ray.o) || !isFinite(ray.d)) return false;
    const Ray local = placement_.toObject(ray);
    const double grazing = grazingSlope * ray.d.length(), tolerance = 4 * placement_.error(ray.o);
    double near = -infinityD, far = infinityD;
    int nearFace = 0, farFace = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = local.o[axis], d = local.d[axis], low = min_[axis], high = max_[axis];
        // A ray that starts on a face and runs along it but for rounding stays on its side of it.
        const bool parallel =
            std::abs(d) <= grazing * normalLength_[axis] &&
            (d == 0 || std::min(std::abs(o - low), std::abs(o - high)) <= tolerance * normalLength_[axis]);
        if (parallel) {
            if (!(o >= low && o <= high)) return false;
            continue;
        }
        const bool forward = d > 0;
        const double entry = ((forward ? low : high) - o) / d, exit = ((forward ? high : low) - o) / d;
        if (entry > near) near = entry, nearFace = 2 * axis + !forward;
        if (exit < far) far = exit, farFace = 2 * axis + forward;
    }
    if (!(near <= far)) return false;
    const bool enters = near > sMin;
    const double s = enters ? near : far;
    if (!(s > sMin && s < sMax)) return false;
    hit = PrimitiveHit{s, double(enters ? nearFace : farFace), 0, prim};
    return true;
}

SurfacePoint Box::pointOf(int face, V3d p) const {
    const int axis = face / 2, next = (axis + 1) % 3, last = (axis + 2) % 3;
    const bool greater = face % 2;
    const double sign = greater ? 1 : -1;
    const double tolerance = 2 * placement_.error(placement_.worldFromObject().point(p));
    for (const int i : {next, last}) {
        // Off the edges by what rounding may move the point, so that it stays within the neighbouring faces' planes.
        const double margin = std::min(tolerance * normalLength_[i], (max_[i] - min_[i]) / 2);
        p[i] = std::clamp(p[i], min_[i] + margin, std::max(max_[i] - margin, min_[i] + margin));
    }
    p[axis] = greater ? max_[axis] : min_[axis];

    const V3d size = max_ - min_;
    ObjectPoint point;
    point.p = p;
    point.n = unitAxis(axis) * sign;
    const double along = (p[next] - min_[next]) / size[next];
    point.uv = V2d(greater ? along : 1 - along, (p[last] - min_[last]) / size[last]);
    point.dpdu = unitAxis(next) * (size[next] * sign);
    point.dpdv = unitAxis(last) * size[last];
    return placement_.toWorld(point);
}

SurfacePoint Box::pointAt(const Ray& ray, const PrimitiveHit& hit) const {
    return pointOf(int(hit.u), placement_.toObject(ray).at(hit.s));
}

std::optional<ShapeSample> Box::sample(const V2f& u) const {
    // One number chooses the face and, stretched to [0, 1) again, the place on it.
    double rest = u.x * area_;
    int face = 0;
    while (face < 5 && rest >= faceArea_[std::size_t(face / 2)])
        rest -= faceArea_[std::size_t(face++ / 2)];
    const int axis = face / 2, next = (axis + 1) % 3, last = (axis + 2) % 3;
    V3d p = min_;
    p[next] = lerp(std::min(rest / faceArea_[std::size_t(axis)], 1.), min_[next], max_[next]);
    p[last] = lerp(double(u.y), min_[last], max_[last]);
    return ShapeSample{pointOf(face, p), float(1 / area_)};
}

} // namespace vitrine
