// "alpha", "displacement" and "normalmap" as scenes write them.
#include "film/imageio.h"
#include "scene_text.h"
#include "support/temporary_folder.h"

#include <fmt/format.h>

#include <fstream>

namespace vitrine {
namespace {

std::string scene(const std::string& content) {
    return "LookAt 0 0 4  0 0 0  0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.8 .8 -.8 .8]\n"
           "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8\nSampler \"zsobol\"\n"
           "Integrator \"path\" \"integer maxdepth\" 2\nWorldBegin\n"
           "Texture \"flat\" \"float\" \"constant\" \"float value\" .3\n"
           "Texture \"none\" \"float\" \"constant\" \"float value\" 0\n"
           "Texture \"all\" \"float\" \"constant\" \"float value\" 1\n"
           "Texture \"still\" \"float\" \"bilerp\" \"float v00\" 0 \"float v10\" 0 \"float v01\" 0 \"float v11\" 0\n"
           "LightSource \"distant\" \"rgb L\" [3 3 3] \"point3 from\" [1 .5 2] \"point3 to\" [0 0 0]\n" +
           content;
}

std::vector<float> pixels(const std::string& text) {
    const Scene made = built(text);
    Film film(made.film);
    RenderCounters counters;
    made.integrator->addPasses(made.world, {0, 4}, film, counters);
    return film.image().pixels;
}

std::string material(const std::string& detail) {
    return "Material \"diffuse\" \"rgb reflectance\" [.5 .4 .3] " + detail + "\n";
}

const std::string ball = "Shape \"sphere\" \"float radius\" .7 ",
                  sheet = "Shape \"bilinearmesh\" \"point3 P\" [-1 -1 0  1 -1 0  -1 1 0  1 1 0] ";

TEST(SurfaceDetail, NoDisplacementIsNoDetail) {
    const auto plain = pixels(scene(material("") + ball));
    for (const char* detail : {"\"float displacement\" .5", "\"texture displacement\" \"flat\"",
                               "\"texture displacement\" \"still\"", "\"texture displacement\" \"none\""})
        EXPECT_EQ(pixels(scene(material(detail) + ball)), plain) << detail;
    EXPECT_FALSE(built(scene(material("\"texture displacement\" \"flat\"") + ball)).world.surfaces.at(0).hasDetail());
}

TEST(SurfaceDetail, AlphaOfOneIsNone) {
    const auto plain = pixels(scene(material("") + ball));
    for (const char* alpha : {"\"float alpha\" 1", "\"float alpha\" 3", "\"texture alpha\" \"all\""})
        EXPECT_EQ(pixels(scene(material("") + ball + alpha)), plain) << alpha;
}

TEST(SurfaceDetail, AlphaOfZeroIsNothing) {
    const auto plain = pixels(scene(material("") + sheet));
    for (const char* alpha :
         {"\"float alpha\" 0", "\"float alpha\" -1", "\"texture alpha\" \"none\"", "\"texture alpha\" \"still\""})
        EXPECT_EQ(pixels(scene(material("") + sheet + "\n" + ball + alpha)), plain) << alpha;
    EXPECT_TRUE(built(scene(material("") + ball + "\"float alpha\" 0")).world.surfaces.empty());
}

/// The slope of a plane by a bilinear height is known: what a distant light makes of it too.
TEST(SurfaceDetail, ATiltedPlane) {
    const auto lit = [](const std::string& detail) { return pixels(scene(material(detail) + sheet)).front(); };
    const std::string slope = "Texture \"slope\" \"float\" \"bilerp\" \"float v00\" 0 \"float v10\" 1 \"float v01\" 0 "
                              "\"float v11\" 1\n";
    const float flat = lit(""),
                tilted = pixels(scene(slope + material("\"texture displacement\" \"slope\"") + sheet)).front();
    const V3d toLight = V3d(1, .5, 2).normalized(), n = V3d(-.5, 0, 1).normalized();
    EXPECT_NEAR(tilted / flat, n.dot(toLight) / toLight.z, 1e-3);
}

class NormalMapFiles : public testing::Test {
  protected:
    /// One colour all over. \return the file's name as scenes write it
    std::string image(const std::string& name, std::vector<float> colour) const {
        Image made{2, 2, int(colour.size()), {}};
        for (int i = 0; i < 4; ++i)
            made.pixels.insert(made.pixels.end(), colour.begin(), colour.end());
        writeImage(folder_.file(name), made, {});
        return folder_.file(name);
    }
    std::string map(const std::string& file) const { return "\"string normalmap\" \"" + file + "\""; }

