#include "plot/palette.h"
#include "plot/panels.h"

#include <fmt/format.h>

#include <tuple>

namespace vitrine::plot {

namespace {

const Pen behindPen{rayInk, 1, 0.8, {2, 3}};

/// One ray and what its panels share.
struct RayScene {
    const ProfileDrawing& drawing;
    RaySection section;
    std::vector<RayRoot> roots;
    Box2d data; ///< of (y, d)

    explicit RayScene(const ProfileDrawing& d)
        : drawing(d), section(*d.ray), roots(section.roots(*d.profile, d.phiMaxDegrees)) {
        Box2d box;
        for (const BezierCurve& segment : d.segments)
            box.extendBy(segment.bounds());
        const double extent = std::max(box.size().y, box.max.x);
        const double margin = 0.12 * std::max(box.size().y, 0.2 * extent);
        // A ray that passes a little outside of the profile still shows.
        const double reach = section.closest() < 2 * extent ? std::max(box.max.x, section.closest()) : box.max.x;
        data = Box2d(V2d(box.min.y - margin, 0), V2d(box.max.y + margin, 1.2 * std::max(reach, 0.05 * extent)));
        const double y = d.ray->o.y;
        if (section.isHorizontal() && std::abs(y - box.center().y) < 2 * extent)
            data.extendBy(V2d(y < box.center().y ? y - margin : y + margin, 0));
    }
    const std::string& unit() const { return drawing.unit; }
    std::pair<double, double> stretch() const { return section.stretch(data.min.x, data.max.x, data.max.y); }
};

/// The part of [low, high] behind the origin of the ray, dotted, and the part before it.
template <class Points>
void drawBothParts(Figure& figure, const Axes& axes, double low, double high, const Points& points) {
    figure.begin("d-ray", axes.frame());
    if (low < std::min(high, 0.)) figure.add(Line{axes.at(points(low, std::min(high, 0.))), behindPen});
    if (std::max(low, 0.) < high) figure.add(Line{axes.at(points(std::max(low, 0.), high)), Pen{rayInk, 1.8}});
    figure.end();
}

/// Numbers of roots go to the left on the ray's way towards the axis and to the right on its way out, above an axial
/// ray; one below the other where there is no room beside the mark.
void drawNumbers(Figure& figure, const std::vector<V2d>& marks, const RayScene& scene) {
    constexpr double lineHeight = 9.5, lineWidth = 14, aside = 5;
    const bool above = scene.section.isAxial();
    for (const bool outwards : {false, true}) {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < marks.size(); ++i)
            if ((scene.roots[i].s > scene.section.sAtClosest()) == outwards) order.push_back(i);
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return std::tie(marks[a].y, a) < std::tie(marks[b].y, b); });
        std::vector<V2d> placed;
        for (const std::size_t i : order) {
            V2d at = marks[i] + (above ? V2d(0, -9) : V2d(outwards ? aside : -aside, -3));
            for (const V2d& other : placed)
                if (std::abs(other.x - at.x) < lineWidth && std::abs(other.y - at.y) < lineHeight)
                    at.y = other.y + (above ? -lineHeight : lineHeight);
            placed.push_back(at);
            const Anchor anchor = above ? Anchor::Middle : outwards ? Anchor::Start : Anchor::End;
            figure.add(Text{at, std::to_string(i + 1), 9, anchor, rootInk, true});
        }
    }
}

void drawRootMarks(Figure& figure, const Axes& axes, const RayScene& scene, bool overS) {
    std::vector<V2d> marks;
    figure.begin("roots", axes.frame());
    for (const RayRoot& root : scene.roots) {
        marks.push_back(axes.at(V2d(overS ? root.s : root.y, root.d)));
        if (root.counts())
            figure.add(Disk{marks.back(), 3.4, Pen{paper, 0.9}, Brush{rootInk}});
        else
            figure.add(Disk{marks.back(), 3, Pen{rootInk, 1}, Brush{paper}});
    }
    drawNumbers(figure, marks, scene);
    figure.end();
}

void drawOrigin(Figure& figure, const Axes& axes, const V2d& data) {
    if (!axes.data().intersects(data)) return;
    const V2d p = axes.at(data);
    figure.add(Disk{p, 3.2, Pen{rayInk, 1.4}, Brush{paper}});
    figure.add(Text{p + V2d(-6, -6), "*s* = 0", 9, Anchor::End, rayInk});
}

std::string curveNote(const RaySection& section) {
    const std::string c = shown(section.c());
    if (section.isHorizontal())
        return fmt::format("horizontal ray: *y* = {} and *d*_{{r}} \u2265 {}", shown(section.height(0), 6),
                           shown(section.closest()));
    if (section.isAxial()) return "ray along the axis: *d*_{r} = " + shown(section.closest(), 6);
    return fmt::format("*d*_{{r}}(*y*) = \u221a(*a* (*y* \u2212 *b*)^{{2}} + *c*),  *a* = {}, *b* = {}, *c* = {}",
                       shown(section.a()), shown(section.b()), c);
}

