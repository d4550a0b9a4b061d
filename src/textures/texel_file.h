// A temporary file that holds the texels of a scene's images while it is rendered.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace vitrine {

/// Nameless: it vanishes with the program however that ends, and nobody else can change it. It lies in the folder that
/// TMPDIR names, else in /var/tmp (as /tmp may be a piece of memory), else in /tmp.
class TexelFile {
  public:
    /// \throws FileError when there is no such folder to write in
    TexelFile();
    ~TexelFile();
    TexelFile(const TexelFile&) = delete;
    TexelFile& operator=(const TexelFile&) = delete;

    /// The offset of `size` more bytes, which read as zeros until they are written.
    std::uint64_t reserve(std::uint64_t size);
    /// \throws FileError, also when the disk is full
    void write(std::uint64_t offset, const void* data, std::size_t size);
    /// False when the system cannot read them. From any number of threads at once.
    bool read(std::uint64_t offset, void* data, std::size_t size) const;

  private:
    std::string folder_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

} // namespace vitrine
