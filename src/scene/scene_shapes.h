// The shapes of a scene by themselves, with where they stand in its text: for commands that look at geometry alone.
#pragma once

#include "nodes/nodes.h"
#include "shapes/shape.h"

namespace vitrine {

struct SourceShape {
    const ShapeNode* node; ///< of SceneShapes::nodes
    int object = -1;       ///< index into SceneNodes::objects: the definition that it is in; -1 for none
    std::vector<ShapePtr> shapes;
};

struct SceneShapes {
    std::shared_ptr<const SceneNodes> nodes;
    std::vector<SourceShape> shapes; ///< by file and place
    std::vector<Diagnostic> warnings;
};

/// Builds the shapes of one type, once each however many instances there are, and nothing else: no light, material or
/// camera, whose errors are not found. \throws SceneError for errors in the text and in these shapes, FileError
SceneShapes loadShapes(const std::string& file, const std::string& type);

} // namespace vitrine
