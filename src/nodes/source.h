// Scene files into memory.
#pragma once

#include "core/errors.h"

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <string_view>

namespace vitrine {

/// How much text a scene may come to: small files that unpack without end, or are included again and again, must not
/// take all memory. What really lies in files is never too much.
struct TextBudget {
    static constexpr std::uint64_t freeBytes = std::uint64_t(1) << 28;
    /// Bytes of text for each byte of a file. Scenes hardly ever pack better than to a twentieth.
    static constexpr std::uint64_t packing = 32;

    std::uint64_t text = 0, stored = 0; ///< so far
    std::set<std::string> files;        ///< those counted in `stored`
};

/// The whole of a file, decompressed when it is gzip; "-" is standard input. A pipe is read only where the
/// user asked for it by name: one that a scene includes could wait for ever. \throws FileError
std::string readWholeFile(const std::string& fileName, TextBudget& budget, bool allowPipe = false);
/// The same for a file alone.
std::string readWholeFile(const std::string& fileName);

/// Refuses what is no text (NUL bytes, UTF-16) once, before every line of it becomes an error.
/// \param kind what it should be \throws SceneError
void checkIsText(const std::shared_ptr<const SourceFile>& file, std::string_view kind = "a scene");

} // namespace vitrine
