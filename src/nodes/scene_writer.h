// SceneNodes -> scene text in pbrt-v4's format.
#pragma once

#include "nodes/nodes.h"

namespace vitrine {

/// A text that reads back as the same nodes. What it does not keep is how the first text said it: includes are written
/// out, transformations are matrices, and every node stands in a block of its own; inline materials become named ones.
/// Materials that nothing refers to are left out. File names stand as in the nodes: relative to where the text will lie.
/// \param comments lines for its head
/// \throws SceneError for transformations that move
std::string writeScene(const SceneNodes& scene, const std::vector<std::string>& comments = {});

} // namespace vitrine
