// Typed parameters -> text.
#pragma once

#include "nodes/parameters.h"

namespace vitrine {

/// The string in double quotes, with pbrt-v4's escapes.
std::string quotedString(std::string_view text);

/// `"type name" [ values ]`, long lists broken into lines that begin with `indent`. Numbers have the digits they need to
/// read back the same.
std::string parameterText(const Parameter& parameter, const std::string& indent);

} // namespace vitrine
