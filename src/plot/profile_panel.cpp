#include "plot/palette.h"
#include "plot/panels.h"

namespace vitrine::plot {

namespace {

const Pen faint{polygonInk, 0.9, 1, {4, 3}};

std::vector<V2d> mirrored(std::vector<V2d> points) {
    for (V2d& p : points)
        p.x = -p.x;
    return points;
}

/// Bounds of curve, polygon and the other half.
Box2d bothHalves(const std::vector<BezierCurve>& segments) {
    Box2d box;
    for (const BezierCurve& segment : segments) {
        box.extendBy(segment.controlBounds());
        for (const V2d& p : {segment.bounds().min, segment.bounds().max})
            box.extendBy(V2d(-p.x, p.y));
    }
    box.extendBy(V2d(0, box.min.y));
    return box;
}

void fillSolid(Figure& figure, const Axes& axes, const std::vector<BezierCurve>& segments) {
    std::vector<V2d> outline;
    for (const BezierCurve& segment : segments)
        for (const V2d& p : densePoints(segment))
            outline.push_back(p);
    figure.begin("solid", axes.frame());
    for (const auto& half : {outline, mirrored(outline)})
        figure.add(Line{axes.at(half), {}, Brush{solidInk, 0.18}});
    figure.end();
}

void drawPolygon(Figure& figure, const Axes& axes, const std::vector<BezierCurve>& segments) {
    figure.begin("control-polygon");
    for (const BezierCurve& segment : segments)
        figure.add(Line{axes.at(segment.points()), faint});
    for (const BezierCurve& segment : segments)
        for (std::size_t k = 1; k + 1 < segment.points().size(); ++k)
            figure.add(Disk{axes.at(segment.points()[k]), 2.4, Pen{polygonInk, 1}, Brush{paper}});
    figure.end();
}

/// Finds places for the numbers of segments where they cover neither one another nor the curve.
class NumberPlaces {
  public:
    NumberPlaces(const Axes& axes, const std::vector<BezierCurve>& segments) {
        constexpr int steps = 24;
        for (const BezierCurve& segment : segments)
            for (int i = 0; i <= steps; ++i)
                curve_.push_back(axes.at(segment.point(double(i) / steps)));
    }

    /// The centre of a number for the point, on one side of it or the other, the nearest that is free; none is.
    std::optional<V2d> place(const V2d& point, const V2d& normal) {
        for (const double distance : {9., 15., 22., 30., 39., 50., 62.})
            for (const double side : {1., -1.})
                for (const double turn : {0., 0.5, -0.5, 1., -1.}) {
                    const V2d along(-normal.y, normal.x);
                    const V2d at = point + (normal * std::cos(turn) * side + along * std::sin(turn)) * distance;
                    if (isFree(at)) return numbers_.emplace_back(at);
                }
        return {};
    }

  private:
    bool isFree(const V2d& at) const {
        const auto isApart = [&](double width, double height) {
            return [=](const V2d& p) { return std::abs(p.x - at.x) > width || std::abs(p.y - at.y) > height; };
        };
        return std::all_of(curve_.begin(), curve_.end(), isApart(5.5, 5.5)) &&
               std::all_of(numbers_.begin(), numbers_.end(), isApart(13, 10));
    }

