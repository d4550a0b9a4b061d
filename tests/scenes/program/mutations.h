// Scene texts with faults, a pure function of the original and a number.
#pragma once

#include <cstdint>
#include <string>

namespace vitrine::test {

/// One to three faults, most often one: flipped, changed, missing or doubled bytes, tokens and lines; numbers replaced by
/// extremes, longer or shorter lists; types and names replaced by others; the end cut off.
std::string mutated(const std::string& text, std::uint64_t number);

} // namespace vitrine::test
