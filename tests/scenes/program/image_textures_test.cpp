// Image textures by the whole program: the picture does not depend on threads nor on what is cached.
#include "program_test.h"

#include <fmt/format.h>

namespace vitrine::test {
namespace {

class ImageTextures : public ProgramTest {
  protected:
    /// 1.5 million texels without a pattern: 24 MB with their pyramid.
    void writeTexture() const {
        Image image{1200, 1250, 3, {}};
        std::uint32_t state = 1;
        for (int i = 0; i < image.width * image.height * image.channels; ++i) {
            state = state * 1664525 + 1013904223;
            image.pixels.push_back(float(state >> 8) * 0x1p-24f);
        }
        writeImage(path("noise.exr"), image);
    }
    /// A floor and a ball that show it.
    std::string textured(const std::string& header = "") const {
        return writeScene(header, "Texture \"noise\" \"spectrum\" \"imagemap\" \"string filename\" \"noise.exr\"\n"
                                  "  \"string filter\" \"ewa\" \"float uscale\" 2\n"
                                  "Texture \"rough\" \"float\" \"imagemap\" \"string filename\" \"noise.exr\"\n"
                                  "Material \"diffuse\" \"texture reflectance\" \"noise\"\n"
                                  "Shape \"bilinearmesh\" \"point3 P\" [ -3 0.01 3  3 0.01 3  -3 0.01 -3  3 0.01 -3 ]\n"
                                  "AttributeBegin\n  Translate 1.5 .6 0\n"
                                  "  Material \"conductor\" \"texture roughness\" \"rough\"\n"
                                  "  Shape \"sphere\" \"float radius\" .5\nAttributeEnd\n");
    }
};

TEST_F(ImageTextures, NeitherThreadsNorTheCacheChangeThePicture) {
    writeTexture();
    textured();
    for (const std::string integrator : {"path", "sppm"}) {
        const auto render = [&](const std::string& output, const Arguments& more) {
            Arguments all{"render", "scene.pbrt", "--integrator", integrator, "--progress", "none", "-o", output};
            if (integrator == "sppm")
                all.insert(all.end(), {"--set", "photonsperiteration=20000", "--set", "radius=.1"});
            all.insert(all.end(), more.begin(), more.end());
            const ProgramResult result = run(all);
            EXPECT_EQ(result.exitCode, 0) << result.describe();
            return read(output);
        };
        const std::string one = render("one.exr", {"--nthreads", "1"});
        EXPECT_EQ(render("three.exr", {"--nthreads", "3"}), one) << integrator;
        EXPECT_EQ(render("small.exr", {"--nthreads", "1", "--texture-cache", "1"}), one) << integrator;
        EXPECT_EQ(render("both.exr", {"--nthreads", "3", "--texture-cache", "1"}), one) << integrator;
        EXPECT_NE(render("seed.exr", {"--nthreads", "1", "--seed", "5"}), one) << "nothing differs at all";
    }
}

TEST_F(ImageTextures, TheCacheMustHaveASize) {
    textured();
    fail({"render", "scene.pbrt", "--texture-cache", "0"}, 1, "vitrine: --texture-cache takes megabytes");
}

TEST_F(ImageTextures, AMissingFileIsShownInTheScene) {
    write("scene.pbrt", "WorldBegin\nTexture \"t\" \"float\" \"imagemap\" \"string filename\" \"none.png\"\n");
    fail({"render", "scene.pbrt"}, 1,
         "scene.pbrt:2:50: error: none.png: cannot be read: no such file\n"
         "    Texture \"t\" \"float\" \"imagemap\" \"string filename\" \"none.png\"\n"
         "                                                     ^^^^^^^^^^");
}

} // namespace
} // namespace vitrine::test
