// Revolutions by SVG: exact text of the errors, and a file as Inkscape writes it.
#include "program_test.h"

#include <nlohmann/json.hpp>

namespace vitrine {
namespace {

using namespace test;

class SvgProfiles : public ProgramTest {
  protected:
    void refuse(const std::string& parameters, const std::string& message) const {
        SCOPED_TRACE(parameters);
        write("scene.pbrt", "WorldBegin\nShape \"revolution\" " + parameters + "\n");
        fail({"info", "scene.pbrt"}, 1, message);
    }
    void writeSvg(const std::string& content) const {
        write("a.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\">\n" + content + "\n</svg>\n");
    }
    nlohmann::json info(const std::string& parameters) const {
        write("scene.pbrt", "WorldBegin\nShape \"revolution\" " + parameters + "\n");
        const ProgramResult result = run({"info", "scene.pbrt", "--json"});
        EXPECT_EQ(result.exitCode, 0) << result.describe();
        return result.exitCode == 0 ? nlohmann::json::parse(result.out) : nlohmann::json();
    }
};

TEST_F(SvgProfiles, ErrorsInPathDataPointIntoTheString) {
    refuse("\"string path\" \"M 0 0 L 1 1 X 2\"", "scene.pbrt:2:47: error: expected a path command, got \"X\"\n"
                                                  "    Shape \"revolution\" \"string path\" \"M 0 0 L 1 1 X 2\"\n"
                                                  "                                                  ^\n"
                                                  "    the commands are M L H V Q C S T A Z and their lower case");
    refuse("\"string path\" [ \"M 0 0\" \"\\tC 1 2 3\" ]",
           "scene.pbrt:2:54: error: expected number 4 of 6 of \"C\", got the end\n"
           "    Shape \"revolution\" \"string path\" [ \"M 0 0\" \"\\tC 1 2 3\" ]\n"
           "                                                         ^");
    refuse("\"string path\" \"M 1 0 C -1 1 -1 2 1 3\"",
           "scene.pbrt:2:41: error: the radius x(t) is -0.5 at t = 0.5 of this segment, (-0.5, 1.5) in the drawing; it "
           "must not be negative\n"
           "    Shape \"revolution\" \"string path\" \"M 1 0 C -1 1 -1 2 1 3\"\n"
           "                                            ^^^^^^^^^^^^^^^\n"
           "    the axis is x = 0 in the drawing: \"point2 origin\" moves it");
    refuse("\"string path\" \"M 1 0\"", "scene.pbrt:2:20: error: the path draws nothing\n"
                                        "    Shape \"revolution\" \"string path\" \"M 1 0\"\n"
                                        "                       ^^^^^^^^^^^^^");
}

TEST_F(SvgProfiles, ErrorsInAFilePointIntoIt) {
    writeSvg("<g transform=\"translate(0 2)\">\n  <path id=\"a\" d=\"M 0 0 h 1&#10;c-3 0-3 3 0 3\"/>\n"
             "  <path id=\"b\" d=\"M 0 0 h 1 k\"/>\n</g>");
    refuse(
        "\"string filename\" \"a.svg\" \"string id\" \"a\"",
        "a.svg:3:33: error: the radius x(t) is -1.25 at t = 0.5 of this segment, (-1.25, 3.5) in the drawing; it must "
        "not be negative\n"
        "      <path id=\"a\" d=\"M 0 0 h 1&#10;c-3 0-3 3 0 3\"/>\n"
        "                                    ^^^^^^^^^^^^^\n"
        "    the axis is x = 0 in the drawing: \"point2 origin\" moves it\n"
        "    included from scene.pbrt:2");
    refuse("\"string filename\" \"a.svg\" \"string id\" \"b\"",
           "a.svg:4:29: error: expected a path command, got \"k\"\n"
           "      <path id=\"b\" d=\"M 0 0 h 1 k\"/>\n"
           "                                ^\n"
           "    the commands are M L H V Q C S T A Z and their lower case\n"
           "    included from scene.pbrt:2");
}

TEST_F(SvgProfiles, WrongCombinations) {
    refuse(
        "",
        "scene.pbrt:2:1: error: a revolution needs its profile: \"point2 P\", \"string path\" or \"string filename\"\n"
        "    Shape \"revolution\" \n"
        "    ^^^^^");
    refuse("\"point2 P\" [ 0 0 1 1 ] \"string path\" \"M0 0H1\"",
           "scene.pbrt:2:43: error: a revolution takes one profile: \"P\" or \"path\"\n"
           "    Shape \"revolution\" \"point2 P\" [ 0 0 1 1 ] \"string path\" \"M0 0H1\"\n"
           "                                              ^^^^^^^^^^^^^");
    refuse("\"string path\" \"M0 0H1\" \"string id\" \"a\"",
           "scene.pbrt:2:43: error: unused parameter \"id\"\n"
           "    Shape \"revolution\" \"string path\" \"M0 0H1\" \"string id\" \"a\"\n"
           "                                              ^^^^^^^^^^^");
    refuse("\"string path\" \"M0 0H1\" \"float scale\" 0",
           "scene.pbrt:2:57: error: \"scale\" must be positive\n"
           "    Shape \"revolution\" \"string path\" \"M0 0H1\" \"float scale\" 0\n"
           "                                                            ^");
    refuse("\"string filename\" \"none.svg\"", "scene.pbrt:2:38: error: none.svg: no such file\n"
                                               "    Shape \"revolution\" \"string filename\" \"none.svg\"\n"
                                               "                                         ^^^^^^^^^^");
    writeSvg("<path id=\"body\" d=\"M0 0H1\"/><path id=\"foot\" d=\"M0 0H1\"/>");
    refuse("\"string filename\" \"a.svg\" \"string id\" \"bodi\"",
           "scene.pbrt:2:58: error: a.svg has no shape with the id \"bodi\"\n"
           "    Shape \"revolution\" \"string filename\" \"a.svg\" \"string id\" \"bodi\"\n"
           "                                                             ^^^^^^\n"
           "    did you mean \"body\"?");
    refuse("\"string filename\" \"a.svg\"", "scene.pbrt:2:38: error: a.svg has 2 shapes: choose one by its id\n"
                                            "    Shape \"revolution\" \"string filename\" \"a.svg\"\n"
                                            "                                         ^^^^^^^\n"
                                            "    they are \"body\", \"foot\"");
}

TEST_F(SvgProfiles, AFileAsInkscapeWritesIt) {
    std::filesystem::copy_file(VITRINE_SOURCE_DIR "/tests/scenes/svg/goblet.svg", path("goblet.svg"));
    const auto bound = [](const nlohmann::json& info, int side, int axis) {
        return info.at("bounds").at(std::size_t(side)).at(std::size_t(axis)).get<double>();
    };
    const std::string file = "\"string filename\" \"goblet.svg\" ";
    const auto goblet = info(file + "\"string id\" \"goblet\" \"point2 origin\" [ 105 250 ]");
    EXPECT_EQ(goblet.at("shapes").at("revolution"), 1);
    EXPECT_EQ(goblet.at("files"), nlohmann::json({"scene.pbrt", "goblet.svg"}));
    // The bowl is 46 mm wide at its widest joint, the foot stands on 0, the rim's arc of radius 0.9 ends below 183.
    EXPECT_NEAR(bound(goblet, 0, 0), -46, 1e-5);
    EXPECT_NEAR(bound(goblet, 1, 0), 46, 1e-5);
    EXPECT_NEAR(bound(goblet, 0, 1), 0, 1e-5);
    EXPECT_NEAR(bound(goblet, 1, 1), 182.77, 0.02);
    // In metres and mirrored by a matrix: a surface of radius 44.2 mm at 139.9 mm.
    const auto wine = info(file + "\"string id\" \"wine\" \"string unit\" \"m\" \"point2 origin\" [ .105 .25 ]");
    EXPECT_NEAR(bound(wine, 1, 0), 0.0442, 1e-7);
    EXPECT_NEAR(bound(wine, 1, 1), 0.1399, 1e-7);
}

} // namespace
} // namespace vitrine
