// The Option directive: pbrt-v4's table of names and types, and "texturecachemb".
#pragma once

#include "nodes/lexer.h"
#include "nodes/nodes.h"

namespace vitrine {

/// Reads `"name" value` after the word Option. \throws SceneError
OptionNode readOption(Lexer& lexer);

} // namespace vitrine