    std::vector<V2d> curve_, numbers_;
};

/// A number that had to be put aside has a line to its segment. Of very many segments only the long ones have numbers.
void drawNumbers(Figure& figure, const Axes& axes, const ProfileDrawing& drawing) {
    constexpr std::size_t many = 60;
    constexpr double beside = 9, baseline = 3;
    const auto& segments = drawing.segments;
    const double outside = drawing.profile && drawing.profile->drawnInsideOut() ? -1 : 1;
    NumberPlaces places(axes, segments);
    figure.begin("segment-numbers");
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const BezierCurve& segment = segments[i];
        if (segments.size() > many && (segment.last() - segment.first()).length() * axes.scale().x < 24) continue;
        const CurvePoint middle = segment.evaluate(0.5);
        V2d tangent = middle.d1.length() > 0 ? middle.d1 : segment.last() - segment.first();
        if (!(tangent.length() > 0)) continue;
        tangent.normalize();
        const V2d point = axes.at(middle.p), normal = V2d(tangent.y, tangent.x) * outside;
        const std::optional<V2d> at = places.place(point, normal);
        if (!at) continue;
        const V2d way = *at - point;
        if (way.length() > beside + 1) {
            const V2d direction = way.normalized();
            figure.add(Line{{point, *at - direction * 5.5}, Pen{colourOfSegment(i), 0.6, 0.8}});
        }
        figure.add(Text{*at + V2d(0, baseline), std::to_string(i), 9, Anchor::Middle, colourOfSegment(i), true});
    }
    figure.end();
}

/// Joints as filled disks, the beginning as a larger one.
void drawJoints(Figure& figure, const Axes& axes, const ProfileDrawing& drawing) {
    const auto& segments = drawing.segments;
    figure.begin("joints");
    const V2d start = axes.at(segments.front().first());
    figure.add(Disk{start, 4.6, Pen{ink, 1.2}, Brush{paper}});
    for (const BezierCurve& segment : segments)
        figure.add(Disk{axes.at(segment.first()), 2.5, Pen{ink, 0.5}, Brush{ink}});
    figure.add(Disk{axes.at(segments.back().last()), 2.5, Pen{ink, 0.5}, Brush{ink}});
    figure.end();
    if (segments.size() > 1) drawNumbers(figure, axes, drawing);
}

void drawRayPath(Figure& figure, const Axes& axes, const ProfileDrawing& drawing) {
    const RaySection section(*drawing.ray);
    const Box2d& shown = axes.data();
    const auto [low, high] = section.stretch(shown.min.y, shown.max.y, shown.max.x);
    const double from = std::max(low, 0.);
    if (from >= high) return;
    std::vector<V2d> path;
    for (const V2d& yd : section.points(from, high))
        path.push_back(axes.at(V2d(yd.y, yd.x)));
    figure.begin("ray-path", axes.frame());
    figure.add(Line{path, Pen{rayInk, 1.1}});
    for (const RayRoot& root : section.roots(*drawing.profile, drawing.phiMaxDegrees))
        if (root.counts()) figure.add(Disk{axes.at(V2d(root.d, root.y)), 2.8, Pen{paper, 0.8}, Brush{rootInk}});
    figure.end();
}

void drawLegend(Figure& figure, V2d at, const ProfileDrawing& drawing) {
    const auto entry = [&](const std::string& text, double room) { at = addLegendEntry(figure, at, text, room); };
    figure.begin("legend");
    addSegmentKey(figure, at);
    entry("segments", 77);
    figure.add(Line{{at, at + V2d(18, 0)}, faint});
    figure.add(Disk{at + V2d(9, 0), 2.4, Pen{polygonInk, 1}, Brush{paper}});
    entry("control points", 100);
    figure.add(Disk{at + V2d(4, 0), 4.6, Pen{ink, 1.2}, Brush{paper}});
    figure.add(Disk{at + V2d(4, 0), 2.5, Pen{ink, 0.5}, Brush{ink}});
    figure.add(Disk{at + V2d(15, 0), 2.5, Pen{ink, 0.5}, Brush{ink}});
    entry("start, joints", 86);
    if (drawing.ray && drawing.profile) {
        figure.add(Line{{at, at + V2d(18, 0)}, Pen{rayInk, 1.1}});
        figure.add(Disk{at + V2d(9, 0), 2.8, Pen{paper, 0.8}, Brush{rootInk}});
        entry("ray", 0);
    }
    figure.end();
}

} // namespace

std::vector<V2d> densePoints(const BezierCurve& curve) {
    std::vector<V2d> points;
    for (int i = 0; i <= denseSteps; ++i)
        points.push_back(curve.point(double(i) / denseSteps));
    return points;
}

