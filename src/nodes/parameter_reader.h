// Tokens -> typed parameters.
#pragma once

#include "nodes/lexer.h"
#include "nodes/parameters.h"

namespace vitrine {

/// Reads `"type name" value` or `"type name" [ values ]` as long as strings follow. Of a name that is given twice the
/// first counts, which is an error in `diagnostics`. \throws SceneError at the first other error
ParameterList readParameters(Lexer& lexer, const std::string& colorSpace, Diagnostics& diagnostics);

/// An Untyped parameter, as if it had been declared with `type`. \throws SceneError when its text is no such value
ParameterPtr withType(const Parameter& untyped, ParameterType type);

/// `type` by pbrt-v4's name (and point, vector, normal3). \throws SceneError with the nearest name at `place`
ParameterType parameterType(std::string_view name, const Place& place);

/// Numbers that make one value of the type; 1 for those that are not made of numbers.
std::size_t itemSize(ParameterType type);

} // namespace vitrine
