#include "shapes/ply_stream.h"

#include "core/errors.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstring>
#include <filesystem>

namespace vitrine {

namespace {

constexpr std::size_t bufferSize = 1 << 18;
/// No line of a header and no number is that long.
constexpr std::size_t longestToken = PlyStream::maxBlock;
/// Deflate cannot pack better than this (zlib's technical notes).
constexpr std::uint64_t bestCompression = 1032;
/// And meshes hardly ever pack better than this.
constexpr std::uint64_t usualCompression = 32;

bool isSpace(int c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

} // namespace

PlyStream::PlyStream(std::string file) : file_(std::move(file)), buffer_(bufferSize) {
    std::error_code error;
    const auto status = std::filesystem::status(file_, error);
    if (!std::filesystem::exists(status)) throw FileError(file_, "there is no such file");
    if (!std::filesystem::is_regular_file(status)) throw FileError(file_, "is not a regular file");
    const std::uint64_t size = std::filesystem::file_size(file_, error);
    handle_ = gzopen(file_.c_str(), "rb");
    if (!handle_) throw FileError(file_, std::string("cannot be opened: ") + std::strerror(errno));
    gzbuffer(handle_, 1 << 17);
    const bool packed = !gzdirect(handle_);
    mostBytes_ = packed ? size * bestCompression : size;
    likelyBytes_ = packed ? size * usualCompression : size;
}

PlyStream::~PlyStream() {
    gzclose(handle_);
}

void PlyStream::fail(const std::string& message) const {
    throw FileError(file_, binary_ ? fmt::format("byte {}: {}", position_, message)
                                   : fmt::format("line {}: {}", line_, message));
}

std::uint64_t PlyStream::mostBytesLeft() const {
    return mostBytes_ > position_ ? mostBytes_ - position_ : 0;
}

std::uint64_t PlyStream::likelyBytesLeft() const {
    return likelyBytes_ > position_ ? likelyBytes_ - position_ : 0;
}

bool PlyStream::fill(std::size_t count) {
    if (available() >= count) return true;
    std::memmove(buffer_.data(), buffer_.data() + begin_, available());
    end_ = available();
    begin_ = 0;
    while (end_ < count) {
        const int read = gzread(handle_, buffer_.data() + end_, unsigned(buffer_.size() - end_));
        int code = Z_OK;
        const char* message = gzerror(handle_, &code);
        // A packed file that breaks off hands out what it has and then reports Z_BUF_ERROR.
        if (read < 0 || (read == 0 && code != Z_OK && code != Z_STREAM_END))
            fail(code == Z_BUF_ERROR
                     ? std::string("the packed file breaks off")
                     : fmt::format("cannot be read: {}", code == Z_ERRNO ? std::strerror(errno) : message));
        if (read == 0) return false;
        end_ += std::size_t(read);
    }
    return true;
}

const char* PlyStream::take(std::size_t count) {
    if (!fill(count)) fail("the file ends too early");
    const char* bytes = buffer_.data() + begin_;
    begin_ += count;
    position_ += count;
    return bytes;
}

int PlyStream::peek() {
    return fill(1) ? static_cast<unsigned char>(buffer_[begin_]) : -1;
}

std::string_view PlyStream::takeLine() {
    std::size_t length = 0;
    while (true) {
        if (!fill(length + 1)) {
            if (length == 0) fail("the file ends too early");
            break;
        }
        if (buffer_[begin_ + length] == '\n') break;
        if (++length > longestToken) fail("the line is too long");
    }
    std::string_view line(buffer_.data() + begin_, length);
    const std::size_t taken = std::min(length + 1, available());
    begin_ += taken;
    position_ += taken;
    ++line_;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

bool PlyStream::onlySpaceLeft() {
    for (int c = peek(); c >= 0; c = peek()) {
        if (!isSpace(c)) return false;
        line_ += c == '\n';
        ++begin_;
        ++position_;
    }
    return true;
}

std::string_view PlyStream::takeWord() {
    if (onlySpaceLeft()) fail("the file ends too early");
    std::size_t length = 0;
    while (fill(length + 1) && !isSpace(static_cast<unsigned char>(buffer_[begin_ + length])))
        if (++length > longestToken) fail("the number is too long");
    const std::string_view word(buffer_.data() + begin_, length);
    begin_ += length;
    position_ += length;
    return word;
}

} // namespace vitrine
