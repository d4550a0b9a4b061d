#include "textures/texel_file.h"

#include "core/errors.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>
#include <vector>

namespace vitrine {

namespace {

std::vector<std::string> folders() {
    const char* const chosen = std::getenv("TMPDIR");
    if (chosen && *chosen) return {chosen};
    return {"/var/tmp", "/tmp"};
}

/// A file without a name in `folder`, or -1.
int openNameless(const std::string& folder) {
    if (const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600); descriptor >= 0)
        return descriptor;
    // Not every file system knows O_TMPFILE.
    std::string name = folder + "/vitrine-texels-XXXXXX";
    const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
    if (descriptor >= 0) ::unlink(name.c_str());
    return descriptor;
}

} // namespace

TexelFile::TexelFile() {
    std::string problem;
    for (const auto& folder : folders()) {
        folder_ = folder;
        descriptor_ = openNameless(folder);
        if (descriptor_ >= 0) return;
        problem = std::strerror(errno);
    }
    throw FileError(folder_, "no temporary file for textures can be made here (TMPDIR chooses the folder): " + problem);
}

TexelFile::~TexelFile() {
    ::close(descriptor_);
}

std::uint64_t TexelFile::reserve(std::uint64_t size) {
    const std::uint64_t offset = size_;
    size_ += size;
    return offset;
}

void TexelFile::write(std::uint64_t offset, const void* data, std::size_t size) {
    const char* from = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = ::pwrite(descriptor_, from, size, off_t(offset));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0)
            throw FileError(folder_, "the texels of textures cannot be written here (TMPDIR chooses the folder): " +
                                         std::string(std::strerror(written < 0 ? errno : ENOSPC)));
        from += written;
        offset += std::uint64_t(written);
        size -= std::size_t(written);
    }
}

bool TexelFile::read(std::uint64_t offset, void* data, std::size_t size) const {
    char* to = static_cast<char*>(data);
    while (size > 0) {
        const ssize_t got = ::pread(descriptor_, to, size, off_t(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        to += got;
        offset += std::uint64_t(got);
        size -= std::size_t(got);
    }
    return true;
}

} // namespace vitrine
