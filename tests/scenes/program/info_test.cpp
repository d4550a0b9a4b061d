// What `vitrine info` tells.
#include "program_test.h"
#include "sample_scenes.h"

#include <nlohmann/json.hpp>

namespace vitrine {
namespace {

using namespace test;
using Json = nlohmann::json;

using Info = ProgramTest;

TEST_F(Info, AsText) {
    write("scene.pbrt",
          "Film \"rgb\" \"integer xresolution\" 40 \"integer yresolution\" 30 \"string filename\" \"a.exr\"\n"
          "  \"integer pixelbounds\" [ 0 20 0 30 ]\nIntegrator \"path\"\nWorldBegin\n"
          "LightSource \"point\"\nMaterial \"diffuse\"\nShape \"sphere\" \"float radius\" 2\n"
          "ObjectBegin \"o\"\nShape \"disk\"\nShape \"disk\"\nObjectEnd\nObjectInstance \"o\"\n"
          "AreaLightSource \"diffuse\"\nMaterial \"interface\"\n"
          "Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 0 2 3 ] "
          "\"point3 P\" [ 0 0 0 1 0 0 1 1 0 0 5 0 ]\n");
    const ProgramResult result = run({"info", "scene.pbrt"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.err, "");
    const std::string memory = "memory      0.0 MB ray casting, 0.1 MB film\n";
    EXPECT_EQ(result.out, "scene       scene.pbrt\n"
                          "shapes      2 disk, 1 sphere, 1 trianglemesh (5 primitives)\n"
                          "instances   1\n"
                          "materials   1 diffuse, 1 interface\n"
                          "lights      1 area, 1 point\n"
                          "bounds      (-2, -2, -2) to (2, 5, 2)\n"
                          "camera      perspective\n"
                          "film        40 x 30, cropped to 20 x 30 -> a.exr\n"
                          "integrator  path, 16 samples a pixel, sampler zsobol\n" +
                              memory);
}

TEST_F(Info, AsJson) {
    writeSampleFiles(path(""));
    write("scene.pbrt", wholeSample());
    const ProgramResult result = run({"info", "scene.pbrt", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.describe();
    const Json info = Json::parse(result.out);
    EXPECT_EQ(info.at("scene"), "scene.pbrt");
    EXPECT_EQ(info.at("shapes").at("revolution"), 3);
    EXPECT_EQ(info.at("shapes").at("plymesh"), 1);
    EXPECT_EQ(info.at("lights").at("infinite"), 2);
    EXPECT_EQ(info.at("lights").at("area"), 5);
    EXPECT_EQ(info.at("materials").at("dielectric"), 3);
    EXPECT_EQ(info.at("instances"), 2);
    EXPECT_GT(info.at("primitives"), 20);
    EXPECT_EQ(info.at("camera"), "perspective");
    EXPECT_EQ(info.at("resolution"), Json({4, 3}));
    EXPECT_EQ(info.at("integrator"), "path");
    EXPECT_EQ(info.at("sampler"), "zsobol");
    EXPECT_EQ(info.at("samplesPerPixel"), 2);
    EXPECT_EQ(info.at("outputFile"), "out.exr");
    EXPECT_GT(info.at("casterBytes"), 0);
    EXPECT_EQ(info.at("bounds").size(), 2u);
    const std::vector<std::string> files = info.at("files");
    for (const char* name : {"scene.pbrt", "part.pbrt", "mesh.ply", "sky.pfm", "eta.spd"})
        EXPECT_EQ(std::count(files.begin(), files.end(), name), std::string(name) == "part.pbrt" ? 2 : 1) << name;
}

TEST_F(Info, OfAnEmptyWorld) {
    write("scene.pbrt", "WorldBegin\n");
    const ProgramResult result = run({"info", "scene.pbrt"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.out.find("shapes      none (0 primitives)\n"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("bounds      empty\n"), std::string::npos);
    // And it renders, to black.
    succeed({"render", "scene.pbrt", "--resolution", "3x2", "--spp", "1"});
    EXPECT_EQ(readImage(path("scene.exr")).pixels, std::vector<float>(18, 0.f));
}

TEST_F(Info, ReadsStandardInput) {
    const ProgramResult piped =
        runVitrine({"info", "-"}, {.folder = path(""), .input = "WorldBegin\nShape \"disk\"\n"});
    EXPECT_EQ(piped.exitCode, 0) << piped.describe();
    EXPECT_NE(piped.out.find("shapes      1 disk"), std::string::npos) << piped.out;
}

TEST_F(Info, WarnsOfOpenGlass) {
    write("scene.pbrt", "WorldBegin\nMaterial \"dielectric\" \"integer priority\" 1\nShape \"cylinder\"\n");
    const ProgramResult result = run({"info", "scene.pbrt"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.err,
              "scene.pbrt:3:1: warning: the normals of this cylinder do not point out of a closed solid (it is open, "
              "reversed or mirrored): its dielectric needs other shapes of the same material to bound one\n    Shape "
              "\"cylinder\"\n    ^^^^^\n");
}

TEST_F(Info, OfTheShippedScenes) {
    for (const char* name : {"vase", "goblet", "cornell"}) {
        const std::string file = std::string(VITRINE_SOURCE_DIR) + "/scenes/" + name + "/" + name + ".pbrt";
        const ProgramResult result = run({"info", file});
        EXPECT_EQ(result.exitCode, 0) << result.describe();
        EXPECT_EQ(result.err, "");
    }
}

} // namespace
} // namespace vitrine
