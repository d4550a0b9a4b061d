// Pieces of scene text: how messages show them, and numbers out of them.
#pragma once

#include <string>
#include <string_view>

namespace vitrine {

/// A word of a scene in quotes for a message: at most 40 bytes of it, what is not printable UTF-8 as \xNN.
std::string inQuotes(std::string_view word);

enum class NumberFault { None, NotANumber, NotFinite, TooLarge, NotAnInteger, BeyondInt };

/// A real number in pbrt-v4's syntax (decimal, or hexadecimal integer). Numbers end as floats in the renderer, so that
/// what a float cannot hold is too large; what is too small for a double becomes zero.
NumberFault parseReal(std::string_view word, double& value);

/// An optional sign and digits, within 32 bits.
NumberFault parseInteger(std::string_view word, int& value);

/// What is wrong with `word`, for a message: `expected a number, got "abc"`.
std::string describe(NumberFault fault, std::string_view word);

} // namespace vitrine
