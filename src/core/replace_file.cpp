#include "core/replace_file.h"

#include "core/errors.h"

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

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
        if (!removedName_.empty()) ::unlink(removedName_.c_str());
        if (descriptor_ >= 0) ::close(descriptor_);
    }

    /// Writes everything to the disk. 0 or the errno of what went wrong.
    int fill(std::initializer_list<std::span<const std::byte>> pieces) {
        for (const auto& piece : pieces)
            if (const int error = write(piece); error != 0) return error;
        // Some file systems find out here that the disk is full. Devices and pipes cannot be synchronised.
        return ::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP ? errno : 0;
    }
    /// Renames and closes: up to then nobody else takes the file for a leftover.
    int keepAs(const std::string& name) {
        if (::rename(removedName_.c_str(), name.c_str()) != 0) return errno;
        removedName_.clear();
        return close();
    }
    int close() { return ::close(std::exchange(descriptor_, -1)) != 0 ? errno : 0; }

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

    int descriptor_;
    std::string removedName_;
};

/// A file that a killed process left, emptied; -1 when another process is at work on it, or it is not ours.
int reuse(const std::string& name) {
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) return -1;
    struct stat opened {
    }, named{};
    // Between opening and locking it may have been renamed by its writer, and would now be the finished file.
    const bool ours = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor, &opened) == 0 &&
                      ::lstat(name.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
                      opened.st_dev == named.st_dev && S_ISREG(opened.st_mode) && opened.st_nlink == 1 &&
                      opened.st_uid == ::geteuid() && ::ftruncate(descriptor, 0) == 0;
    if (ours) return descriptor;
    ::close(descriptor);
    return -1;
}

/// A file of our own in the target's folder, locked as long as it is open. The number gets past those of other
/// processes that write under the same name at this moment.
OutputFile createBeside(const std::string& path, const fs::path& target) {
    for (int i = 0;; ++i) {
        std::string name = (target.parent_path() / fmt::format(".{}.{}.part", target.filename().string(), i)).string();
        int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor < 0 && (errno != EEXIST || i == 1000)) fail(path, errno);
        if (descriptor < 0) {
            descriptor = reuse(name);
        } else if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
            ::close(descriptor); // another took the new file for a leftover: so be it
            continue;
        }
        if (descriptor >= 0) return OutputFile(descriptor, std::move(name));
    }
}

/// Where the new file goes, links followed; nothing for what is written to as it is.
std::optional<fs::path> regularTarget(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status)) fail(path, EISDIR);
    if (fs::exists(status) && ::access(path.c_str(), W_OK) != 0) fail(path, errno);
    if (fs::exists(status) && !fs::is_regular_file(status)) return {};
    return fs::exists(status) ? fs::canonical(path) : fs::path(path);
}

} // namespace

void replaceFile(const std::string& path, std::initializer_list<std::span<const std::byte>> pieces) {
    const auto target = regularTarget(path);
    OutputFile file = target ? createBeside(path, *target) : OutputFile(::open(path.c_str(), O_WRONLY | O_CLOEXEC), {});
    int error = file.fill(pieces);
    if (error == 0) error = target ? file.keepAs(target->string()) : file.close();
    if (error != 0) fail(path, error);
}

void checkReplaceable(const std::string& path) {
    if (const auto target = regularTarget(path)) createBeside(path, *target); // and removed again
}

} // namespace vitrine
