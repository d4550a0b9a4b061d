#include "nodes/source.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

namespace vitrine {

namespace {

struct GzClose {
    void operator()(gzFile file) const { gzclose(file); }
};
using GzHandle = std::unique_ptr<gzFile_s, GzClose>;

/// A device such as /dev/zero never ends; a pipe does.
void checkKind(const std::string& fileName, bool allowPipe) {
    std::error_code error;
    const auto status = std::filesystem::status(fileName, error);
    if (!std::filesystem::exists(status)) throw FileError(fileName, "no such file");
    if (std::filesystem::is_directory(status)) throw FileError(fileName, "is a directory");
    if (!std::filesystem::is_regular_file(status) && !(allowPipe && std::filesystem::is_fifo(status)))
        throw FileError(fileName, "is not a regular file");
}

/// Bytes of the file that `unpacked` bytes have come from so far.
std::uint64_t storedBytes(gzFile file, std::uint64_t unpacked) {
    if (const auto offset = gzoffset(file); offset >= 0) return std::uint64_t(offset);
    // A pipe has no position. Of one that is packed nothing is known.
    return gzdirect(file) ? unpacked : 0;
}

} // namespace

std::string readWholeFile(const std::string& fileName) {
    TextBudget budget;
    return readWholeFile(fileName, budget);
}

std::string readWholeFile(const std::string& fileName, TextBudget& budget, bool allowPipe) {
    const bool standardInput = fileName == "-";
    if (!standardInput) checkKind(fileName, allowPipe);
    errno = 0;
    // zlib hands plain files through as they are.
    const GzHandle file(standardInput ? gzdopen(0, "rb") : gzopen(fileName.c_str(), "rb"));
    if (!file) throw FileError(fileName, errno ? std::strerror(errno) : "cannot be opened");
    gzbuffer(file.get(), 1u << 17);
    std::error_code ignored;
    const bool isNew = budget.files.insert(std::filesystem::weakly_canonical(fileName, ignored).string()).second;
    std::string text;
    std::uint64_t stored = 0;
    // Most files are small; the pieces grow with those that are not.
    for (unsigned chunk = 1u << 14;; chunk = std::min(2 * chunk, 1u << 26)) {
        const std::size_t size = text.size();
        text.resize(size + chunk);
        const int got = gzread(file.get(), text.data() + size, chunk);
        text.resize(size + std::size_t(std::max(0, got)));
        if (isNew) stored = storedBytes(file.get(), text.size());
        if (budget.text + text.size() > TextBudget::freeBytes + TextBudget::packing * (budget.stored + stored))
            throw FileError(fileName, fmt::format("with it the scene has more than {} MiB of text and {} times what "
                                                  "lies in its files: they are packed, or included again and again",
                                                  TextBudget::freeBytes >> 20, TextBudget::packing));
        if (got > 0) continue;
        int code = Z_OK;
        const char* message = gzerror(file.get(), &code);
        if (code == Z_ERRNO) throw FileError(fileName, std::strerror(errno));
        if (code == Z_BUF_ERROR) throw FileError(fileName, "the compressed file is cut off");
        if (got < 0 || (code != Z_OK && code != Z_STREAM_END)) throw FileError(fileName, message);
        text.shrink_to_fit();
        budget.text += text.size();
        budget.stored += stored;
        return text;
    }
}

void checkIsText(const std::shared_ptr<const SourceFile>& file, std::string_view kind) {
    const std::string_view text = file->text;
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw SceneError(Place{file}, "the file is UTF-16", "save it as UTF-8");
    const std::size_t zero = text.find('\0');
    if (zero == std::string_view::npos) return;
    const std::string_view before = text.substr(0, zero);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t lineStart = before.rfind('\n') + 1;
    throw SceneError(Place{file, int(line), int(zero - lineStart) + 1},
                     fmt::format("a NUL byte: this is not the text of {}", kind));
}

} // namespace vitrine
