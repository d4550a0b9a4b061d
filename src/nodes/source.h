// Scene files into memory.
#pragma once

#include "core/errors.h"

#include <memory>
#include <string>

namespace vitrine {

/// The whole of a file, decompressed when it is gzip; "-" is standard input. \throws FileError
std::string readWholeFile(const std::string& fileName);

/// Refuses what is no text (NUL bytes, UTF-16) once, before every line of it becomes an error. \throws SceneError
void checkIsText(const std::shared_ptr<const SourceFile>& file);

} // namespace vitrine