    test::TemporaryFolder folder_;
};

TEST_F(NormalMapFiles, ATiltedNormal) {
    const float flat = pixels(scene(material("") + sheet)).front();
    const V3d n(.36, .48, .8), toLight = V3d(1, .5, 2).normalized();
    const std::string file = image("n.exr", {.68f, .74f, .9f});
    const float tilted = pixels(scene(material(map(file)) + sheet)).front();
    EXPECT_NEAR(tilted / flat, n.dot(toLight) / toLight.z, 1e-4);
    const Scene made = built(scene(material(map(file)) + sheet));
    EXPECT_TRUE(made.world.surfaces.at(0).hasDetail());
}

TEST_F(NormalMapFiles, AMixHasTheDetailOfWhatIsThere) {
    const std::string file = image("n.exr", {.68f, .74f, .9f});
    const std::string named = "MakeNamedMaterial \"a\" \"string type\" \"diffuse\" \"rgb reflectance\" [.5 .4 .3]\n"
                              "MakeNamedMaterial \"b\" \"string type\" \"diffuse\" \"rgb reflectance\" [.5 .4 .3] " +
                              map(file) + "\n";
    const auto mixed = [&](int amount) {
        return pixels(scene(
            named + fmt::format("Material \"mix\" \"string materials\" [\"a\" \"b\"] \"float amount\" {}\n", amount) +
            sheet));
    };
    EXPECT_EQ(mixed(0), pixels(scene(material("") + sheet)));
    EXPECT_EQ(mixed(1), pixels(scene(material(map(file)) + sheet)));
}

TEST_F(NormalMapFiles, Errors) {
    const std::string grey = image("grey.exr", {.5f});
    EXPECT_EQ(errorsOf("WorldBegin\n" + material(map(grey))),
              Lines{fmt::format("2:49: error: {} is grey, but a normal map needs red, green and blue", grey)});
    EXPECT_EQ(errorsOf("WorldBegin\n" + material("\"string normalmap\" \"none.png\"")),
              Lines{"2:49: error: none.png: cannot be read: no such file"});
    std::ofstream(folder_.file("bad.png")) << "no image";
    const Lines bad = errorsOf("WorldBegin\n" + material(map(folder_.file("bad.png"))));
    ASSERT_EQ(bad.size(), 1u);
    EXPECT_TRUE(bad[0].starts_with("2:49: error: " + folder_.file("bad.png") + ": cannot be read: ")) << bad[0];
}

TEST(SurfaceDetail, Errors) {
    EXPECT_EQ(errorsOf("WorldBegin\nShape \"sphere\" \"texture alpha\" \"holes\"\n"),
              Lines{"2:16: error: no float texture \"holes\""});
    EXPECT_EQ(errorsOf("WorldBegin\nShape \"sphere\" \"string alpha\" \"holes\"\n"),
              Lines{"2:16: error: expected \"float alpha\", got \"string alpha\""});
    EXPECT_EQ(errorsOf("WorldBegin\nMaterial \"diffuse\" \"texture displacement\" \"bumps\"\n"),
              Lines{"2:20: error: no float texture \"bumps\""});
    EXPECT_EQ(errorsOf("WorldBegin\nMaterial \"interface\" \"float displacement\" 1\n"),
              Lines{"2:22: error: unused parameter \"displacement\""});
}

TEST(SurfaceDetail, Warnings) {
    const test::TemporaryFolder folder;
    writeImage(folder.file("n.exr"), Image{1, 1, 3, {.5f, .5f, 1}}, {});
    const Scene both = built("WorldBegin\nMaterial \"diffuse\" \"float displacement\" 1 \"string normalmap\" \"" +
                             folder.file("n.exr") + "\"\n");
    ASSERT_EQ(both.warnings.size(), 1u);
    EXPECT_EQ(both.warnings[0].message, "\"displacement\" has no effect beside \"normalmap\"");
    const Scene holes = built("WorldBegin\nMaterial \"dielectric\" \"integer priority\" 1\n"
                              "Shape \"sphere\" \"float alpha\" .5\n");
    ASSERT_EQ(holes.warnings.size(), 1u);
    EXPECT_EQ(
        holes.warnings[0].message,
        "rays pass through the holes of this sphere without entering or leaving the solid that its dielectric bounds");
}

} // namespace
} // namespace vitrine
