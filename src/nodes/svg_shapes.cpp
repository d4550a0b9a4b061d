#include "nodes/svg_shapes.h"

#include "nodes/svg_outline.h"
#include "nodes/svg_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace vitrine {

namespace {

using Reader = SvgPath (*)(const SvgAttributes&, const SvgExtent&);

SvgOutline outlineOf(const SvgAttributes& in) {
    SvgOutline outline;
    outline.setSource(in.offset(), in.nameLength());
    return outline;
}

SvgPath path(const SvgAttributes& in, const SvgExtent&) {
    SvgPath path = in.read("d", readSvgPath);
    const std::vector<std::size_t> offsets = in.offsetsInFile("d");
    for (SvgSubpath& subpath : path.subpaths)
        for (SvgSegment& segment : subpath.segments) {
            const std::size_t end = offsets[segment.offset + segment.length];
            segment.offset = offsets[segment.offset];
            segment.length = end - segment.offset;
        }
    return path;
}

SvgPath line(const SvgAttributes& in, const SvgExtent& extent) {
    const auto point = [&](const char* x, const char* y) {
        return V2d(in.length(x, extent.size.x, 0), in.length(y, extent.size.y, 0));
    };
    SvgOutline outline = outlineOf(in);
    outline.moveTo(point("x1", "y1"));
    outline.lineTo(point("x2", "y2"));
    return outline.take();
}

SvgOutline throughPoints(const SvgAttributes& in) {
    SvgOutline outline = outlineOf(in);
    const std::vector<std::size_t> offsets = in.offsetsInFile("points");
    in.read("points", [&](std::string_view text) {
        SvgScanner scan(text);
        scan.skipBlanks();
        for (bool first = true; !scan.atEnd(); first = false) {
            const std::size_t begin = scan.offset();
            const double x = scan.number("a coordinate");
            scan.skipSeparator();
            const V2d p(x, scan.number("the y of the last point"));
            outline.setSource(offsets[begin], offsets[scan.offset()] - offsets[begin]);
            if (first)
                outline.moveTo(p);
            else
                outline.lineTo(p);
            scan.skipSeparator();
        }
        return 0;
    });
    return outline;
}

SvgPath polyline(const SvgAttributes& in, const SvgExtent&) {
    return throughPoints(in).take();
}

SvgPath polygon(const SvgAttributes& in, const SvgExtent&) {
    SvgOutline outline = throughPoints(in);
    outline.close();
    return outline.take();
}

/// Nothing when it is not given.
std::optional<double> findExtent(const SvgAttributes& in, const char* name, double hundredPercent) {
    if (!in.has(name) || in.text(name) == "auto") return std::nullopt;
    const double value = in.length(name, hundredPercent, 0);
    if (value < 0) throw in.error(name, fmt::format("\"{}\" must not be negative", name));
    return value;
}

/// The radii of corners or of an ellipse: one that is not given is that of the other.
V2d radii(const SvgAttributes& in, const SvgExtent& extent) {
    const auto rx = findExtent(in, "rx", extent.size.x), ry = findExtent(in, "ry", extent.size.y);
    return V2d(rx.value_or(ry.value_or(0)), ry.value_or(rx.value_or(0)));
}

SvgPath rect(const SvgAttributes& in, const SvgExtent& extent) {
    const V2d corner(in.length("x", extent.size.x, 0), in.length("y", extent.size.y, 0));
    const V2d size(findExtent(in, "width", extent.size.x).value_or(0),
                   findExtent(in, "height", extent.size.y).value_or(0));
    SvgOutline outline = outlineOf(in);
    if (size.x == 0 || size.y == 0) return outline.take(); // not rendered (SVG 2, 10.2)
    const V2d given = radii(in, extent), r(std::min(given.x, size.x / 2), std::min(given.y, size.y / 2));
    const V2d end = corner + size;
    const auto round = [&](double x, double y) { outline.arcTo(r, 0, false, true, V2d(x, y)); };
    outline.moveTo(V2d(corner.x + r.x, corner.y));
    outline.lineTo(V2d(end.x - r.x, corner.y));
    round(end.x, corner.y + r.y);
    outline.lineTo(V2d(end.x, end.y - r.y));
    round(end.x - r.x, end.y);
    outline.lineTo(V2d(corner.x + r.x, end.y));
    round(corner.x, end.y - r.y);
    outline.lineTo(V2d(corner.x, corner.y + r.y));
    round(corner.x + r.x, corner.y);
    outline.close();
    return outline.take();
}

SvgPath wholeEllipse(const SvgAttributes& in, const SvgExtent& extent, const V2d& r) {
    const V2d c(in.length("cx", extent.size.x, 0), in.length("cy", extent.size.y, 0));
    SvgOutline outline = outlineOf(in);
    if (r.x == 0 || r.y == 0) return outline.take(); // not rendered (SVG 2, 10.3)
    outline.moveTo(V2d(c.x + r.x, c.y));
    for (const V2d& p : {V2d(c.x, c.y + r.y), V2d(c.x - r.x, c.y), V2d(c.x, c.y - r.y), V2d(c.x + r.x, c.y)})
        outline.arcTo(r, 0, false, true, p);
    outline.close();
    return outline.take();
}

SvgPath circle(const SvgAttributes& in, const SvgExtent& extent) {
    const double r = findExtent(in, "r", extent.diagonal()).value_or(0);
    return wholeEllipse(in, extent, V2d(r, r));
}

SvgPath ellipse(const SvgAttributes& in, const SvgExtent& extent) {
    return wholeEllipse(in, extent, radii(in, extent));
}

struct ShapeElement {
    std::string_view tag;
    Reader read;
};
constexpr ShapeElement shapeElements[] = {{"path", path},       {"line", line}, {"polyline", polyline},
                                          {"polygon", polygon}, {"rect", rect}, {"circle", circle},
                                          {"ellipse", ellipse}};

const ShapeElement* findShape(std::string_view tag) {
    const auto found = std::find_if(std::begin(shapeElements), std::end(shapeElements),
                                    [&](const ShapeElement& shape) { return shape.tag == tag; });
    return found == std::end(shapeElements) ? nullptr : found;
}

} // namespace

bool isSvgShape(std::string_view tag) {
    return findShape(tag) != nullptr;
}

SvgPath readSvgShape(std::string_view tag, const SvgAttributes& attributes, const SvgExtent& extent) {
    return findShape(tag)->read(attributes, extent);
}

} // namespace vitrine
