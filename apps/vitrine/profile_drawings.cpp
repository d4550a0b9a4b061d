#include "profile_drawings.h"

#include "plot/axes.h"
#include "scene/scene_shapes.h"
#include "shapes/revolution/revolution.h"

#include <fmt/format.h>

#include <set>

namespace {

using namespace vitrine;
using plot::ProfileDrawing;
using plot::shown;

/// The ways from the shape's space to the world, one for each instance.
std::vector<Transform> placements(const SceneNodes& nodes, const SourceShape& shape) {
    const Transform& own = shape.node->worldFromObject->start;
    if (shape.object < 0) return {own};
    std::vector<Transform> result;
    for (const InstanceNode& instance : nodes.instances) {
        if (instance.object != shape.object) continue;
        if (instance.worldFromInstance->isMoving())
            throw SceneError(instance.place, "a moving instance has no one place for --ray");
        result.push_back(own.then(instance.worldFromInstance->start));
    }
    return result;
}

/// The ray in the space of the instance that it meets first, or of the first one when it meets none.
void placeRay(ProfileDrawing& drawing, const Ray& ray, const std::vector<Transform>& worldFromObject) {
    double nearest = infinityD;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < worldFromObject.size(); ++i) {
        const plot::RaySection section(worldFromObject[i].inverse().ray(ray));
        for (const auto& root : section.roots(*drawing.profile, drawing.phiMaxDegrees))
            if (root.counts() && root.s < nearest) {
                nearest = root.s;
                chosen = i;
            }
    }
    drawing.ray = worldFromObject[chosen].inverse().ray(ray);
    drawing.rayTitle = describeRay("World-space", ray);
    if (worldFromObject.size() > 1)
        drawing.rayTitle += fmt::format(", seen from instance {} of {}", chosen + 1, worldFromObject.size());
}

ProfileDrawing drawingOf(const Revolution& revolution, const SourceShape& source, const SceneNodes& nodes,
                         const std::optional<Ray>& ray) {
    const Place& place = source.node->place;
    checkSegments(revolution.profile().segments().size(), place);
    ProfileDrawing drawing;
    drawing.title = "Revolution at " + plot::unmarked(fmt::format("{}:{}", place.file->name, place.line));
    drawing.unit = "units";
    drawing.segments = revolution.profile().segments();
    drawing.profile = revolution.profile();
    drawing.phiMaxDegrees = revolution.phiMaxDegrees();
    drawing.subtitle = describeProfile(drawing);
    if (source.object >= 0) {
        const std::string& name = nodes.objects[std::size_t(source.object)].name;
        drawing.subtitle += fmt::format("; in object \"{}\"", plot::unmarked(name));
    }
    if (ray) {
        const auto worldFromObject = placements(nodes, source);
        if (worldFromObject.empty())
            drawing.subtitle += ", which has no instance for the ray to meet";
        else
            placeRay(drawing, *ray, worldFromObject);
    }
    return drawing;
}

} // namespace

void checkSegments(std::size_t count, const Place& place) {
    if (count > mostSegmentsInFigure)
        throw SceneError(
            place, fmt::format("a figure shows at most {} segments, this profile has {}", mostSegmentsInFigure, count),
            "--only chooses another one");
}

std::string describeProfile(const ProfileDrawing& drawing) {
    std::set<int> degrees;
    std::size_t points = 1;
    double length = 0;
    Imath::Box2d box;
    for (const BezierCurve& segment : drawing.segments) {
        degrees.insert(segment.degree());
        points += std::size_t(segment.degree());
        length += segment.length().value;
        box.extendBy(segment.bounds());
    }
    const std::string degree = degrees.size() == 1
                                   ? fmt::format("degree {}", *degrees.begin())
                                   : fmt::format("degrees {} to {}", *degrees.begin(), *degrees.rbegin());
    const std::size_t count = drawing.segments.size();
    return fmt::format("{}{} of {}, {} control points; length {} {}, radius {} to {}, height {} to {}",
                       !drawing.profile              ? ""
                       : drawing.profile->isClosed() ? "closed: "
                                                     : "open: ",
                       count == 1 ? "one segment" : fmt::format("{} segments", count), degree, points, shown(length, 5),
                       drawing.unit, shown(box.min.x), shown(box.max.x), shown(box.min.y), shown(box.max.y));
}

std::string describeRay(const std::string& space, const Ray& r) {
    return fmt::format("{} ray from ({}, {}, {}) along ({}, {}, {})", space, shown(r.o.x), shown(r.o.y), shown(r.o.z),
                       shown(r.d.x), shown(r.d.y), shown(r.d.z));
}

FoundProfiles profilesOfScene(const std::string& file, const std::optional<Ray>& ray) {
    const SceneShapes scene = loadShapes(file, "revolution");
    FoundProfiles found;
    found.warnings = scene.warnings;
    for (const SourceShape& source : scene.shapes)
        for (const ShapePtr& shape : source.shapes)
            found.profiles.push_back({{}, false, [shape, source, nodes = scene.nodes, ray](std::vector<Diagnostic>&) {
                                          return drawingOf(dynamic_cast<const Revolution&>(*shape), source, *nodes,
                                                           ray);
                                      }});
    return found;
}
