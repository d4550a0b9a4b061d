#include "scene/revolution_builder.h"

#include "nodes/lexer.h"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine {

namespace {

/// One that crosses the axis is shown at the segment's point that lies farthest beyond.
Profile profileOfPoints(const ParameterSet& p) {
    const std::vector<V2d> points = p.getPoint2s("P");
    if (points.empty()) throw SceneError(std::vector<Diagnostic>{}); // what is wrong with "P" is recorded
    if (points.size() == 1) throw SceneError(p.place("P"), "a profile needs at least two control points, not one");
    const int degree = p.getInteger("degree", int(points.size()) - 1);
    if (degree > 0 && (points.size() - 1) / std::size_t(degree) > mostSegments)
        throw SceneError(p.place("P"), fmt::format("a profile has at most {} segments, this one has {}", mostSegments,
                                                   (points.size() - 1) / std::size_t(degree)));
    try {
        return Profile(points, degree);
    } catch (const NegativeRadius& e) {
        const auto first = points.begin() + std::ptrdiff_t(e.segment) * degree;
        const auto lowest =
            std::min_element(first, first + degree + 1, [](const V2d& a, const V2d& b) { return a.x < b.x; });
        throw SceneError(p.valuePlace("P", 2 * std::size_t(lowest - points.begin())), e.what());
    }
}

/// \param isFile y points down in SVG files, up in path data that stand in a scene
ProfileFrame frameOf(const ParameterSet& p, bool isFile) {
    ProfileFrame frame;
    frame.lying = p.getChoice("axis", "y", {"y", "x"}) == "x";
    frame.origin = p.getPoint2("origin", V2d(0, 0));
    frame.flipX = p.getBool("flipx", false);
    frame.flipY = p.getBool("flipy", isFile);
    const double scale = p.getFloat("scale", 1);
    if (!(scale > 0)) throw SceneError(p.valuePlace("scale", 0), "\"scale\" must be positive");
    frame.scenePerUnit = V2d(scale, scale);
    return frame;
}

/// Strings of path data, read as one text with line ends between them.
class PathStrings {
  public:
    explicit PathStrings(const ParameterSet& p) : p_(p), strings_(p.getStrings("path")) {
        for (const std::string& s : strings_)
            text_ += s + "\n";
    }
    const std::string& text() const { return text_; }
    Place placeOf(std::size_t offset, std::size_t length) const {
        std::size_t i = 0;
        for (; i + 1 < strings_.size() && offset > strings_[i].size(); ++i)
            offset -= strings_[i].size() + 1;
        return placeInString(p_.valuePlace("path", i), offset, length);
    }

  private:
    const ParameterSet& p_;
    std::vector<std::string> strings_;
    std::string text_;
};

Profile profileOfPath(const ParameterSet& p) {
    const PathStrings data(p);
    const ProfileFrame frame = frameOf(p, false);
    SvgPath path;
    try {
        path = readSvgPath(data.text());
    } catch (const SvgTextError& e) {
        throw SceneError(data.placeOf(e.offset, e.length), e.what(), e.hint);
    }
    if (path.subpaths.empty()) throw SceneError(p.place("path"), "the path draws nothing");
    return profileOfDrawing(path, frame,
                            [&](const SvgSegment& segment) { return data.placeOf(segment.offset, segment.length); });
}

/// Scene units are those of the drawing; or what the file says they are on paper.
V2d scaleOfUnit(const ParameterSet& p, const SvgDrawing& drawing) {
    const std::string unit = p.getChoice("unit", "user", {"user", "mm", "cm", "m", "in"});
    const double millimetres = unit == "mm" ? 1 : unit == "cm" ? 10 : unit == "m" ? 1000 : unit == "in" ? 25.4 : 0;
    return millimetres > 0 ? drawing.millimetresPerUnit / millimetres : V2d(1, 1);
}

Profile profileOfFile(BuildContext& context, const ParameterSet& p) {
    const std::string name = p.getString("filename", "");
    const std::optional<std::string> id = p.findString("id");
    const SvgDrawing drawing = readSvgFile(context.file(p, "filename", name), p.valuePlace("filename", 0));
    const ProfileFrame frame = frameOfFile(p, drawing);
    const SvgElement& element = drawing.choose(id, p.valuePlace(id ? "id" : "filename", 0));
    return profileOfDrawing(element.path, frame,
                            [&](const SvgSegment& segment) { return drawing.placeOf(segment.offset, segment.length); });
}

} // namespace

ProfileFrame frameOfFile(const ParameterSet& parameters, const SvgDrawing& drawing) {
    ProfileFrame frame = frameOf(parameters, true);
    const V2d unit = scaleOfUnit(parameters, drawing);
    frame.scenePerUnit *= unit;
    frame.origin /= unit;
    return frame;
}

Profile buildProfile(BuildContext& context, const ShapeNode& node) {
    const ParameterSet& p = node.parameters;
    std::vector<std::string> given;
    for (const char* name : {"P", "path", "filename"})
        if (p.has(name)) given.push_back(name);
    if (given.empty())
        throw SceneError(node.place,
                         "a revolution needs its profile: \"point2 P\", \"string path\" or \"string filename\"");
    if (given.size() > 1)
        throw SceneError(p.place(given[1]),
                         fmt::format("a revolution takes one profile: \"{}\" or \"{}\"", given[0], given[1]));
    return given[0] == "P" ? profileOfPoints(p) : given[0] == "path" ? profileOfPath(p) : profileOfFile(context, p);
}

} // namespace vitrine
