#include "plot/palette.h"
#include "plot/panels.h"

#include <fmt/format.h>

namespace vitrine::plot {

namespace {

struct Station {
    double length;    ///< from the profile's beginning
    double curvature; ///< infinite at cusps
    V2d p, tangent;   ///< of unit length, or zero at cusps
};

Station stationAt(const BezierCurve& curve, double t) {
    const CurvePoint c = curve.evaluate(t);
    return {0, curve.curvature(t), c.p, c.d1.length() > 0 ? c.d1.normalized() : V2d(0, 0)};
}

using Stations = std::vector<std::vector<Station>>; ///< of each segment

/// At equal steps of the parameter. Between them lengths are those of chords, scaled so that each segment has its own.
Stations denseStations(const std::vector<BezierCurve>& segments) {
    Stations result;
    double start = 0;
    for (const BezierCurve& curve : segments) {
        std::vector<Station> stations;
        for (int i = 0; i <= denseSteps; ++i) {
            stations.push_back(stationAt(curve, double(i) / denseSteps));
            if (i > 0)
                stations[std::size_t(i)].length =
                    stations[std::size_t(i) - 1].length +
                    (stations[std::size_t(i)].p - stations[std::size_t(i) - 1].p).length();
        }
        const double length = curve.length().value, chords = stations.back().length;
        for (Station& s : stations)
            s.length = start + (chords > 0 ? s.length * (length / chords) : 0);
        start += length;
        result.push_back(std::move(stations));
    }
    return result;
}

/// What of the curvature a figure can show.
struct CurvatureRange {
    double shown = 0;   ///< largest magnitude within the panels
    double largest = 0; ///< of all; infinite for cusps
    bool isCut() const { return shown < largest; }
};

/// A tight rim or a cusp must not flatten the rest: then four times what nine tenths of the length stay below is shown.
CurvatureRange rangeOf(const Stations& stations) {
    struct Share {
        double curvature, length;
    };
    std::vector<Share> shares;
    double total = 0;
    CurvatureRange range;
    for (const auto& segment : stations) {
        for (const Station& s : segment)
            range.largest = std::max(range.largest, std::abs(s.curvature));
        for (std::size_t i = 1; i < segment.size(); ++i) {
            shares.push_back({std::abs(segment[i].curvature), segment[i].length - segment[i - 1].length});
            total += shares.back().length;
        }
    }
    std::sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.curvature < b.curvature; });
    double below = 0, usual = 0;
    for (const Share& share : shares) {
        if (below > 0.9 * total) break;
        below += share.length;
        usual = share.curvature;
    }
    range.shown = range.largest > 8 * usual && usual > 0 ? 4 * usual : range.largest;
    // Nearly straight but for a bend, or curved by rounding alone.
    if (!std::isfinite(range.shown)) range.shown = 100 / total;
    if (range.largest < 1e-9 / total) range = {};
    return range;
}

double clamped(double curvature, const CurvatureRange& range) {
    return std::clamp(curvature, -range.shown, range.shown);
}

/// The largest of 1, 2, 5 times a power of ten that is not above x.
double roundedDown(double x) {
    const double power = std::pow(10, std::floor(std::log10(x)));
    return power * (x >= 5 * power ? 5 : x >= 2 * power ? 2 : 1);
}

/// The left normal is where positive curvature bends to; teeth go the other way.
V2d toothEnd(const Station& s, double scale, const CurvatureRange& range) {
    return s.p - V2d(-s.tangent.y, s.tangent.x) * (scale * clamped(s.curvature, range));
}

std::string cutNote(const CurvatureRange& range) {
    if (!range.isCut()) return "";
    const std::string largest = std::isinf(range.largest) ? "cusp" : "largest " + shown(range.largest, 3);
    return fmt::format("cut at |\u03ba| = {} ({})", shown(range.shown, 3), largest);
}

std::string combNote(const CurvatureRange& range) {
    if (!(range.shown > 0)) return "straight: no curvature";
    return range.isCut() ? "teeth " + cutNote(range) : "teeth point away from the centre of curvature";
}

void drawScaleBar(Figure& figure, const Axes& axes, double scale, const CurvatureRange& range,
                  const std::string& unit) {
    const double curvature = roundedDown(range.shown / 2);
    const double length = scale * curvature * axes.scale().x;
    const V2d end = axes.frame().max + V2d(0, 48), start = end - V2d(length, 0);
    figure.begin("comb-scale");
    figure.add(Line{{start, end}, Pen{combInk, 1.6}});
    for (const V2d& p : {start, end})
        figure.add(Line{{p - V2d(0, 3.5), p + V2d(0, 3.5)}, Pen{combInk, 1.2}});
    figure.add(
        Text{start - V2d(8, -3), "\u03ba = " + shown(curvature) + " " + unit + "^{\u22121}", 9, Anchor::End, combInk});
    figure.end();
}

