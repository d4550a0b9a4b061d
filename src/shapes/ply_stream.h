// The bytes of a file, unpacked if need be, in order and with their position.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

struct gzFile_s;

namespace vitrine {

class PlyStream {
  public:
    /// \throws FileError
    explicit PlyStream(std::string file);
    ~PlyStream();
    PlyStream(const PlyStream&) = delete;
    PlyStream& operator=(const PlyStream&) = delete;

    /// The next `count` bytes (at most maxBlock), valid until the next call. \throws FileError at the file's end
    const char* take(std::size_t count);
    static constexpr std::size_t maxBlock = 1 << 12;

    /// The next byte, or -1 at the end.
    int peek();
    /// The next line without its end ("\n" or "\r\n"). \throws FileError when there is none, or it is absurdly long
    std::string_view takeLine();
    /// The next word between white space. \throws FileError when there is none
    std::string_view takeWord();
    /// Whether only white space is left.
    bool onlySpaceLeft();

    /// An upper bound of the bytes still to come.
    std::uint64_t mostBytesLeft() const;
    /// As many as are worth making room for in advance: those of a packed file are not known.
    std::uint64_t likelyBytesLeft() const;
    /// Throws an error that names the line (in text) or the byte.
    [[noreturn]] void fail(const std::string& message) const;
    /// From here on positions are bytes, not lines.
    void countBytes() { binary_ = true; }

  private:
    std::size_t available() const { return end_ - begin_; }
    /// Makes `count` bytes available, if the file has them.
    bool fill(std::size_t count);

    std::string file_;
    gzFile_s* handle_ = nullptr;
    std::vector<char> buffer_;
    std::size_t begin_ = 0, end_ = 0;
    std::uint64_t position_ = 0; ///< of begin_, unpacked
    std::uint64_t mostBytes_ = 0, likelyBytes_ = 0;
    std::uint64_t line_ = 1;
    bool binary_ = false;
};

} // namespace vitrine
