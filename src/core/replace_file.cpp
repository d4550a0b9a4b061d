#include "core/replace_file.h"

#include "core/errors.h"

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace vitrine {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, int error) {
    throw FileError(path, "cannot be written: " + std::generic_category().message(error));
}

/// An open file that is closed, and removed by its name, unless it was kept.
class OutputFile {
  public:
    OutputFile(int descriptor, std::string removedName)
        : descriptor_(descriptor), removedName_(std::move(removedName)) {}
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (!removedName_.empty()) ::unlink(removedName_.c_str());
    }

    /// Writes everything and closes. 0 or the errno of what went wrong.
    int fill(std::initializer_list<std::span<const std::byte>> pieces) {
        for (const auto& piece : pieces)
            if (const int error = write(piece); error != 0) return error;
        return close();
    }
    void keep() { removedName_.clear(); }
    const std::string& name() const { return removedName_; }

  private:
    int write(std::span<const std::byte> bytes) {
        while (!bytes.empty()) {
            const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
            if (n < 0 && errno == EINTR) continue;
            if (n < 0) return errno;
            bytes = bytes.subspan(std::size_t(n));
        }
        return 0;
    }
    int close() {
        // Some file systems find out here that the disk is full. Devices and pipes cannot be synchronised.
        int error = ::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP ? errno : 0;
        if (::close(descriptor_) != 0 && error == 0) error = errno;
        descriptor_ = -1;
        return error;
    }

    int descriptor_;
    std::string removedName_;
};

/// A fresh file in the target's folder; the number gets past what a killed process left.
OutputFile createBeside(const std::string& path, const fs::path& target) {
    for (int i = 0;; ++i) {
        std::string name = (target.parent_path() / fmt::format(".{}.{}.part", target.filename().string(), i)).string();
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0) return OutputFile(descriptor, std::move(name));
        if (errno != EEXIST || i == 1000) fail(path, errno);
    }
}

} // namespace

void replaceFile(const std::string& path, std::initializer_list<std::span<const std::byte>> pieces) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status)) fail(path, EISDIR);
    if (fs::exists(status) && ::access(path.c_str(), W_OK) != 0) fail(path, errno);

    if (fs::exists(status) && !fs::is_regular_file(status)) {
        OutputFile file(::open(path.c_str(), O_WRONLY | O_CLOEXEC), {});
        if (const int error = file.fill(pieces); error != 0) fail(path, error);
        return;
    }

    const fs::path target = fs::exists(status) ? fs::canonical(path) : fs::path(path);
    OutputFile file = createBeside(path, target);
    int error = file.fill(pieces);
    if (error == 0 && ::rename(file.name().c_str(), target.c_str()) != 0) error = errno;
    if (error != 0) fail(path, error);
    file.keep();
}

} // namespace vitrine
