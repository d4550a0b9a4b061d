#include "nodes/svg_outline.h"

#include "nodes/transforms.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine {

namespace {

/// The largest angle of an arc that one cubic may draw. With handles of 4/3 tan(angle/4) it touches the circle at both
/// ends and in the middle, and between them lies outside by at most (2/27) sin^6(angle/4) / cos^2(angle/4) of the radius
/// (Goldapp 1991, "Approximation of circular arcs by cubic polynomials"): 3.8e-7 for a twelfth of the circle.
constexpr double largestAngle = piD / 6;

/// The angle from u to v, in (-pi, pi].
double angleBetween(const V2d& u, const V2d& v) {
    return std::atan2(u.x * v.y - u.y * v.x, u.dot(v));
}

} // namespace

void SvgOutline::moveTo(const V2d& p) {
    finishSubpath(false);
    start_ = at_ = p;
}

void SvgOutline::add(std::span<const V2d> points) {
    SvgSegment segment;
    segment.degree = int(points.size());
    segment.offset = offset_;
    segment.length = length_;
    segment.points[0] = at_;
    std::copy(points.begin(), points.end(), segment.points.begin() + 1);
    const auto all = segment.controls();
    if (std::all_of(all.begin(), all.end(), [&](const V2d& p) { return p == at_; })) return;
    at_ = points.back();
    subpath_.segments.push_back(segment);
}

void SvgOutline::lineTo(const V2d& p) {
    add({{p}});
}

void SvgOutline::quadTo(const V2d& p1, const V2d& p2) {
    add({{p1, p2}});
}

void SvgOutline::cubicTo(const V2d& p1, const V2d& p2, const V2d& p3) {
    add({{p1, p2, p3}});
}

void SvgOutline::arcTo(V2d radii, double degrees, bool large, bool sweep, const V2d& p) {
    const V2d from = at_;
    if (p == from) return;
    radii = V2d(std::abs(radii.x), std::abs(radii.y));
    if (radii.x == 0 || radii.y == 0) return lineTo(p);
    const double c = cosDegrees(degrees), s = sinDegrees(degrees);
    // SVG 2, B.2.4, on the unit circle: divided by the radii the ellipse is one, and the centre lies on the chord's
    // bisector. `half` is half the way back from p to `from`.
    const V2d d = (from - p) / 2.;
    const V2d half((c * d.x + s * d.y) / radii.x, (c * d.y - s * d.x) / radii.y);
    const double reach = half.length();
    if (!(reach > 0) || !std::isfinite(reach)) return lineTo(p);
    if (reach > 1) radii *= reach;
    const V2d u = reach > 1 ? half / reach : half;
    const double height = std::sqrt(std::max(0., (1 - u.length()) * (1 + u.length()))) / u.length();
    const V2d middle = V2d(u.y, -u.x) * (large == sweep ? -height : height);
    const V2d first = u - middle, last = -u - middle;
    double angle = angleBetween(first, last);
    if (sweep && angle < 0) angle += 2 * piD;
    if (!sweep && angle > 0) angle -= 2 * piD;

    const V2d centre = (from + p) / 2.;
    const auto onEllipse = [&](const V2d& q) {
        const V2d scaled((q.x + middle.x) * radii.x, (q.y + middle.y) * radii.y);
        return V2d(centre.x + c * scaled.x - s * scaled.y, centre.y + s * scaled.x + c * scaled.y);
    };
    const double start = std::atan2(first.y, first.x);
    const int count = std::max(1, int(std::ceil(std::abs(angle) / largestAngle * (1 - 1e-12))));
    const double step = angle / count, handle = 4. / 3 * std::tan(step / 4);
    V2d q0 = first;
    for (int i = 1; i <= count; ++i) {
        const double a = start + step * i;
        const V2d q1 = i == count ? last : V2d(std::cos(a), std::sin(a));
        cubicTo(onEllipse(q0 + V2d(-q0.y, q0.x) * handle), onEllipse(q1 - V2d(-q1.y, q1.x) * handle),
                i == count ? p : onEllipse(q1));
        q0 = q1;
    }
}

void SvgOutline::close() {
    lineTo(start_);
    finishSubpath(true);
    at_ = start_;
}

void SvgOutline::finishSubpath(bool closed) {
    if (subpath_.segments.empty()) return;
    subpath_.closed = closed;
    path_.subpaths.push_back(std::exchange(subpath_, {}));
}

SvgPath SvgOutline::take() {
    finishSubpath(false);
    return std::exchange(path_, {});
}

} // namespace vitrine
