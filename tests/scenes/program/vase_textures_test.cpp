// The textured vase: its pictures are the same bytes everywhere, and its scenes render with them and name them without.
#include "program_test.h"

#include <gmock/gmock.h>

#include <cstdlib>

namespace vitrine {
namespace {

using namespace test;
namespace fs = std::filesystem;

const std::string vaseFolder = VITRINE_SOURCE_DIR "/scenes/vase";

class VaseTextures : public ProgramTest {
  protected:
    void copyScenes() const {
        for (const auto& entry : fs::directory_iterator(vaseFolder))
            if (entry.path().extension() == ".pbrt") fs::copy(entry.path(), path(entry.path().filename().string()));
    }
    int shell(const std::string& command) const {
        return std::system(("cd '" + folder_.file("") + "' && { " + command + "; } >log.txt 2>&1").c_str());
    }
};

TEST_F(VaseTextures, AreMadeTheSameEverywhereAndShown) {
    // A quarter of the size each way: the same code in a fraction of the time.
    ASSERT_EQ(shell(VITRINE_SOURCE_DIR "/scripts/make_textures.sh textures --scale 0.25"), 0) << read("log.txt");
    EXPECT_EQ(shell("cd textures && sha256sum --check --quiet --strict '" + vaseFolder + "/textures/checksums.txt'"), 0)
        << read("log.txt");
    copyScenes();
    for (const std::string name : {"textured", "textured_near", "textured_far"}) {
        succeed({"render", name + ".pbrt", "--resolution", "64x36", "--passes", "1", "--set",
                 "photonsperiteration=5000", "--progress", "none", "-o", name + ".exr"});
        EXPECT_EQ(readImage(path(name + ".exr")).width, 64);
    }
}

TEST_F(VaseTextures, AreNamedWhenTheyAreMissing) {
    copyScenes();
    const ProgramResult result = run({"render", "textured.pbrt", "-o", "picture.exr"});
    EXPECT_EQ(result.exitCode, 1) << result.describe();
    for (const std::string name :
         {"landscape", "porcelain", "star_tile", "star_mask", "wood", "wood_height", "rainbow"})
        EXPECT_THAT(result.err, testing::HasSubstr("textures/" + name + ".png: cannot be read: no such file"));
    EXPECT_FALSE(exists("picture.exr"));
}

} // namespace
} // namespace vitrine
