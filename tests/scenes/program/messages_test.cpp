// What users read when something is wrong: exact text and exit codes.
#include "program_test.h"

namespace vitrine {
namespace {

using namespace test;

class Messages : public ProgramTest {
  protected:
    void SetUp() override { std::filesystem::create_directory(path("parts")); }

    /// `vitrine info` of this text, called scene.pbrt, must fail with exactly this.
    void refuse(const std::string& text, const std::string& message) const {
        SCOPED_TRACE(text);
        write("scene.pbrt", text);
        fail({"info", "scene.pbrt"}, 1, message);
    }
};

TEST_F(Messages, SeveralErrorsInTheOrderOfTheText) {
    refuse("Camera \"perspektive\"\n"
           "Sampler \"sobol\" \"integer pixelsamples\" 0\n"
           "Integrator \"path\" \"integer maxdepth\" -2\n"
           "WorldBegin\n"
           "Shape \"sphere\" \"float radius\" 1 \"float phimx\" 3\n"
           "LightSource \"point\" \"float scal\" 3\n"
           "Material \"dielectric\" \"spectrum eta\" \"glass-BK8\"\n"
           "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] \"integer indices\" [ 0 1 7 ]\n",
           "scene.pbrt:1:8: error: unknown camera \"perspektive\"\n"
           "    Camera \"perspektive\"\n"
           "           ^^^^^^^^^^^^^\n"
           "    did you mean \"perspective\"?\n"
           "scene.pbrt:2:17: error: \"pixelsamples\" must be at least 1\n"
           "    Sampler \"sobol\" \"integer pixelsamples\" 0\n"
           "                    ^^^^^^^^^^^^^^^^^^^^^^\n"
           "scene.pbrt:3:19: error: \"maxdepth\" must not be negative\n"
           "    Integrator \"path\" \"integer maxdepth\" -2\n"
           "                      ^^^^^^^^^^^^^^^^^^\n"
           "scene.pbrt:5:33: error: unused parameter \"phimx\"\n"
           "    Shape \"sphere\" \"float radius\" 1 \"float phimx\" 3\n"
           "                                    ^^^^^^^^^^^^^\n"
           "    did you mean \"phimax\"?\n"
           "scene.pbrt:6:21: error: unused parameter \"scal\"\n"
           "    LightSource \"point\" \"float scal\" 3\n"
           "                        ^^^^^^^^^^^^\n"
           "    did you mean \"scale\"?\n"
           "scene.pbrt:7:38: error: \"glass-BK8\" is neither a named spectrum nor a file\n"
           "    Material \"dielectric\" \"spectrum eta\" \"glass-BK8\"\n"
           "                                         ^^^^^^^^^^^\n"
           "    did you mean \"glass-BK7\"?\n"
           "scene.pbrt:8:1: error: index 7 is out of range: there are 3 vertices\n"
           "    Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] \"integer indices\" [ 0 1 7 ]\n"
           "    ^^^^^");
}

TEST_F(Messages, NameTheChainOfIncludes) {
    write("parts/outer.pbrt", "Shape \"sphere\" \"float radis\" 1\nInclude \"parts/inner.pbrt\"\n");
    write("parts/inner.pbrt", "# nothing wrong in this line\nMaterial \"diffus\"\n");
    refuse("WorldBegin\n\nInclude \"parts/outer.pbrt\"\n", "parts/outer.pbrt:1:16: error: unused parameter \"radis\"\n"
                                                           "    Shape \"sphere\" \"float radis\" 1\n"
                                                           "                   ^^^^^^^^^^^^^\n"
                                                           "    did you mean \"radius\"?\n"
                                                           "    included from scene.pbrt:3\n"
                                                           "parts/inner.pbrt:2:10: error: unknown material \"diffus\"\n"
                                                           "    Material \"diffus\"\n"
                                                           "             ^^^^^^^^\n"
                                                           "    did you mean \"diffuse\"?\n"
                                                           "    included from parts/outer.pbrt:2\n"
                                                           "    included from scene.pbrt:3");
}

TEST_F(Messages, AtMostTwentyErrors) {
    std::string text = "WorldBegin\n";
    for (int i = 0; i < 50000; ++i)
        text += "Shape \"sphere\" \"float radius\" -1\n";
    write("scene.pbrt", text);
    const ProgramResult result = run({"info", "scene.pbrt"}, 20);
    EXPECT_EQ(result.exitCode, 1) << result.describe().substr(0, 1000);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 3 * 20);
    EXPECT_NE(result.err.find("scene.pbrt:21:1: error"), std::string::npos);
}

TEST_F(Messages, HalfAMillionErrorsAreNotWaitedFor) {
    std::string text = "WorldBegin\n";
    for (int i = 0; i < 500000; ++i)
        text += "Shape \"spher\"\n";
    write("scene.pbrt", text);
    const ProgramResult result = run({"info", "scene.pbrt"}, 20);
    EXPECT_EQ(result.exitCode, 1) << result.describe().substr(0, 1000);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 4 * 20);
}

