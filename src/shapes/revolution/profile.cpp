#include "shapes/revolution/profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace vitrine {

namespace {

/// How far from the axis, in parts of the profile's size, an end still lies on it: decimal numbers in a file.
constexpr double endTolerance = 1e-12;

std::vector<BezierCurve> cutAtSharedEnds(std::span<const V2d> points, int degree) {
    if (degree < 1 || degree > BezierCurve::maxDegree)
        throw std::invalid_argument(fmt::format("the degree of a profile must be 1 to 60, not {}", degree));
    const std::size_t n = std::size_t(degree);
    if (points.size() < n + 1 || (points.size() - 1) % n != 0)
        throw std::invalid_argument(
            fmt::format("a profile of degree {} needs 1 + {} k control points (segments share their ends), not {}",
                        degree, degree, points.size()));
    std::vector<BezierCurve> segments;
    for (std::size_t i = 0; i + 1 < points.size(); i += n)
        segments.emplace_back(std::vector<V2d>(points.begin() + long(i), points.begin() + long(i + n + 1)));
    return segments;
}

BezierCurve withEnds(const BezierCurve& curve, const V2d& first, const V2d& last) {
    std::vector<V2d> points = curve.points();
    points.front() = first;
    points.back() = last;
    return BezierCurve(std::move(points));
}

/// Whether the control polygon stays within a tenth of its chord: then a ray's polynomial rarely has more than one sign
/// variation, and the ring about the part is thin.
bool isNearlyStraight(const std::vector<V2d>& points) {
    const V2d chord = points.back() - points.front();
    const double length = chord.length();
    for (const V2d& p : points) {
        const V2d d = p - points.front();
        if (std::abs(d.x * chord.y - d.y * chord.x) > 0.1 * length * length) return false;
    }
    return true;
}

void appendCuts(const BezierCurve& curve, double ta, double tb, int depth, std::vector<double>& cuts) {
    if (depth > 0 && !isNearlyStraight(curve.partPoints(ta, tb))) {
        const double tm = (ta + tb) / 2;
        appendCuts(curve, ta, tm, depth - 1, cuts);
        appendCuts(curve, tm, tb, depth - 1, cuts);
    } else {
        cuts.push_back(tb);
    }
}

} // namespace

NegativeRadius::NegativeRadius(std::size_t segmentIndex, double parameter, double radius)
    : std::invalid_argument(
          fmt::format("the radius x(t) of segment {} is {:.6g} at t = {:.6g}; it must not be negative", segmentIndex,
                      radius, parameter)),
      segment(segmentIndex), t(parameter) {}

Profile::Profile(std::span<const V2d> points, int degree) : segments_(cutAtSharedEnds(points, degree)) {
    prepare();
}

Profile::Profile(std::vector<BezierCurve> segments) : segments_(std::move(segments)) {
    if (segments_.empty()) throw std::invalid_argument("a profile needs at least one segment");
    for (std::size_t i = 1; i < segments_.size(); ++i)
        if (segments_[i].first() != segments_[i - 1].last())
            throw std::invalid_argument(fmt::format("segment {} does not begin where the one before ends", i));
    prepare();
}

void Profile::prepare() {
    for (const BezierCurve& segment : segments_)
        for (const V2d& p : segment.points())
            size_ = std::max({size_, std::abs(p.x), std::abs(p.y)});
    snapEnds();
    checkRadius();
    divide();
    if (closed_) {
        double area = 0; // the closing line runs along the axis, where x dy = 0
        for (const BezierCurve& segment : segments_)
            area += segment.areaUnder();
        insideOut_ = area < 0;
    }
}

void Profile::snapEnds() {
    V2d first = segments_.front().first(), last = segments_.back().last();
    for (V2d* end : {&first, &last})
        if (std::abs(end->x) <= endTolerance * size_) end->x = 0;
    if ((last - first).length() <= endTolerance * size_) last = first;
    closed_ = (first.x == 0 && last.x == 0) || first == last;
    segments_.front() = withEnds(segments_.front(), first, segments_.front().last());
    segments_.back() = withEnds(segments_.back(), segments_.back().first(), last);
}

/// The least radius of a segment lies at an end or where x' changes sign.
void Profile::checkRadius() const {
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        std::vector<double> candidates = segments_[i].extrema(0);
        candidates.insert(candidates.end(), {0., 1.});
        for (const double t : candidates) {
            const double x = segments_[i].point(t).x;
            if (x < -endTolerance * size_) throw NegativeRadius(i, t, x);
        }
    }
}

void Profile::divide() {
    constexpr int maxHalvings = 5;
    constexpr double tiny = 1e-9; // a curve that turns within this of a cut is monotone but for its square
    const double count = double(segments_.size());
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        const BezierCurve& segment = segments_[i];
        std::vector<double> turns = segment.monotoneCuts();
        turns.push_back(1);
        std::vector<double> cuts{0.};
        // Curves that join smoothly turn at the joint, or by rounding next to it.
        std::erase_if(turns, [](double t) { return t < tiny || (t > 1 - tiny && t < 1); });
        for (const double turn : turns)
            if (turn - cuts.back() > tiny) appendCuts(segment, cuts.back(), turn, maxHalvings, cuts);
        V2d start = segment.first();
        for (std::size_t k = 1; k < cuts.size(); ++k) {
            std::vector<V2d> part = segment.partPoints(cuts[k - 1], cuts[k]);
            V2d end = cuts[k] == 1 ? segment.last() : part.back();
            if (cuts[k] != 1) end.x = std::max(end.x, 0.);
            part.front() = start;
            part.back() = end;
            parts_.push_back({BezierCurve(std::move(part)), int(i), (double(i) + cuts[k - 1]) / count,
                              (double(i) + cuts[k]) / count});
            start = end;
        }
    }
}

std::size_t Profile::partAt(double v) const {
    const auto next = std::upper_bound(parts_.begin(), parts_.end(), v,
                                       [](double value, const ProfilePart& part) { return value < part.v0; });
    return next == parts_.begin() ? 0 : std::size_t(next - parts_.begin()) - 1;
}

CurvePoint Profile::evaluate(double v) const {
    const double position = std::clamp(v, 0., 1.) * double(segments_.size());
    const std::size_t i = std::min(std::size_t(position), segments_.size() - 1);
    const double scale = double(segments_.size());
    CurvePoint c = segments_[i].evaluate(position - double(i));
    c.d1 *= scale;
    c.d2 *= scale * scale;
    return c;
}

} // namespace vitrine
