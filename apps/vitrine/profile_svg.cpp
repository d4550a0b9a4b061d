#include "nodes/parser.h"
#include "profile_drawings.h"
#include "scene/revolution_builder.h"

#include <fmt/format.h>

namespace {

using namespace vitrine;
using plot::ProfileDrawing;

/// All that an outline draws, as it lies in the half-plane of radius and height.
std::vector<BezierCurve> curvesOf(const SvgPath& path, const ProfileFrame& frame) {
    std::vector<BezierCurve> curves;
    for (const SvgSubpath& subpath : path.subpaths)
        for (const SvgSegment& segment : subpath.segments) {
            std::vector<V2d> points;
            for (const V2d& p : segment.controls())
                points.push_back(frame(p));
            curves.emplace_back(std::move(points));
        }
    return curves;
}

ProfileDrawing drawingOf(const SvgElement& element, const SvgDrawing& file, const ProfileFrame& frame,
                         const std::string& unit, std::vector<Diagnostic>& warnings) {
    std::size_t count = 0;
    for (const SvgSubpath& subpath : element.path.subpaths)
        count += subpath.segments.size();
    checkSegments(count, element.place);
    ProfileDrawing drawing;
    const std::string name = element.id.empty() ? element.label : element.id;
    drawing.title =
        plot::unmarked(fmt::format("{}{} at {}:{}", element.tag, name.empty() ? "" : fmt::format(" \"{}\"", name),
                                   element.place.file->name, element.place.line));
    drawing.unit = unit;
    try {
        drawing.profile = profileOfDrawing(element.path, frame, [&](const SvgSegment& segment) {
            return file.placeOf(segment.offset, segment.length);
        });
        drawing.segments = drawing.profile->segments();
    } catch (const SceneError& e) {
        drawing.segments = curvesOf(element.path, frame);
        drawing.fault = plot::unmarked(e.diagnostics().front().message);
        for (Diagnostic diagnostic : e.diagnostics()) {
            diagnostic.severity = Diagnostic::Severity::Warning;
            warnings.push_back(diagnostic);
        }
    }
    drawing.subtitle = describeProfile(drawing);
    return drawing;
}

/// Lengths are in the drawing's unit unless they are scaled.
std::string unitOf(const ParameterSet& parameters) {
    const std::string unit = parameters.getString("unit", "user");
    return unit == "user" || parameters.getFloat("scale", 1) != 1 ? "units" : unit;
}

} // namespace

FoundProfiles profilesOfSvg(const std::string& file, const std::vector<std::string>& settings,
                            const std::optional<Ray>& ray) {
    ParameterList list;
    for (const std::string& setting : settings)
        list.push_back(parseSetting(setting));
    const ParameterSet parameters(std::move(list), {}, "srgb", {});
    const auto svg = std::make_shared<const SvgDrawing>(readSvgFile(file));
    const ProfileFrame frame = frameOfFile(parameters, *svg);
    const std::string unit = unitOf(parameters);
    Diagnostics diagnostics;
    parameters.report(diagnostics);
    diagnostics.throwIfErrors();

    FoundProfiles found;
    for (const SvgElement& element : svg->elements) {
        const FoundProfile profile{
            {element.id, element.label}, !element.rendered || element.fault, [=, &element](auto& warnings) {
                if (element.fault) throw SceneError({*element.fault});
                ProfileDrawing drawing = drawingOf(element, *svg, frame, unit, warnings);
                if (ray && drawing.profile) {
                    drawing.ray = ray;
                    drawing.rayTitle = describeRay("Profile-space", *ray);
                }
                return drawing;
            }};
        found.profiles.push_back(profile);
        if (!element.fault) continue;
        found.warnings.push_back(*element.fault);
        found.warnings.back().severity = Diagnostic::Severity::Warning;
    }
    return found;
}