TEST_F(Messages, ErrorsOfReadingDoNotHideThoseOfBuilding) {
    refuse("Sampler \"sobl\"\nWorldBegin\nMaterial \"hair\"\nShape \"disk\" \"float foo\" 2 \"float radius\" 3 \"float "
           "radius\" 4\nNamedMaterial \"zz\"\nMediumInterface \"fog\"\n",
           "scene.pbrt:1:9: error: unknown sampler \"sobl\"\n"
           "    Sampler \"sobl\"\n            ^^^^^^\n"
           "    did you mean \"sobol\"?\n"
           "scene.pbrt:3:10: error: material \"hair\" is not yet supported\n"
           "    Material \"hair\"\n             ^^^^^^\n"
           "scene.pbrt:4:14: error: unused parameter \"foo\"\n"
           "    Shape \"disk\" \"float foo\" 2 \"float radius\" 3 \"float radius\" 4\n"
           "                 ^^^^^^^^^^^\n"
           "scene.pbrt:4:45: error: parameter \"radius\" is given twice\n"
           "    Shape \"disk\" \"float foo\" 2 \"float radius\" 3 \"float radius\" 4\n"
           "                                                ^^^^^^^^^^^^^^\n"
           "    first at scene.pbrt:4:28");
    // Names that are missing are told when all was read.
    refuse("WorldBegin\nShape \"spher\"\nNamedMaterial \"zz\"\nMediumInterface \"fog\"\n",
           "scene.pbrt:2:7: error: unknown shape \"spher\"\n"
           "    Shape \"spher\"\n          ^^^^^^^\n"
           "    did you mean \"sphere\"?\n"
           "scene.pbrt:3:15: error: there is no material \"zz\"\n"
           "    NamedMaterial \"zz\"\n                  ^^^^\n"
           "scene.pbrt:4:17: error: there is no medium \"fog\"\n"
           "    MediumInterface \"fog\"\n                    ^^^^^");
    refuse(
        "WorldBegin\nShape \"trianglemesh\" \"integer indices\" [ 0 1 5 0 1 -1 ] \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ]\n",
        "scene.pbrt:2:1: error: index 5 is out of range: there are 3 vertices\n"
        "    Shape \"trianglemesh\" \"integer indices\" [ 0 1 5 0 1 -1 ] \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ]\n"
        "    ^^^^^\n"
        "scene.pbrt:2:52: error: a vertex index must not be negative\n"
        "    Shape \"trianglemesh\" \"integer indices\" [ 0 1 5 0 1 -1 ] \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ]\n"
        "                                                       ^^");
}

