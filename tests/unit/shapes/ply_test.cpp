#include "core/errors.h"
#include "core/random.h"
#include "shapes/ply.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace vitrine {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A file that goes away with the test.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::string& bytes, bool packed = false)
        : path_(std::filesystem::temp_directory_path() /
                ("vitrine-" + std::to_string(mixBits(std::uint64_t(reinterpret_cast<std::uintptr_t>(this)))) +
                 testing::UnitTest::GetInstance()->current_test_info()->name() + (packed ? ".ply.gz" : ".ply"))) {
        if (packed) {
            gzFile file = gzopen(path_.c_str(), "wb");
            gzwrite(file, bytes.data(), unsigned(bytes.size()));
            gzclose(file);
        } else {
            std::ofstream(path_, std::ios::binary) << bytes;
        }
    }
    ~TemporaryFile() { std::filesystem::remove(path_); }
    std::string path() const { return path_.string(); }

  private:
    std::filesystem::path path_;
};

MeshInput read(const std::string& bytes, bool packed = false) {
    return readPly(TemporaryFile(bytes, packed).path());
}

std::string errorOf(const std::string& bytes, bool packed = false) {
    try {
        read(bytes, packed);
    } catch (const FileError& error) {
        return error.what();
    }
    return "";
}

template <class T>
void append(std::string& bytes, T value, bool big) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (big) std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
}

const std::string asciiHead = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
                              "float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
const std::string asciiBody = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n4 0 1 2 3\n";

/// Every kind of property, unknown elements and lists between, in either binary order.
std::string binaryMesh(bool big) {
    std::string bytes =
        std::string("ply\r\nformat binary_") + (big ? "big" : "little") +
        "_endian 1.0\r\ncomment made up\r\nelement material 2\r\nproperty list ushort double tint\r\n"
        "property char flag\r\nelement vertex 4\r\nproperty double x\r\nproperty float32 y\r\n"
        "property float z\r\nproperty uchar red\r\nproperty float nx\r\nproperty float ny\r\n"
        "property float nz\r\nproperty short s\r\nproperty float64 t\r\nproperty list uint8 int8 extra\r\n"
        "obj_info none\r\nelement face 2\r\nproperty int face_indices\r\n"
        "property list uint uint16 vertex_indices\r\nelement nothing 99999999999\r\nend_header\r\n";
    for (int i = 0; i < 2; ++i) {
        append<std::uint16_t>(bytes, std::uint16_t(i + 1), big);
        for (int k = 0; k <= i; ++k)
            append<double>(bytes, 0.25, big);
        append<std::int8_t>(bytes, -3, big);
    }
    for (int i = 0; i < 4; ++i) {
        append<double>(bytes, i * 0.5, big);
        append<float>(bytes, float(i == 2), big);
        append<float>(bytes, -1.5f, big);
        append<std::uint8_t>(bytes, 200, big);
        for (int k = 0; k < 3; ++k)
            append<float>(bytes, float(k == 2), big);
        append<std::int16_t>(bytes, std::int16_t(-i), big);
        append<double>(bytes, i * 0.125, big);
        append<std::uint8_t>(bytes, std::uint8_t(i), big);
        bytes.append(std::size_t(i), 'x');
    }
    for (int face = 0; face < 2; ++face) {
        append<std::int32_t>(bytes, 7, big);
        append<std::uint32_t>(bytes, std::uint32_t(3 + face), big);
        for (int k = 0; k < 3 + face; ++k)
            append<std::uint16_t>(bytes, std::uint16_t(k), big);
    }
    return bytes;
}

void expectBinaryMesh(const MeshInput& mesh) {
    ASSERT_EQ(mesh.p.size(), 4u);
    EXPECT_EQ(mesh.p[3], V3f(1.5f, 0, -1.5f));
    EXPECT_EQ(mesh.p[2], V3f(1, 1, -1.5f));
    ASSERT_EQ(mesh.n.size(), 4u);
    EXPECT_EQ(mesh.n[1], V3f(0, 0, 1));
    ASSERT_EQ(mesh.uv.size(), 4u);
    EXPECT_EQ(mesh.uv[3], V2f(-3, 0.375f));
    EXPECT_THAT(mesh.triangles, ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.quads, ElementsAre(0, 1, 3, 2));
}

} // namespace

