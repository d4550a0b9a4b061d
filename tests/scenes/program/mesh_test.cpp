// vitrine mesh, run as a user runs it.
#include "program_test.h"

#include <gmock/gmock.h>

namespace vitrine::test {
namespace {

using testing::HasSubstr;

constexpr const char* bowl = "Material \"dielectric\"\nShape \"revolution\" \"integer degree\" 1 "
                             "\"point2 P\" [ 0 0  .5 0  .5 .5  0 .5 ]\n";

class MeshCommand : public ProgramTest {};

TEST_F(MeshCommand, WritesASceneThatRendersAlike) {
    writeScene("", std::string("Shape \"plane\"\n") + bowl);
    const ProgramResult result = run({"mesh", "scene.pbrt", "-o", "out/deep"});
    EXPECT_EQ(result.exitCode, 0) << result.describe();
    EXPECT_THAT(result.err, HasSubstr("scene.pbrt:14:1: warning: pbrt-v4 has no infinite plane"));
    EXPECT_THAT(result.out, HasSubstr("meshes/revolution-1.ply: "));
    EXPECT_THAT(result.out, HasSubstr("out/deep/scene.pbrt\n"));
    EXPECT_TRUE(exists("out/deep/meshes/revolution-1.ply"));
    EXPECT_EQ(read("out/deep/scene.pbrt").find("\"plane\""), std::string::npos);
    // From wherever it is called: the text names its files relative to itself.
    succeed({"render", "out/deep/scene.pbrt", "-o", "mesh.exr", "--progress", "none"});
    succeed({"render", "scene.pbrt", "-o", "exact.exr", "--progress", "none"});
    EXPECT_EQ(readImage(path("mesh.exr")).pixels.size(), readImage(path("exact.exr")).pixels.size());
}

TEST_F(MeshCommand, IsTheSameEveryTime) {
    writeScene("", bowl);
    for (const char* folder : {"a", "b"})
        EXPECT_EQ(run({"mesh", "scene.pbrt", "-o", folder, "--tolerance", "1e-3"}).exitCode, 0);
    EXPECT_EQ(read("a/scene.pbrt"), read("b/scene.pbrt"));
    EXPECT_EQ(read("a/meshes/revolution-1.ply"), read("b/meshes/revolution-1.ply"));
}

TEST_F(MeshCommand, SaysWhatIsWrongWithItsArguments) {
    writeScene("", bowl);
    fail({"mesh", "scene.pbrt", "-o", "out", "--tolerance", "0"}, 1,
         "vitrine: --tolerance must be positive and finite, not 0");
    fail({"mesh", "scene.pbrt", "-o", "out", "--tolerance=-1e-3"}, 1,
         "vitrine: --tolerance must be positive and finite, not -0.001");
    fail({"mesh", "scene.pbrt", "-o", "out", "--triangles", "0"}, 1, "vitrine: --triangles must be positive");
    EXPECT_EQ(run({"mesh", "scene.pbrt", "-o", "out", "--triangles", "9", "--tolerance", "1"}).exitCode, 1);
    EXPECT_EQ(run({"mesh", "scene.pbrt"}).exitCode, 1);
    fail({"mesh", "-", "-o", "out"}, 1, "vitrine: mesh reads a scene file, not standard input");
    const ProgramResult fine = run({"mesh", "scene.pbrt", "-o", "out", "--tolerance", "1e-12"});
    EXPECT_EQ(fine.exitCode, 1);
    EXPECT_THAT(fine.err,
                HasSubstr("error: the tolerance 1e-12 is finer than the single precision of a mesh's vertices "
                          "keeps; for this shape it must be at least 1.3e-07 (of the shape's diameter"));
    // The bowl is one unit wide and half a unit high; the least that is named is enough.
    EXPECT_EQ(run({"mesh", "scene.pbrt", "-o", "least", "--tolerance", "1.3e-7", "--only-revolutions"}).exitCode, 0);
    write("tiny.pbrt",
          "WorldBegin\nShape \"revolution\" \"integer degree\" 1 \"point2 P\" [ 0 0 1e-50 0 1e-50 1e-50 ]\n");
    const ProgramResult tiny = run({"mesh", "tiny.pbrt", "-o", "out"});
    EXPECT_EQ(tiny.exitCode, 1);
    EXPECT_THAT(tiny.err, HasSubstr("tiny.pbrt:2:1: error: the shape is too small for the single precision of a mesh's "
                                    "vertices"));
    EXPECT_EQ(run({"mesh", "scene.pbrt", "-o", "out", "--triangles", "3"}).exitCode, 1);
    EXPECT_FALSE(exists("out"));
}

TEST_F(MeshCommand, FoldersThatCannotBeWrittenAreFileTrouble) {
    const std::string scene = writeScene("", bowl);
    write("file", "no folder");
    EXPECT_EQ(run({"mesh", "scene.pbrt", "-o", "file"}).exitCode, 2);
    EXPECT_EQ(run({"mesh", "scene.pbrt", "-o", "file/below"}).exitCode, 2);
    EXPECT_EQ(run({"mesh", "scene.pbrt", "-o", "/proc/no"}).exitCode, 2);
    EXPECT_EQ(run({"mesh", "nothing.pbrt", "-o", "out"}).exitCode, 2);
}

TEST_F(MeshCommand, NeverWritesOverWhatItReads) {
    writeScene("", bowl);
    const std::string before = read("scene.pbrt");
    const ProgramResult result = run({"mesh", "scene.pbrt", "-o", "."});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(result.err, HasSubstr("mesh would write over"));
    EXPECT_EQ(read("scene.pbrt"), before);
}

TEST_F(MeshCommand, CopiesTheFilesOfTheScene) {
    std::filesystem::create_directories(path("data"));
    write("data/eta.spd", "400 1.5\n700 1.4\n");
    writeScene("", "Material \"dielectric\" \"spectrum eta\" \"data/eta.spd\"\nShape \"box\"\n");
    EXPECT_EQ(run({"mesh", "scene.pbrt", "-o", "out"}).exitCode, 0);
    EXPECT_EQ(read("out/resources/eta.spd"), read("data/eta.spd"));
    EXPECT_EQ(run({"info", "out/scene.pbrt"}).exitCode, 0);
}

} // namespace
} // namespace vitrine::test
