// Files that are either the old one or the new one, never half of it.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>

namespace vitrine {

/// Writes the pieces, one after the other, beside `path` and renames, so that a full disk or a kill leaves the old file as it was. Symbolic
/// links are followed; what exists and is no regular file (a pipe, a device) is written to as it is. \throws FileError
void replaceFile(const std::string& path, std::initializer_list<std::span<const std::byte>> pieces);

/// Finds out whether replaceFile() could begin: a name, rights and a folder that takes files. \throws FileError
void checkReplaceable(const std::string& path);

} // namespace vitrine