TEST_F(Messages, NothingFollowsFromWhatCouldNotBeRead) {
    // The film, the attributes or the blocks that are lost would make errors of their own.
    refuse("Film \"rgb\" \"intger xresolution\" 4\nWorldBegin\nShape \"spher\"\n",
           "scene.pbrt:1:12: error: unknown parameter type \"intger\"\n"
           "    Film \"rgb\" \"intger xresolution\" 4\n               ^^^^^^^^^^^^^^^^^^^^\n"
           "    did you mean \"integer\"?");
    refuse("WorldBegin\nAttribute \"shape\" \"strng filename\" \"a.ply\"\nShape \"plymesh\"\n",
           "scene.pbrt:2:19: error: unknown parameter type \"strng\"\n"
           "    Attribute \"shape\" \"strng filename\" \"a.ply\"\n                      ^^^^^^^^^^^^^^^^\n"
           "    did you mean \"string\"?");
    refuse("WorldBegin\nInclude \"no.pbrt\"\nShape \"spher\"\n",
           "scene.pbrt:2:9: error: no.pbrt: no such file\n    Include \"no.pbrt\"\n            ^^^^^^^^^");
}

TEST_F(Messages, FilesThatAreMissing) {
    fail({"info", "no.pbrt"}, 2, "vitrine: no.pbrt: no such file");
    fail({"render", "no.pbrt"}, 2, "vitrine: no.pbrt: no such file");
    fail({"info", "parts"}, 2, "vitrine: parts: is a directory");
    refuse("WorldBegin\nInclude \"no.pbrt\"\n",
           "scene.pbrt:2:9: error: no.pbrt: no such file\n    Include \"no.pbrt\"\n            ^^^^^^^^^");
    refuse("WorldBegin\nImport \"no.pbrt\"\n",
           "scene.pbrt:2:8: error: no.pbrt: no such file\n    Import \"no.pbrt\"\n           ^^^^^^^^^");
    refuse("WorldBegin\nShape \"plymesh\" \"string filename\" \"no.ply\"\n"
           "LightSource \"infinite\" \"string filename\" \"no.exr\"\n"
           "Material \"dielectric\" \"spectrum eta\" \"no.spd\"\n",
           "scene.pbrt:2:35: error: no.ply: there is no such file\n"
           "    Shape \"plymesh\" \"string filename\" \"no.ply\"\n"
           "                                      ^^^^^^^^\n"
           "scene.pbrt:3:42: error: no.exr: cannot be read: no such file\n"
           "    LightSource \"infinite\" \"string filename\" \"no.exr\"\n"
           "                                             ^^^^^^^^\n"
           "scene.pbrt:4:38: error: \"no.spd\" is neither a named spectrum nor a file\n"
           "    Material \"dielectric\" \"spectrum eta\" \"no.spd\"\n"
           "                                         ^^^^^^^^");
    refuse("WorldBegin\nShape \"plymesh\"\n",
           "scene.pbrt:2:1: error: a plymesh needs \"string filename\"\n    Shape \"plymesh\"\n    ^^^^^");
}

TEST_F(Messages, FilesThatAreDamaged) {
    write("bad.exr", "this is no picture");
    write("bad.spd", "400 1\n500 one\n");
    write("scene.pbrt", "WorldBegin\nLightSource \"infinite\" \"string filename\" \"bad.exr\"\n"
                        "Material \"dielectric\" \"spectrum eta\" \"bad.spd\"\n");
    const ProgramResult result = run({"info", "scene.pbrt"});
    EXPECT_EQ(result.exitCode, 1) << result.describe();
    EXPECT_EQ(result.err.find("scene.pbrt:2:42: error: bad.exr: cannot be read: "), 0u) << result.err;
    EXPECT_NE(result.err.find("bad.spd:2:5: error: expected a number, got \"one\"\n    500 one\n        ^^^"),
              std::string::npos)
        << result.err;
    write("zeros.pbrt", std::string("WorldBegin\n\0", 12));
    EXPECT_EQ(run({"info", "zeros.pbrt"}).exitCode, 1);
}