void drawProfilePanel(Figure& figure, const Box2d& frame, const ProfileDrawing& drawing) {
    const auto& segments = drawing.segments;
    figure.begin("profile");
    const Axes axes(figure, frame, Axes::equalScale(Axes::padded(bothHalves(segments), 0.07), frame),
                    {"Profile and control polygon", "the other half is faint", "radius *x* (" + drawing.unit + ")",
                     "height *y* (" + drawing.unit + ")"});
    if (drawing.profile && drawing.profile->isClosed()) fillSolid(figure, axes, segments);
    const V2d foot = axes.at(V2d(0, axes.data().min.y)), head = axes.at(V2d(0, axes.data().max.y));
    figure.begin("axis-of-revolution");
    figure.add(Line{{foot, head}, Pen{axisInk, 1, 1, {9, 3, 1.5, 3}}});
    figure.end();
    figure.begin("other-half", frame);
    for (std::size_t i = 0; i < segments.size(); ++i)
        figure.add(Line{axes.at(mirrored(densePoints(segments[i]))), Pen{colourOfSegment(i), 1.2, 0.35}});
    figure.end();
    drawPolygon(figure, axes, segments);
    figure.begin("curve");
    for (std::size_t i = 0; i < segments.size(); ++i)
        figure.add(Line{axes.at(densePoints(segments[i])), Pen{colourOfSegment(i), 2}});
    figure.end();
    drawJoints(figure, axes, drawing);
    if (drawing.ray && drawing.profile) drawRayPath(figure, axes, drawing);
    drawLegend(figure, V2d(frame.min.x, frame.max.y + 48), drawing);
    figure.end();
}

void drawHodograph(Figure& figure, const Box2d& frame, const ProfileDrawing& drawing, int order) {
    std::vector<BezierCurve> hodographs;
    Box2d box(V2d(0, 0), V2d(0, 0)), polygons;
    for (const BezierCurve& segment : drawing.segments) {
        const BezierCurve first = segment.derivative();
        hodographs.push_back(order == 1 ? first : first.derivative());
        box.extendBy(hodographs.back().bounds());
        polygons.extendBy(hodographs.back().controlBounds());
    }
    // The polygon of a high degree reaches so far that the curve would be a dot: then it is cut off.
    const double curveSize = std::max(box.size().x, box.size().y);
    if (std::max(polygons.size().x, polygons.size().y) < 2 * curveSize) box.extendBy(polygons);
    const std::string dash = order == 1 ? "\u2032" : "\u2033";
    figure.begin(order == 1 ? "hodograph-1" : "hodograph-2");
    const Axes axes(figure, frame, Axes::equalScale(Axes::padded(box, 0.08), frame),
                    {order == 1 ? "First derivative by *t*" : "Second derivative by *t*",
                     "each segment from \u25cb, *t* = 0, to \u25cf, *t* = 1", "*x*" + dash + " (" + drawing.unit + ")",
                     "*y*" + dash + " (" + drawing.unit + ")"});
    const V2d origin = axes.at(V2d(0, 0));
    figure.add(Line{{origin - V2d(5, 0), origin + V2d(5, 0)}, Pen{ink, 1}});
    figure.add(Line{{origin - V2d(0, 5), origin + V2d(0, 5)}, Pen{ink, 1}});
    figure.begin("control-polygon", frame);
    for (const BezierCurve& curve : hodographs)
        figure.add(Line{axes.at(curve.points()), Pen{polygonInk, 0.6, 0.8, {3, 3}}});
    figure.end();
    for (std::size_t i = 0; i < hodographs.size(); ++i) {
        const Colour& colour = colourOfSegment(i);
        figure.add(Line{axes.at(densePoints(hodographs[i])), Pen{colour, 1.6}});
        figure.add(Disk{axes.at(hodographs[i].first()), 2.6, Pen{colour, 1.2}, Brush{paper}});
        figure.add(Disk{axes.at(hodographs[i].last()), 2.2, Pen{colour, 1}, Brush{colour}});
    }
    figure.end();
}

} // namespace vitrine::plot