void drawDistanceOverHeight(Figure& figure, const Box2d& frame, const RayScene& scene) {
    figure.begin("distance-over-height");
    const Axes axes(figure, frame, scene.data,
                    {"Distance from the axis over height", curveNote(scene.section),
                     "height *y* (" + scene.unit() + ")", "*d* (" + scene.unit() + ")"});
    figure.begin("d-profile", frame);
    for (std::size_t i = 0; i < scene.drawing.segments.size(); ++i) {
        std::vector<V2d> points = densePoints(scene.drawing.segments[i]);
        for (V2d& p : points)
            std::swap(p.x, p.y);
        figure.add(Line{axes.at(points), Pen{colourOfSegment(i), 2}});
    }
    figure.end();
    const RaySection& section = scene.section;
    if (section.isHorizontal()) // what the ray does not reach of the height at which it runs
        figure.add(Line{{axes.at(V2d(section.height(0), 0)), axes.at(V2d(section.height(0), scene.data.max.y))},
                        Pen{axisInk, 0.8, 1, {2, 3}}});
    const auto [low, high] = scene.stretch();
    drawBothParts(figure, axes, low, high, [&](double s0, double s1) { return section.points(s0, s1); });
    drawOrigin(figure, axes, section.at(0));
    drawRootMarks(figure, axes, scene, false);
    if (low > high)
        figure.add(Text{V2d(frame.center().x, frame.min.y + 16), "the ray passes outside of this figure", 10,
                        Anchor::Middle, rayInk});
    figure.end();
}

/// For a horizontal ray: d_r over s, and the radii that the profile has at that height.
void drawDistanceOverS(Figure& figure, const Box2d& frame, const RayScene& scene) {
    const RaySection& section = scene.section;
    auto [low, high] = scene.stretch();
    if (!(low < high)) return;
    if (low > 0 && low < 0.5 * (high - low)) low = -0.05 * high; // the origin is near enough to be shown
    const double margin = 0.04 * (high - low);
    figure.begin("distance-over-s");
    const Axes axes(figure, frame, Box2d(V2d(low - margin, 0), V2d(high + margin, scene.data.max.y)),
                    {"Distance over the ray's parameter",
                     "dashed: radii *x*(*t*) where *y*(*t*) = " + shown(section.height(0), 6), "*s*",
                     "*d* (" + scene.unit() + ")"});
    figure.begin("radii", frame);
    for (const RayRoot& root : scene.roots)
        figure.add(Line{{axes.at(V2d(axes.data().min.x, root.d)), axes.at(V2d(axes.data().max.x, root.d))},
                        Pen{colourOfSegment(std::size_t(root.segment)), 1.2, 1, {5, 3}}});
    figure.end();
    drawBothParts(figure, axes, low, high, [&](double s0, double s1) {
        std::vector<V2d> points;
        for (int i = 0; i <= denseSteps; ++i) {
            const double s = lerp(double(i) / denseSteps, s0, s1);
            points.push_back(V2d(s, section.distance(s)));
        }
        return points;
    });
    drawOrigin(figure, axes, V2d(0, section.distance(0)));
    drawRootMarks(figure, axes, scene, true);
    figure.end();
}

void drawLegend(Figure& figure, V2d at) {
    const auto entry = [&](const std::string& text, double room) { at = addLegendEntry(figure, at, text, room); };
    figure.begin("legend");
    addSegmentKey(figure, at);
    entry("profile *d*_{b}(*y*)", 100);
    figure.add(Line{{at, at + V2d(18, 0)}, Pen{rayInk, 1.8}});
    entry("ray *d*_{r}(*y*)", 82);
    figure.add(Line{{at, at + V2d(18, 0)}, behindPen});
    entry("behind its origin", 112);
    figure.add(Disk{at + V2d(12, 0), 3.4, Pen{paper, 0.9}, Brush{rootInk}});
    entry("roots", 0);
    figure.end();
}

} // namespace

double drawRay(Figure& figure, double top, const ProfileDrawing& drawing) {
    constexpr double left = 64, tableLeft = 652, gap = 62;
    const RayScene scene(drawing);
    figure.begin("ray");
    figure.add(Text{V2d(left, top + 12), drawing.rayTitle, 10.5, Anchor::Start, rayInk});
    const double upper = top + 56, lower = upper + std::max(230., rootTableHeight(scene.roots.size()));
    const double end = tableLeft - 48, middle = (left + end) / 2;
    if (scene.section.isHorizontal()) {
        drawDistanceOverHeight(figure, Box2d(V2d(left, upper), V2d(middle - gap / 2, lower)), scene);
        drawDistanceOverS(figure, Box2d(V2d(middle + gap / 2, upper), V2d(end, lower)), scene);
    } else {
        drawDistanceOverHeight(figure, Box2d(V2d(left, upper), V2d(end, lower)), scene);
    }
    drawLegend(figure, V2d(left, lower + 48));
    drawRootTable(figure, V2d(tableLeft, upper), scene.roots, drawing.phiMaxDegrees);
    figure.end();
    return lower + 68 - top;
}

} // namespace vitrine::plot