TEST_F(Messages, MeshesWithWrongCounts) {
    const auto ply = [](int vertices, int faces, const std::string& face) {
        return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices) +
               "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faces) +
               "\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n" + face + "\n";
    };
    const auto message = [&](const std::string& text) {
        write("mesh.ply", text);
        write("scene.pbrt", "WorldBegin\nShape \"plymesh\" \"string filename\" \"mesh.ply\"\n");
        const ProgramResult result = run({"info", "scene.pbrt"});
        EXPECT_EQ(result.exitCode, 1) << result.describe();
        const std::string place = "scene.pbrt:2:35: error: mesh.ply: ";
        EXPECT_EQ(result.err.find(place), 0u) << result.err;
        return result.err.substr(place.size(), result.err.find('\n') - place.size());
    };
    EXPECT_EQ(message(ply(4, 1, "3 0 1 2")), "line 13: face 0 has 2 corners");
    EXPECT_EQ(message(ply(3, 2, "3 0 1 2")), "line 14: the file ends too early");
    EXPECT_EQ(message(ply(2, 1, "3 0 1 2")), "line 12: face 0 has 0 corners");
    EXPECT_EQ(message(ply(3, 1, "3 0 1 3")), "line 13: face 0 names vertex 3, but there are 3");
    EXPECT_EQ(message(ply(3, 1, "3 0 1 -1")), "line 13: face 0 names vertex -1, but there are 3");
    EXPECT_EQ(message(ply(2000000000, 1, "3 0 1 2")),
              "line 10: 2000000000 elements \"vertex\" do not fit into the file");
}

TEST_F(Messages, FilmsOfAnySize) {
    const auto film = [](const std::string& x, const std::string& y) {
        return "Film \"rgb\" \"integer xresolution\" " + x + " \"integer yresolution\" " + y + "\nWorldBegin\n";
    };
    refuse(film("0", "0"), "scene.pbrt:1:1: error: a picture of 0 x 0 pixels has none\n"
                           "    Film \"rgb\" \"integer xresolution\" 0 \"integer yresolution\" 0\n    ^^^^");
    refuse(film("-4", "3"), "scene.pbrt:1:1: error: a picture of -4 x 3 pixels has none\n"
                            "    Film \"rgb\" \"integer xresolution\" -4 \"integer yresolution\" 3\n    ^^^^");
    write("scene.pbrt", film("1000000", "1000000"));
    const ProgramResult huge = run({"render", "scene.pbrt"});
    EXPECT_EQ(huge.exitCode, 1) << huge.describe();
    EXPECT_EQ(huge.err.find("vitrine: a film of 1000000 x 1000000 pixels needs 100000.0 GB, this machine has "), 0u)
        << huge.err;
    succeed({"render", "scene.pbrt", "--pixelbounds", "999990,1000000,0,7", "--spp", "1"});
    EXPECT_EQ(readImage(path("scene.exr")).width, 10);
    EXPECT_EQ(run({"render", "scene.pbrt", "--resolution", "2147483647x2147483647"}).exitCode, 1);
    for (const char* size : {"0x0", "-1x5", "5x0"})
        EXPECT_EQ(run({"render", "scene.pbrt", "--resolution", size}).exitCode, 1) << size;
    EXPECT_EQ(run({"render", "scene.pbrt", "--pixelbounds", "5,5,0,3"}).exitCode, 1);
    EXPECT_EQ(run({"render", "scene.pbrt", "--cropwindow", "0,1,.5,nan"}).exitCode, 1);
}

TEST_F(Messages, NumbersThatAreNone) {
    for (const char* number : {"nan", "inf", "-inf", "1e999", "1e39"}) {
        const std::string value = number;
        const std::string text = "WorldBegin\nShape \"sphere\" \"float radius\" " + value + "\n";
        const std::string what = value[0] == '1' ? "\"" + value + "\" is too large: numbers go up to 3.4e38"
                                                 : "numbers must be finite, got \"" + value + "\"";
        refuse(text, "scene.pbrt:2:31: error: \"float radius\": " + what + "\n    Shape \"sphere\" \"float radius\" " +
                         value + "\n                                  " + std::string(value.size(), '^'));
    }
}

