// Files that are either the old one or the new one, never half of it.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace vitrine {

/// Writes `bytes` beside `path` and renames, so that a full disk or a kill leaves the old file as it was. Symbolic
/// links are followed; what exists and is no regular file (a pipe, a device) is written to as it is. \throws FileError
void replaceFile(const std::string& path, std::span<const std::byte> bytes);

} // namespace vitrine
