#include "support/npy.h"

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>

namespace vitrine::test {

namespace {

/// Bytes with little-endian numbers in them; reading past the end throws.
class Bytes {
  public:
    Bytes(std::string path, std::string bytes) : path_(std::move(path)), bytes_(std::move(bytes)) {}

    [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(path_ + ": " + what); }
    std::size_t size() const { return bytes_.size(); }
    std::string slice(std::size_t at, std::size_t count) const {
        if (at > bytes_.size() || count > bytes_.size() - at) fail("cut short");
        return bytes_.substr(at, count);
    }
    std::size_t number(std::size_t at, std::size_t count) const {
        const std::string part = slice(at, count);
        std::size_t value = 0;
        for (std::size_t i = count; i-- > 0;)
            value = value << 8 | static_cast<unsigned char>(part[i]);
        return value;
    }

  private:
    std::string path_, bytes_;
};

std::string inflated(const Bytes& file, std::string packed, std::size_t size) {
    std::string plain(size, '\0');
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) file.fail("zlib does not start"); // negative: no zlib header
    stream.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_in = uInt(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(plain.data());
    stream.avail_out = uInt(plain.size());
    const int result = inflate(&stream, Z_FINISH);
    const std::size_t written = stream.total_out;
    inflateEnd(&stream);
    if (result != Z_STREAM_END || written != size) file.fail("damaged");
    return plain;
}

NpyArray parseNpy(const Bytes& npy) {
    if (npy.slice(0, 6) != "\x93NUMPY") npy.fail("is no .npy");
    const bool longHeader = npy.number(6, 1) > 1;
    const std::size_t headerBegin = longHeader ? 12 : 10, headerSize = npy.number(8, longHeader ? 4 : 2);
    const std::string header = npy.slice(headerBegin, headerSize);
    std::smatch match;
    if (header.find("'<f4'") == std::string::npos || header.find("'fortran_order': False") == std::string::npos ||
        !std::regex_search(header, match, std::regex(R"('shape': \(([0-9, ]*)\))")))
        npy.fail("is no float32 array in C order: " + header);

    NpyArray array;
    const std::string shape = match[1];
    static const std::regex digits("[0-9]+");
    std::size_t count = 1;
    for (std::sregex_iterator i(shape.begin(), shape.end(), digits), end; i != end; ++i) {
        array.shape.push_back(std::stoul(i->str()));
        count *= array.shape.back();
    }
    array.values.resize(count);
    std::memcpy(array.values.data(), npy.slice(headerBegin + headerSize, count * sizeof(float)).data(),
                count * sizeof(float));
    return array;
}

} // namespace

std::map<std::string, NpyArray> readNpz(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw std::runtime_error(path + ": cannot be opened");
    const Bytes zip(path, std::string(std::istreambuf_iterator<char>(in), {}));

    // End of central directory: 22 bytes at the very end, as NumPy writes no comment.
    if (zip.size() < 22 || zip.number(zip.size() - 22, 4) != 0x06054b50) zip.fail("is no zip archive");
    const std::size_t entries = zip.number(zip.size() - 12, 2);
    std::size_t at = zip.number(zip.size() - 6, 4);

    std::map<std::string, NpyArray> arrays;
    for (std::size_t i = 0; i < entries; ++i) {
        if (zip.number(at, 4) != 0x02014b50) zip.fail("damaged");
        const std::size_t method = zip.number(at + 10, 2), checksum = zip.number(at + 16, 4);
        const std::size_t packedSize = zip.number(at + 20, 4), size = zip.number(at + 24, 4);
        const std::size_t nameSize = zip.number(at + 28, 2), local = zip.number(at + 42, 4);
        std::string name = zip.slice(at + 46, nameSize);
        at += 46 + nameSize + zip.number(at + 30, 2) + zip.number(at + 32, 2);

        const std::size_t data = local + 30 + zip.number(local + 26, 2) + zip.number(local + 28, 2);
        std::string bytes = zip.slice(data, packedSize);
        if (method == 8)
            bytes = inflated(zip, std::move(bytes), size);
        else if (method != 0)
            zip.fail("packed by an unknown method");
        if (crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), uInt(bytes.size())) != checksum) zip.fail("damaged");
        if (name.ends_with(".npy")) name.resize(name.size() - 4);
        arrays.emplace(name, parseNpy(Bytes(path + ":" + name, std::move(bytes))));
    }
    return arrays;
}

} // namespace vitrine::test