TEST(Ply, AsciiTrianglesAndQuads) {
    const MeshInput mesh = read(asciiHead + asciiBody);
    EXPECT_THAT(mesh.p, ElementsAre(V3f(0, 0, 0), V3f(1, 0, 0), V3f(1, 1, 0), V3f(0, 1, 0)));
    EXPECT_TRUE(mesh.n.empty());
    EXPECT_TRUE(mesh.uv.empty());
    EXPECT_THAT(mesh.triangles, ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.quads, ElementsAre(0, 1, 3, 2));
}

TEST(Ply, BinaryOfBothOrders) {
    expectBinaryMesh(read(binaryMesh(false)));
    expectBinaryMesh(read(binaryMesh(true)));
}

TEST(Ply, Packed) {
    expectBinaryMesh(read(binaryMesh(false), true));
    EXPECT_EQ(read(asciiHead + asciiBody, true).p.size(), 4u);
}

TEST(Ply, EveryPairOfTextureNames) {
    for (const auto& [a, b] :
         {std::pair("u", "v"), {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}) {
        std::string text = asciiHead;
        text.replace(text.find("element face 2"), 14,
                     std::string("property float ") + a + "\nproperty float " + b + "\nelement face 2");
        const MeshInput mesh = read(text + "0 0 0 .5 1\n1 0 0 1 1\n1 1 0 1 0\n0 1 0 0 0\n3 0 1 2\n4 0 1 2 3\n");
        ASSERT_EQ(mesh.uv.size(), 4u) << a;
        EXPECT_EQ(mesh.uv[0], V2f(0.5f, 1));
    }
}

TEST(Ply, NumbersAreFreeInTheirLines) {
    EXPECT_EQ(read(asciiHead + "0 0 0 1 0 0\n\n+1 1e0 0\t0\n1\n0\n3 0 1 2 4 0 1 2 3").quads.size(), 4u);
    std::string name = asciiHead;
    name.replace(name.find("indices"), 7, "index");
    EXPECT_EQ(read(name + asciiBody).triangles.size(), 3u);
}

TEST(Ply, ConvexPolygonsBecomeFans) {
    std::string text = asciiHead;
    text.replace(text.find("vertex 4"), 8, "vertex 6");
    text.replace(text.find("face 2"), 6, "face 1");
    EXPECT_THAT(read(text + "0 0 0 2 0 0 3 1 0 2 2 0 0 2 0 9 9 9\n5 0 1 2 3 4\n").triangles,
                ElementsAre(0, 1, 2, 0, 2, 3, 0, 3, 4));
    EXPECT_THAT(errorOf(text + "0 0 0 2 0 0 0.1 1 0 2 2 0 0 2 0 9 9 9\n5 1 2 3 4 0\n"),
                HasSubstr("face 0 is a polygon of 5"));
}

TEST(Ply, ErrorsNameFilePlaceAndReason) {
    EXPECT_THAT(errorOf(asciiHead + "0 0 0\n1 0 nan\n" + asciiBody),
                testing::AllOf(HasSubstr(".ply"), HasSubstr("line 11"), HasSubstr("z of vertex 1 is not finite")));
    EXPECT_THAT(errorOf(asciiHead + "0 0 0\n1 0 1e99\n" + asciiBody), HasSubstr("not finite"));
    EXPECT_THAT(errorOf(asciiHead + "0 0 0\n1 zero 0\n" + asciiBody), HasSubstr("line 11: \"zero\" is not a number"));
    EXPECT_THAT(errorOf(asciiHead + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 4\n"),
                HasSubstr("line 14: face 0 names vertex 4"));
    EXPECT_THAT(errorOf(asciiHead + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 -1\n"), HasSubstr("face 0 names vertex -1"));
    EXPECT_THAT(errorOf(asciiHead + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 1\n"), HasSubstr("face 0 has 2 corners"));
    EXPECT_THAT(errorOf(asciiHead + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n-3 0 1 2\n"), HasSubstr("-3 is no length of a list"));
    EXPECT_THAT(errorOf(asciiHead + asciiBody + "3 0 1 2\n"), HasSubstr("more data than the header says"));
    EXPECT_THAT(errorOf("solid\n"), HasSubstr("not a PLY file"));
    EXPECT_THAT(errorOf(""), HasSubstr("not a PLY file"));
    std::string binary = binaryMesh(true);
    binary[binary.size() - 1] = 9;
    EXPECT_THAT(errorOf(binary), HasSubstr("byte " + std::to_string(binary.size()) + ": face 1 names vertex 9"));
    EXPECT_THROW(readPly("/nonexistent/mesh.ply"), FileError);
    EXPECT_THROW(readPly(std::filesystem::temp_directory_path().string()), FileError);
}

TEST(Ply, PromisesOfTheHeaderAllocateNothing) {
    for (const char* count : {"4000000000", "2000000000", "18446744073709551615", "99999999999999999999999", "-4"}) {
        std::string vertices = asciiHead, faces = asciiHead;
        vertices.replace(vertices.find("vertex 4"), 8, std::string("vertex ") + count);
        faces.replace(faces.find("face 2"), 6, std::string("face ") + count);
        for (const bool packed : {false, true}) {
            EXPECT_NE(errorOf(vertices + asciiBody, packed), "") << count;
            EXPECT_NE(errorOf(faces + asciiBody, packed), "") << count;
        }
    }
    std::string list = binaryMesh(false);
    // The second face's length, four bytes before its four indices.
    list.replace(list.size() - 12, 4, "\xff\xff\xff\x7f");
    EXPECT_THAT(errorOf(list), HasSubstr("ends too early"));
}

TEST(Ply, EveryPrefixIsAnError) {
    const std::string binary = binaryMesh(false), ascii = asciiHead + asciiBody;
    for (std::size_t length = 0; length < binary.size(); ++length)
        EXPECT_NE(errorOf(binary.substr(0, length)), "") << length;
    // The last number may lack its line's end.
    for (std::size_t length = 0; length + 1 < ascii.size(); ++length)
        EXPECT_NE(errorOf(ascii.substr(0, length)), "") << length;
}

TEST(Ply, TruncatedPackedFiles) {
    std::string body;
    for (int i = 0; i < 300; ++i)
        body += std::to_string(randomBits(1, std::uint64_t(i)) % 1000) + " 0 1\n";
    std::string head = asciiHead;
    head.replace(head.find("vertex 4"), 8, "vertex 300");
    const TemporaryFile whole(head + body + "3 0 1 2\n4 0 1 2 3\n", true);
    EXPECT_EQ(readPly(whole.path()).p.size(), 300u);
    const auto size = std::filesystem::file_size(whole.path());
    for (const auto length : {size - 1, size - 9, size / 2, size / 10}) {
        std::filesystem::resize_file(whole.path(), length);
        EXPECT_THROW(readPly(whole.path()), FileError) << length;
    }
}

TEST(Ply, MutatedFilesAreReadOrRefused) {
    RandomStream random(77);
    int refused = 0, made = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        std::string bytes = trial % 2 ? binaryMesh(trial % 4 == 1) : asciiHead + asciiBody;
        for (int k = 0, changes = 1 + int(random.bits() % 4); k < changes; ++k)
            bytes[random.bits() % bytes.size()] = char(random.bits() % 256);
        try {
            makeMeshShapes(read(bytes), Transform(), false);
            ++made;
        } catch (const FileError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 100);
    EXPECT_GT(made, 100);
}

} // namespace vitrine