TEST_F(Messages, CoordinatesBeyondTheCastersReach) {
    refuse("WorldBegin\nShape \"sphere\" \"float radius\" 1e16\n",
           "scene.pbrt:2:1: error: this sphere reaches too far: coordinates go up to 1e+15\n"
           "    Shape \"sphere\" \"float radius\" 1e16\n    ^^^^^");
    refuse("WorldBegin\nObjectBegin \"a\"\nShape \"sphere\"\nObjectEnd\nScale 1e16 1 1\nObjectInstance \"a\"\n",
           "scene.pbrt:6:1: error: this instance reaches too far: coordinates go up to 1e+15\n"
           "    ObjectInstance \"a\"\n    ^^^^^^^^^^^^^^");
    refuse("WorldBegin\nShape \"sphere\"\nObjectBegin \"a\"\nShape \"sphere\"\nObjectEnd\nScale 1e-16 1 1\n"
           "ObjectInstance \"a\"\n",
           "scene.pbrt:7:1: error: this instance is too small: seen from it, the scene reaches beyond 1e+15\n"
           "    ObjectInstance \"a\"\n    ^^^^^^^^^^^^^^");
}

TEST_F(Messages, OutputsThatCannotBeWritten) {
    write("scene.pbrt", "Film \"rgb\" \"integer xresolution\" 4 \"integer yresolution\" 4\nWorldBegin\n");
    const auto refused = [&](const std::string& output, int exitCode, const std::string& message) {
        fail({"render", "scene.pbrt", "--spp", "1", "-o", output}, exitCode, message);
    };
    const std::string formats = "(exr, hdr, jpeg, jpg, pfm, png, ppm)";
    refused("x.tiff", 1, "vitrine: x.tiff: \".tiff\" is no image format that can be written " + formats);
    refused("x.pgn", 1,
            "vitrine: x.pgn: \".pgn\" is no image format that can be written " + formats + "; did you mean \"png\"?");
    refused("x", 1,
            "vitrine: x: has no extension to tell the image format (one of exr, hdr, jpeg, jpg, pfm, png, ppm)");
    refused("no/x.exr", 2, "vitrine: no/x.exr: there is no folder " + path("no"));
    std::filesystem::create_directory(path("folder.exr"));
    refused("folder.exr", 2, "vitrine: folder.exr: is a folder");
    // Nobody may make files there, not even root.
    EXPECT_EQ(run({"render", "scene.pbrt", "--spp", "1", "-o", "/proc/x.exr"}).exitCode, 2);
    EXPECT_EQ(run({"render", "scene.pbrt", "--spp", "1", "--stats", "/proc/x.json"}).exitCode, 2);
    EXPECT_EQ(run({"render", "scene.pbrt", "--spp", "1", "--checkpoint", "/proc/x"}).exitCode, 2);
    EXPECT_EQ(run({"render", "scene.pbrt", "--spp", "1", "--partial", "no/x"}).exitCode, 2);
}

