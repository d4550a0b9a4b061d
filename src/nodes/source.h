// Scene files into memory.
#pragma once

#include "core/errors.h"

#include <memory>
#include <string>

namespace vitrine {

/// The whole of a file, decompressed when it is gzip; "-" is standard input. A pipe is read only where the
/// user asked for it by name: one that a scene includes could wait for ever. \throws FileError
std::string readWholeFile(const std::string& fileName, bool allowPipe = false);

/// Refuses what is no text (NUL bytes, UTF-16) once, before every line of it becomes an error. \throws SceneError
void checkIsText(const std::shared_ptr<const SourceFile>& file);

} // namespace vitrine
