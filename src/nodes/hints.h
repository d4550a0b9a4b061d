// What scenes written for pbrt-v3 say instead.
#pragma once

#include <string>
#include <string_view>

namespace vitrine {

/// For a directive that pbrt-v4 no longer has: what to do, or "".
std::string hintForOldDirective(std::string_view name);
/// pbrt-v4's name for an older type ("glass" -> "dielectric"), or "". `family` is "material", "light" ...
std::string_view renamedType(std::string_view family, std::string_view name);
/// pbrt-v4's name for an older parameter ("Kd" -> "reflectance"), or "".
std::string_view renamedParameter(std::string_view name);

} // namespace vitrine
