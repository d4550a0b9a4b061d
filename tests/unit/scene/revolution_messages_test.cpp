// What is said about turned profiles that are wrong or odd, and where.
#include "scene_text.h"

namespace vitrine {
namespace {

Lines revolutionErrors(const std::string& parameters) {
    return errorsOf("WorldBegin\nShape \"revolution\" " + parameters);
}

Lines warningsOf(const std::string& text) {
    Lines lines;
    for (const Diagnostic& d : built("WorldBegin\n" + text).warnings)
        lines.push_back(d.toString().substr(0, d.toString().find('\n')));
    return lines;
}

/// t of the curve and the control point in the file.
TEST(RevolutionMessages, NegativeRadius) {
    EXPECT_EQ(revolutionErrors("\"integer degree\" 2\n\"point2 P\" [ 1 0  1 .5  1 1\n   -2 1.5  1 2 ]"),
              Lines{"4:4: error: the radius x(t) of segment 1 is -0.5 at t = 0.5; it must not be negative"});
    EXPECT_EQ(revolutionErrors("\"point2 P\" [ -1 0 1 1 ]"),
              Lines{"2:33: error: the radius x(t) of segment 0 is -1 at t = 0; it must not be negative"});
    EXPECT_TRUE(revolutionErrors("\"point2 P\" [ 1 0 -0.9 .5 1 1 ]").empty()) << "only the control point is negative";
}

TEST(RevolutionMessages, WrongParameters) {
    EXPECT_EQ(revolutionErrors("\"point2 P\" [ 1 2 ]"),
              Lines{"2:20: error: a profile needs at least two control points, not one"});
    EXPECT_EQ(revolutionErrors("\"point2 P\" [ 1 2 3 ]"),
              Lines{"2:20: error: \"point2 P\" takes a multiple of 2 values, got 3"});
    EXPECT_EQ(revolutionErrors("\"point2 P\" [ ]"), Lines{"2:31: error: \"point2 P\" has no value"});
    std::string many = "1 0 ";
    for (int i = 0; i <= 10000; ++i)
        many += "1 1 ";
    EXPECT_EQ(revolutionErrors("\"integer degree\" 1 \"point2 P\" [ " + many + "]"),
              Lines{"2:39: error: a profile has at most 10000 segments, this one has 10001"});
    EXPECT_EQ(revolutionErrors("\"point2 P\" [ 1 0 1 1 ] \"string vmap\" \"arclenth\"").size(), 1u);
    EXPECT_TRUE(revolutionErrors("\"point2 P\" [ 1 0 1 1 ] \"string vmap\" \"arclength\"").empty());
    EXPECT_TRUE(revolutionErrors("\"point2 P\" [ 1 0 1 1 ] \"string vmap\" \"parameter\"").empty());
}

TEST(RevolutionMessages, OpenGlass) {
    const std::string open =
        "scene.pbrt:3:1: warning: this revolution is open: its profile neither ends on the axis at "
        "both ends nor comes back to its beginning; its dielectric needs other shapes of the same "
        "material to bound a solid";
    const std::string partial = "scene.pbrt:3:1: warning: this revolution is open: \"phimax\" is below 360; its "
                                "dielectric needs other shapes of the same material to bound a solid";
    const std::string tube = "Shape \"revolution\" \"point2 P\" [ 1 0 1 1 ]\n";
    const std::string bowl = "Shape \"revolution\" \"integer degree\" 1 \"point2 P\" [ 0 0 1 0 1 1 ]\n";
    const std::string can = "Shape \"revolution\" \"integer degree\" 1 \"point2 P\" [ 0 0 1 0 1 1 0 1 ]";
    const std::string ring = "Shape \"revolution\" \"integer degree\" 1 \"point2 P\" [ 1 0 2 0 2 1 1 0 ]\n";
    for (const std::string glass : {"Material \"dielectric\"\n", "Material \"dielectric\" \"integer priority\" 1\n",
                                    "Material \"dielectric\" \"rgb absorption\" [ 1 1 2 ]\n"}) {
        EXPECT_EQ(warningsOf(glass + tube), Lines{open}) << glass;
        EXPECT_EQ(warningsOf(glass + bowl), Lines{open}) << glass;
        EXPECT_EQ(warningsOf(glass + can + " \"float phimax\" 90\n"), Lines{partial}) << glass;
        EXPECT_EQ(warningsOf(glass + can + "\n"), Lines{}) << glass;
        EXPECT_EQ(warningsOf(glass + ring), Lines{}) << glass;
        EXPECT_EQ(warningsOf(glass + "Scale 1 -1 1 " + ring), Lines{}) << "mirrored: " << glass;
    }
    EXPECT_EQ(warningsOf("Material \"diffuse\"\n" + tube), Lines{});
    EXPECT_EQ(warningsOf("Material \"thindielectric\"\n" + tube), Lines{}) << "a sheet without an inside";
    EXPECT_EQ(warningsOf("Material \"dielectric\"\nReverseOrientation " + can + "\n"), Lines{}) << "a bubble";
    EXPECT_EQ(warningsOf("Material \"dielectric\" \"integer priority\" 1\nReverseOrientation " + can + "\n").size(),
              1u);
}

TEST(RevolutionMessages, GlassThatCrossesItself) {
    const auto warned = [](const std::string& material, const std::string& points) {
        return warningsOf("Material \"" + material + "\"\nShape \"revolution\" \"integer degree\" 1 \"point2 P\" [" +
                          points + "]\n");
    };
    const std::string prefix = "scene.pbrt:3:1: warning: the profile of this revolution crosses itself: ";
    const std::string eight = ".2 .1 1 1.1 1 -.5 .2 1.1 .2 .1";
    EXPECT_EQ(warned("dielectric", eight),
              Lines{prefix + "the lobe near radius 0.2, height 0.5375 is wound the other way, "
                             "so that its dielectric is inside out"});
    EXPECT_EQ(warned("dielectric", "1 0 3 0 3 2 1 2 1 .5 2.5 .5 2.5 1.5 .5 1.5 .5 0 1 0"),
              Lines{prefix +
                    "the line near radius 1.844, height 0.5 lies inside of its own solid, where a dielectric has "
                    "no surface"});
    EXPECT_EQ(warned("diffuse", eight), Lines{});
    EXPECT_EQ(warned("thindielectric", eight), Lines{});
    EXPECT_EQ(warned("dielectric", "0 0 1 0 1 .5 2 .5 1 .5 1 1 0 1"), Lines{}) << "a fin of no thickness";
}

} // namespace
} // namespace vitrine