TEST_F(Messages, WhatIsValidButNotYetSupportedSaysSo) {
    struct Family {
        std::string directive, name;
        std::vector<const char*> types;
    };
    const auto unsupported = [&](const std::string& text, const std::vector<std::string>& whats) {
        write("scene.pbrt", text);
        const ProgramResult result = run({"info", "scene.pbrt"});
        EXPECT_EQ(result.exitCode, 1) << result.describe();
        for (const auto& what : whats)
            EXPECT_NE(result.err.find("error: " + what), std::string::npos) << what << "\n" << result.err;
    };
    const auto each = [&](const std::vector<Family>& families, const std::string& before, const std::string& after) {
        std::string text = before;
        std::vector<std::string> whats;
        for (const auto& [directive, name, types] : families)
            for (const char* type : types) {
                text += directive + " \"" + type + "\"\n";
                whats.push_back(name + " \"" + type + "\" is not yet supported");
            }
        unsupported(text + after, whats);
    };
    each({Family{"Shape", "shape", {"curve", "loopsubdiv"}},
          Family{"LightSource", "light", {"goniometric", "projection"}},
          Family{"Material", "material", {"hair", "measured", "subsurface"}}},
         "WorldBegin\n", "");
    // The last of these directives counts, so that each type takes a scene.
    for (const Family& family :
         {Family{"Camera", "camera", {"realistic"}}, Family{"Film", "film", {"gbuffer", "spectral"}},
          Family{"Integrator", "integrator", {"bdpt", "mlt", "ambientocclusion", "randomwalk", "simplepath"}}})
        for (const char* type : family.types)
            each({Family{family.directive, family.name, {type}}}, "", "WorldBegin\n");
    unsupported(
        "Film \"rgb\" \"string sensor\" \"canon_eos_5d\"\nWorldBegin\n"
        "MakeNamedMedium \"m\" \"string type\" \"homogeneous\"\nMediumInterface \"m\" \"\"\n"
        "Shape \"bilinearmesh\" \"point3 P\" [0 0 0  1 0 0  0 1 0  1 1 0] \"string emissionfilename\" \"x.exr\"\n"
        "ActiveTransform EndTime\nTranslate 1 0 0\nTexture \"t\" \"spectrum\" \"checkerboard\" \"integer dimension\" "
        "3\n",
        {"sensor \"canon_eos_5d\" is not yet supported", "participating media are not yet supported",
         "parameter \"emissionfilename\" is not yet supported", "animated transformations are not yet supported"});
}

TEST_F(Messages, TexturesThatAreNotThere) {
    const std::string textures = "WorldBegin\nTexture \"wood\" \"spectrum\" \"constant\" \"rgb value\" [.2 .1 .1]\n"
                                 "Texture \"rough\" \"float\" \"constant\" \"float value\" .5\n";
    write("scene.pbrt", textures + "Material \"diffuse\" \"texture reflectance\" \"wood\"\nShape \"sphere\"\n");
    EXPECT_EQ(run({"info", "scene.pbrt"}).exitCode, 0);
    refuse(textures + "Material \"diffuse\" \"texture reflectance\" \"wod\"\n",
           "scene.pbrt:4:20: error: no spectrum texture \"wod\"\n"
           "    Material \"diffuse\" \"texture reflectance\" \"wod\"\n"
           "                       ^^^^^^^^^^^^^^^^^^^^^\n"
           "    did you mean \"wood\"?");
    refuse(textures + "Material \"dielectric\" \"texture roughness\" \"wood\"\n",
           "scene.pbrt:4:23: error: no float texture \"wood\"\n"
           "    Material \"dielectric\" \"texture roughness\" \"wood\"\n"
           "                          ^^^^^^^^^^^^^^^^^^^\n"
           "    there is a spectrum texture of that name");
}

TEST_F(Messages, OldAndMisspeltNames) {
    refuse("WorldBegin\nShape \"shpere\"\n",
           "scene.pbrt:2:7: error: unknown shape \"shpere\"\n    Shape \"shpere\"\n          ^^^^^^^^\n"
           "    did you mean \"sphere\"?");
    refuse("WorldBegin\nLightsource \"point\"\n",
           "scene.pbrt:2:1: error: unknown directive \"Lightsource\"\n    Lightsource \"point\"\n    ^^^^^^^^^^^\n"
           "    did you mean \"LightSource\"?");
    refuse("Sampler \"sobl\"\nWorldBegin\n",
           "scene.pbrt:1:9: error: unknown sampler \"sobl\"\n    Sampler \"sobl\"\n            ^^^^^^\n"
           "    did you mean \"sobol\"?");
    refuse("PixelFilter \"gausian\"\nWorldBegin\n", "scene.pbrt:1:13: error: unknown pixel filter \"gausian\"\n    "
                                                    "PixelFilter \"gausian\"\n                ^^^^^^^^^\n"
                                                    "    did you mean \"gaussian\"?");
}

} // namespace
} // namespace vitrine
