#include "plot/ray_section.h"

#include "shapes/revolution/revolution.h"

namespace vitrine::plot {

namespace {

/// Slopes below this are drawn as level, or as upright: no figure shows the difference.
constexpr double levelSlope = 1e-9;

} // namespace

RaySection::RaySection(const Ray& ray) : ray_(ray) {
    const double h = std::hypot(ray.d.x, ray.d.z), v = std::abs(ray.d.y);
    horizontal_ = v <= levelSlope * h;
    axial_ = h <= levelSlope * v;
    closest_ = std::hypot(ray.o.x, ray.o.z);
    if (axial_) return;
    sAtClosest_ = -(ray.o.x * (ray.d.x / h) + ray.o.z * (ray.d.z / h)) / h;
    const double reach = closest_;
    closest_ = std::abs(ray.o.x * (ray.d.z / h) - ray.o.z * (ray.d.x / h));
    if (closest_ < 1e-14 * reach) closest_ = 0; // what rounding leaves of a ray through the axis
    if (horizontal_) return;
    a_ = sqr(h / v);
    b_ = height(sAtClosest_);
}

double RaySection::distance(double s) const {
    if (axial_) return closest_;
    return std::hypot(closest_, (s - sAtClosest_) * std::hypot(ray_.d.x, ray_.d.z));
}

std::pair<double, double> RaySection::stretch(double y0, double y1, double dMax) const {
    double low = -infinityD, high = infinityD;
    if (!horizontal_) {
        const double s0 = (y0 - ray_.o.y) / ray_.d.y, s1 = (y1 - ray_.o.y) / ray_.d.y;
        low = std::min(s0, s1);
        high = std::max(s0, s1);
    } else if (ray_.o.y < y0 || ray_.o.y > y1) {
        return {1, 0};
    }
    if (closest_ > dMax) return {1, 0};
    if (!axial_) {
        const double half = std::sqrt(sqr(dMax) - sqr(closest_)) / std::hypot(ray_.d.x, ray_.d.z);
        low = std::max(low, sAtClosest_ - half);
        high = std::min(high, sAtClosest_ + half);
    }
    return {low, high};
}

std::vector<V2d> RaySection::points(double s0, double s1) const {
    constexpr int count = 400;
    std::vector<double> stations;
    for (int i = 0; i <= count; ++i)
        stations.push_back(lerp(double(i) / count, s0, s1));
    if (sAtClosest_ > s0 && sAtClosest_ < s1)
        stations.insert(std::upper_bound(stations.begin(), stations.end(), sAtClosest_), sAtClosest_);
    std::vector<V2d> result;
    for (const double s : stations)
        result.push_back(at(s));
    return result;
}

std::vector<RayRoot> RaySection::roots(const Profile& profile, double phiMaxDegrees) const {
    const Revolution whole(Transform(), false, profile);
    const PhiRange sector(phiMaxDegrees);
    const int segments = int(profile.segments().size());
    std::vector<RayRoot> result;
    for (const PrimitiveHit& hit : whole.allHits(ray_, -infinityD, infinityD)) {
        const V2d p = profile.evaluate(hit.v).p;
        const V3d at = ray_.at(hit.s);
        const int segment = std::clamp(int(hit.v * segments), 0, segments - 1);
        result.push_back({hit.s, segment, hit.v * segments - segment, p.x, p.y, sector.contains(at.x, at.z)});
    }
    return result;
}

} // namespace vitrine::plot
