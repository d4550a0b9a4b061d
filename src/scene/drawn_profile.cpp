#include "scene/drawn_profile.h"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine {

namespace {

/// A segment in radius and height.
struct Piece {
    std::vector<V2d> points;
    const SvgSegment* source;

    bool isWithin(double tolerance, const V2d& p) const {
        return std::all_of(points.begin(), points.end(), [&](const V2d& q) { return (q - p).length() <= tolerance; });
    }
    bool isOnAxis() const {
        return std::all_of(points.begin(), points.end(), [](const V2d& q) { return q.x == 0; });
    }
};
using Pieces = std::vector<Piece>;

Pieces mapped(const SvgSubpath& subpath, const ProfileFrame& frame) {
    Pieces pieces;
    for (const SvgSegment& segment : subpath.segments) {
        Piece& piece = pieces.emplace_back(Piece{{}, &segment});
        for (const V2d& p : segment.controls())
            piece.points.push_back(frame(p));
    }
    return pieces;
}

/// In radius from the axis and in height.
Imath::Box2d boundsOf(const Pieces& pieces) {
    Imath::Box2d bounds;
    for (const Piece& piece : pieces)
        for (const V2d& p : piece.points)
            bounds.extendBy(p);
    return bounds;
}

/// Points next to the axis go onto it, ends that nearly meet are joined, segments of no length dropped.
void snap(Pieces& pieces, double tolerance) {
    Pieces kept;
    for (Piece& piece : pieces) {
        for (V2d& p : piece.points)
            if (std::abs(p.x) <= tolerance) p.x = 0;
        if (!kept.empty()) piece.points.front() = kept.back().points.back();
        if (!piece.isWithin(tolerance, piece.points.front())) kept.push_back(std::move(piece));
    }
    pieces = std::move(kept);
    if (pieces.empty()) return;
    const V2d first = pieces.front().points.front();
    V2d& last = pieces.back().points.back();
    if ((last - first).length() <= tolerance) last = first;
}

/// Lines along the axis turn into nothing. Those at the ends are cut off; an outline that closes along the axis is taken
/// from there on, so that its ends are the profile's.
void trimAxis(Pieces& pieces) {
    if (pieces.empty()) return;
    const bool closed = pieces.front().points.front() == pieces.back().points.back();
    const auto isOnAxis = [](const Piece& piece) { return piece.isOnAxis(); };
    if (closed)
        if (const auto onAxis = std::find_if(pieces.begin(), pieces.end(), isOnAxis); onAxis != pieces.end())
            std::rotate(pieces.begin(), onAxis, pieces.end());
    pieces.erase(pieces.begin(), std::find_if_not(pieces.begin(), pieces.end(), isOnAxis));
    pieces.erase(std::find_if_not(pieces.rbegin(), pieces.rend(), isOnAxis).base(), pieces.end());
}

/// What may be wrong with a profile that goes beyond the axis.
std::string axisHint(const ProfileFrame& frame, bool wholly) {
    const std::string axis = fmt::format("the axis is {} = {:g} in the drawing: \"point2 origin\" moves it",
                                         frame.lying ? "y" : "x", frame.lying ? frame.origin.y : frame.origin.x);
    if (!wholly) return axis;
    return fmt::format("{}, \"bool {}\" {} mirrors the profile", axis, frame.lying ? "flipy" : "flipx",
                       !(frame.lying ? frame.flipY : frame.flipX));
}

} // namespace

V2d ProfileFrame::operator()(const V2d& p) const {
    V2d d = (p - origin) * scenePerUnit;
    if (flipX) d.x = -d.x;
    if (flipY) d.y = -d.y;
    return lying ? V2d(d.y, d.x) : d;
}

Profile profileOfDrawing(const SvgPath& path, const ProfileFrame& frame,
                         const std::function<Place(const SvgSegment&)>& placeOf) {
    if (path.subpaths.size() > 1)
        throw SceneError(placeOf(path.subpaths[1].segments[0]),
                         fmt::format("a profile is a single line, but this path has {}: here begins the second",
                                     path.subpaths.size()),
                         "give each its own shape (Inkscape: Path > Break Apart)");
    const SvgSubpath& line = path.subpaths.at(0);
    const SvgSegment& first = line.segments.at(0);
    if (line.segments.size() > mostSegments)
        throw SceneError(
            placeOf(first),
            fmt::format("a profile has at most {} segments, this one has {}", mostSegments, line.segments.size()),
            "simplify the line (Inkscape: Path > Simplify)");
    Pieces pieces = mapped(line, frame);
    const Imath::Box2d bounds = boundsOf(pieces);
    const double radius = std::max(-bounds.min.x, bounds.max.x);
    const double tolerance = drawingTolerance * std::max(radius, bounds.max.y - bounds.min.y);
    if (bounds.max.x <= tolerance && bounds.min.x < -tolerance)
        throw SceneError(placeOf(first), "the whole profile lies beyond the axis, where its radius is negative",
                         axisHint(frame, true));
    snap(pieces, tolerance);
    trimAxis(pieces);
    if (pieces.empty()) throw SceneError(placeOf(first), "the profile does not leave the axis: it has no surface");

    std::vector<BezierCurve> curves;
    for (const Piece& piece : pieces)
        curves.emplace_back(piece.points);
    try {
        return Profile(std::move(curves));
    } catch (const NegativeRadius& e) {
        const SvgSegment& source = *pieces[e.segment].source;
        const auto controls = source.controls();
        const V2d at = BezierCurve(std::vector<V2d>(controls.begin(), controls.end())).point(e.t);
        throw SceneError(placeOf(source),
                         fmt::format("the radius x(t) is {:.6g} at t = {:.6g} of this segment, ({:.6g}, {:.6g}) in the "
                                     "drawing; it must not be negative",
                                     BezierCurve(pieces[e.segment].points).point(e.t).x, e.t, at.x, at.y),
                         axisHint(frame, false));
    } catch (const std::invalid_argument& e) {
        throw SceneError(placeOf(first), e.what());
    }
}

} // namespace vitrine
