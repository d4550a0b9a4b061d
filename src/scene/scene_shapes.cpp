#include "scene/scene_shapes.h"

#include "nodes/parser.h"
#include "scene/world_builder.h"

#include <tuple>

namespace vitrine {

SceneShapes loadShapes(const std::string& file, const std::string& type) {
    SceneShapes result;
    const auto nodes = std::make_shared<const SceneNodes>(parseSceneFile(file));
    result.nodes = nodes;
    Diagnostics diagnostics;
    BuildContext context(*nodes, diagnostics);
    const auto add = [&](const std::vector<ShapeNode>& shapes, int object) {
        for (const ShapeNode& node : shapes)
            if (node.type == type) result.shapes.push_back({&node, object, buildShape(context, node)});
    };
    add(nodes->shapes, -1);
    for (std::size_t i = 0; i < nodes->objects.size(); ++i)
        add(nodes->objects[i].shapes, int(i));
    diagnostics.throwIfErrors();

    const auto rank = [&](const SourceShape& shape) {
        const Place& place = shape.node->place;
        const auto source = std::find(nodes->sources.begin(), nodes->sources.end(), place.file);
        return std::tuple(source - nodes->sources.begin(), place.line, place.column);
    };
    std::stable_sort(result.shapes.begin(), result.shapes.end(),
                     [&](const SourceShape& a, const SourceShape& b) { return rank(a) < rank(b); });
    result.warnings = nodes->warnings;
    for (const Diagnostic& warning : diagnostics.all())
        result.warnings.push_back(warning);
    return result;
}

} // namespace vitrine
