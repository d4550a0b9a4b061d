// PLY files that are written read back bit for bit.
#include "core/errors.h"
#include "shapes/ply.h"
#include "shapes/ply_writer.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace vitrine::test {
namespace {

MeshInput twoTriangles() {
    MeshInput mesh;
    mesh.p = {{0.1f, 1e-30f, -3}, {1, 0, 0}, {1, 1, 0.333333f}, {0, 1, 0}};
    mesh.n = {{0, 0, 1}, {0.6f, 0, 0.8f}, {0, 1, 0}, {-1, 0, 0}};
    mesh.uv = {{0, 0}, {1, 0}, {1, 0.7f}, {0, 1}};
    mesh.triangles = {0, 1, 2, 0, 2, 3};
    return mesh;
}

class PlyWriter : public testing::Test {
  protected:
    std::string header(const MeshInput& mesh) {
        writePly(folder_.file("a.ply"), mesh, "a comment");
        std::ifstream in(folder_.file("a.ply"), std::ios::binary);
        std::stringstream text;
        text << in.rdbuf();
        return text.str().substr(0, text.str().find("end_header\n"));
    }
    TemporaryFolder folder_;
};

TEST_F(PlyWriter, ReadsBackTheSame) {
    const MeshInput mesh = twoTriangles();
    writePly(folder_.file("a.ply"), mesh);
    const MeshInput back = readPly(folder_.file("a.ply"));
    EXPECT_EQ(back.p, mesh.p);
    EXPECT_EQ(back.n, mesh.n);
    EXPECT_EQ(back.uv, mesh.uv);
    EXPECT_EQ(back.triangles, mesh.triangles);
    EXPECT_TRUE(back.quads.empty());
}

TEST_F(PlyWriter, NamesWhatOthersRead) {
    EXPECT_EQ(header(twoTriangles()),
              "ply\nformat binary_little_endian 1.0\ncomment a comment\nelement vertex 4\n"
              "property float x\nproperty float y\nproperty float z\n"
              "property float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n"
              "element face 2\nproperty list uchar int vertex_indices\n");
    MeshInput bare = twoTriangles();
    bare.n.clear();
    bare.uv.clear();
    EXPECT_EQ(header(bare).find("nx"), std::string::npos);
    EXPECT_EQ(readPly(folder_.file("a.ply")).p, bare.p);
}

TEST_F(PlyWriter, RefusesWhatItWouldLose) {
    MeshInput mesh = twoTriangles();
    mesh.quads = {0, 1, 2, 3};
    EXPECT_THROW(writePly(folder_.file("a.ply"), mesh), std::invalid_argument);
    mesh = twoTriangles();
    mesh.n.pop_back();
    EXPECT_THROW(writePly(folder_.file("a.ply"), mesh), std::invalid_argument);
    EXPECT_THROW(writePly(folder_.file("no/such/folder.ply"), twoTriangles()), FileError);
}

} // namespace
} // namespace vitrine::test