/// The parameter at which a segment has this length from the profile's beginning.
double parameterAt(const std::vector<Station>& stations, double length) {
    const auto after = std::upper_bound(stations.begin() + 1, stations.end() - 1, length,
                                        [](double value, const Station& s) { return value < s.length; });
    const auto before = after - 1;
    const double step = after->length - before->length;
    const double part = step > 0 ? std::clamp((length - before->length) / step, 0., 1.) : 0;
    return (double(before - stations.begin()) + part) / denseSteps;
}

void drawTeeth(Figure& figure, const Axes& axes, const BezierCurve& segment, const std::vector<Station>& stations,
               double scale, const CurvatureRange& range) {
    const double apart = 3 / axes.scale().x, start = stations.front().length, end = stations.back().length;
    const int count = std::clamp(int((end - start) / apart), 1, 400);
    for (int i = 0; i <= count; ++i) {
        const double t = i == count ? 1 : parameterAt(stations, lerp(double(i) / count, start, end));
        const Station s = stationAt(segment, t);
        figure.add(Line{axes.at(std::vector<V2d>{s.p, toothEnd(s, scale, range)}), Pen{combInk, 0.6, 0.7}});
    }
}

} // namespace

void drawCurvatureComb(Figure& figure, const Box2d& frame, const ProfileDrawing& drawing) {
    const Stations stations = denseStations(drawing.segments);
    const CurvatureRange range = rangeOf(stations);
    Box2d curve, box;
    for (const BezierCurve& segment : drawing.segments)
        curve.extendBy(segment.bounds());
    const double size = std::max(curve.size().x, curve.size().y);
    const double scale = range.shown > 0 ? 0.22 * size / range.shown : 0;
    box = curve;
    std::vector<std::vector<V2d>> envelopes;
    for (const auto& segment : stations) {
        auto& envelope = envelopes.emplace_back();
        for (const Station& s : segment)
            envelope.push_back(toothEnd(s, scale, range));
        for (const V2d& p : envelope)
            box.extendBy(p);
    }
    figure.begin("comb");
    const Axes axes(figure, frame, Axes::equalScale(Axes::padded(box, 0.07), frame),
                    {"Curvature comb", combNote(range), "*x* (" + drawing.unit + ")", "*y* (" + drawing.unit + ")"});
    if (range.shown > 0) {
        for (std::size_t i = 0; i < stations.size(); ++i)
            drawTeeth(figure, axes, drawing.segments[i], stations[i], scale, range);
        for (const auto& envelope : envelopes)
            figure.add(Line{axes.at(envelope), Pen{combInk, 1}});
        drawScaleBar(figure, axes, scale, range, drawing.unit);
    }
    for (std::size_t i = 0; i < drawing.segments.size(); ++i)
        figure.add(Line{axes.at(densePoints(drawing.segments[i])), Pen{colourOfSegment(i), 2}});
    figure.end();
}

void drawCurvature(Figure& figure, const Box2d& frame, const ProfileDrawing& drawing) {
    const Stations stations = denseStations(drawing.segments);
    const CurvatureRange range = rangeOf(stations);
    double lowest = 0, highest = 0;
    for (const auto& segment : stations)
        for (const Station& s : segment) {
            lowest = std::min(lowest, clamped(s.curvature, range));
            highest = std::max(highest, clamped(s.curvature, range));
        }
    if (!(highest > lowest)) lowest = -(highest = 1);
    const double margin = 0.06 * (highest - lowest), end = stations.back().back().length;
    figure.begin("curvature");
    const Axes axes(figure, frame, Box2d(V2d(0, lowest - margin), V2d(end, highest + margin)),
                    {"Curvature over arc length",
                     "positive where the curve turns left" + (range.isCut() ? "; " + cutNote(range) : ""),
                     "arc length \u2113 (" + drawing.unit + ")", "\u03ba (" + drawing.unit + "^{\u22121})"});
    for (std::size_t i = 1; i < stations.size(); ++i) {
        const double joint = stations[i].front().length;
        figure.add(Line{axes.at(std::vector<V2d>{V2d(joint, axes.data().min.y), V2d(joint, axes.data().max.y)}),
                        Pen{axisInk, 0.7, 1, {2, 3}}});
    }
    figure.begin("curve", frame);
    const double beyond = 1e3 * (highest - lowest); // infinite curvature, for the line out of the frame
    for (std::size_t i = 0; i < stations.size(); ++i) {
        std::vector<V2d> points;
        for (const Station& s : stations[i])
            points.push_back(V2d(s.length, std::clamp(s.curvature, -beyond, beyond)));
        figure.add(Line{axes.at(points), Pen{colourOfSegment(i), 1.6}});
    }
    figure.end();
    figure.end();
}

} // namespace vitrine::plot
