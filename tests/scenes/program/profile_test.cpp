// vitrine profile, run as a user runs it.
#include "program_test.h"

#include <gmock/gmock.h>

namespace vitrine {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::Not;

class ProfileCommand : public ProgramTest {
  protected:
    /// A paraboloid y = x^2 to x = 2, moved up by 1, and one of straight lines in an object.
    void SetUp() override {
        write("scene.pbrt", "WorldBegin\nTranslate 0 1 0\n"
                            "Shape \"revolution\" \"point2 P\" [ 0 0 1 0 2 4 ]\n"
                            "ObjectBegin \"can\"\nShape \"revolution\" \"integer degree\" 1\n"
                            "  \"point2 P\" [ 0 0 1 0 1 2 0 2 ]\nObjectEnd\n"
                            "Translate 10 0 0\nObjectInstance \"can\"\nTranslate 10 0 0\nObjectInstance \"can\"\n");
        write("drawing.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\" "
                             "viewBox=\"0 0 100 100\">\n<path id=\"bowl\" d=\"M 50 80 C 70 80 80 70 80 40\"/>\n"
                             "<path id=\"across\" d=\"M 30 80 L 70 20\"/>\n"
                             "<defs><path id=\"spare\" d=\"M 60 10 V 90\"/></defs></svg>\n");
    }
    static std::size_t count(const std::string& text, const std::string& part) {
        std::size_t n = 0;
        for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
            ++n;
        return n;
    }
};

TEST_F(ProfileCommand, DrawsEveryProfileOnce) {
    succeed({"profile", "scene.pbrt"});
    const std::string svg = read("scene_profile.svg");
    EXPECT_EQ(count(svg, "<g class=\"figure\">"), 2u);
    EXPECT_EQ(count(svg, "<g class=\"hodograph-2\">"), 2u);
    EXPECT_THAT(svg, HasSubstr(">Revolution at scene.pbrt:3<"));
    EXPECT_THAT(svg, HasSubstr(">Revolution at scene.pbrt:5<"));
    EXPECT_THAT(svg, HasSubstr(">open: one segment of degree 2, 3 control points; length 4.6468 units, radius 0 to 2, "
                               "height 0 to 4<"));
    EXPECT_THAT(svg, HasSubstr(">closed: 3 segments of degree 1, 4 control points; length 4 units, radius 0 to 1, "
                               "height 0 to 2; in object \"can\"<"));
    EXPECT_THAT(svg, Not(HasSubstr("<g class=\"ray\">")));
    succeed({"profile", "scene.pbrt", "-o", "again.svg"});
    EXPECT_EQ(read("again.svg"), svg);
    succeed({"profile", "scene.pbrt", "--only", "2", "-o", "two.svg"});
    EXPECT_THAT(read("two.svg"), Not(HasSubstr("scene.pbrt:3<")));
    EXPECT_THAT(read("two.svg"), HasSubstr("scene.pbrt:5<"));
}

TEST_F(ProfileCommand, ListsTheRootsOfAWorldSpaceRay) {
    // In the paraboloid's space y = 1, x = s - 3: met at x = -1 and 1, t = 1/2.
    succeed({"profile", "scene.pbrt", "--only", "1", "--ray", "-3,2,0,1,0,0", "-o", "ray.svg"});
    const std::string svg = read("ray.svg");
    EXPECT_THAT(svg, HasSubstr(">The ray meets the surface 2 times<"));
    EXPECT_THAT(svg, HasSubstr(">2.00000<"));
    EXPECT_THAT(svg, HasSubstr(">4.00000<"));
    EXPECT_EQ(count(svg, ">0.500000<"), 2u);
    EXPECT_THAT(svg, HasSubstr("<g class=\"distance-over-s\">"));
    // Of the can's instances, at x = 10 and 20, this one meets the second alone.
    succeed({"profile", "scene.pbrt", "--only", "2", "--ray", "20,5,0,0,-1,0", "-o", "can.svg"});
    EXPECT_THAT(read("can.svg"), HasSubstr("seen from instance 2 of 2<"));
    EXPECT_THAT(read("can.svg"), HasSubstr(">The ray meets the surface 2 times<"));
}

TEST_F(ProfileCommand, WritesPng) {
    succeed({"profile", "scene.pbrt", "--only", "1", "-o", "a.png"});
    const Image image = readImage(path("a.png"));
    EXPECT_EQ(image.width, 1960);
    EXPECT_GT(image.height, 1000);
    EXPECT_EQ(image.at(0, 0, 0), 1); // paper
    // The curve's blue is there, which nothing but segments has.
    std::size_t blue = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            blue += image.at(x, y, 2) > 3 * image.at(x, y, 1) && image.at(x, y, 1) > 5 * image.at(x, y, 0);
    EXPECT_GT(blue, 3000u);
    succeed({"profile", "scene.pbrt", "--only", "1", "-o", "b.png"});
    EXPECT_EQ(read("a.png"), read("b.png"));
}

TEST_F(ProfileCommand, DrawsOutlinesOfSvgFiles) {
    const ProgramResult result = run({"profile", "drawing.svg", "--set", "origin=50,80", "--set", "unit=mm", "--ray",
                                      "-50,10,0,1,0,0", "-o", "out.svg"});
    EXPECT_EQ(result.exitCode, 0) << result.describe();
    EXPECT_THAT(result.err, HasSubstr("drawing.svg:3:30: warning: the radius x(t) is -20 at t = 0"));
    const std::string svg = read("out.svg");
    EXPECT_EQ(count(svg, "<g class=\"figure\">"), 2u); // not the spare one
    EXPECT_THAT(svg, HasSubstr(">path \"bowl\" at drawing.svg:2<"));
    EXPECT_THAT(svg, HasSubstr("radius 0 to 30, height 0 to 40<"));
    EXPECT_THAT(svg, HasSubstr("radius <tspan font-style=\"italic\">x</tspan> (mm)"));
    EXPECT_THAT(svg, HasSubstr(">Cannot be turned: the radius x(t) is -20"));
    EXPECT_EQ(count(svg, "<g class=\"ray\">"), 1u);
    succeed({"profile", "drawing.svg", "--only", "spare", "-o", "spare.svg"});
    EXPECT_THAT(read("spare.svg"), HasSubstr(">path \"spare\" at drawing.svg:4<"));
    EXPECT_EQ(count(read("spare.svg"), "<g class=\"figure\">"), 1u);
}

TEST_F(ProfileCommand, NamesWhatIsWrong) {
    write("plain.pbrt", "WorldBegin\nShape \"sphere\"\n");
    fail({"profile", "plain.pbrt"}, 1, "vitrine: plain.pbrt: there is no shape \"revolution\" in this scene");
    write("empty.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n");
    fail({"profile", "empty.svg"}, 1, "vitrine: empty.svg: there is no outline in this drawing");
    fail({"profile", "scene.pbrt", "--only", "3"}, 1, "vitrine: --only 3: the profiles have the numbers 1 to 2");
    const ProgramResult misspelt = run({"profile", "drawing.svg", "--set", "origin=50,80", "--only", "bowel"});
    EXPECT_EQ(misspelt.exitCode, 1);
    EXPECT_THAT(misspelt.err, HasSubstr("did you mean \"bowl\"?"));
    fail({"profile", "scene.pbrt", "--ray", "1,2,3,4,5"}, 1,
         "vitrine: --ray takes 6 numbers separated by ',', not \"1,2,3,4,5\"");
    fail({"profile", "scene.pbrt", "--ray", "1,2,3,0,0,0"}, 1, "vitrine: --ray: the direction is zero");
    fail({"profile", "scene.pbrt", "-o", "a.gif"}, 1, "vitrine: a.gif: a figure is written as .svg or .png");
    fail({"profile", "drawing.svg", "-o", "./drawing.svg"}, 1,
         "vitrine: ./drawing.svg: the figure would replace what is drawn");
    fail({"profile", "scene.pbrt", "--set", "origin=1,0"}, 1,
         "vitrine: --set says where the axis is in an SVG file: a scene says so itself");
    fail({"profile", "drawing.svg", "--set", "orign=1,0"}, 1,
         "--set:1:7: error: unused parameter \"orign\"\n    orign=1,0\n          ^^^\n    did you mean \"origin\"?");
    write("broken.pbrt", "WorldBegin\nShape \"revolution\" \"point2 P\" [ 1 0 -1 1 ]\n");
    const ProgramResult broken = run({"profile", "broken.pbrt"});
    EXPECT_EQ(broken.exitCode, 1);
    EXPECT_THAT(broken.err, HasSubstr("broken.pbrt:2:"));
    for (const char* name : {"plain", "empty", "scene", "drawing", "broken"})
        EXPECT_FALSE(exists(std::string(name) + "_profile.svg"));
}

/// Neither is waited for: what is chosen is looked up first, and too much is refused.
TEST_F(ProfileCommand, LargeDrawings) {
    std::string line = "M 50 0", many;
    for (int i = 0; i < 2001; ++i)
        line += " v 1";
    for (int i = 0; i < 30000; ++i)
        many += "<path d=\"M 60 0 c 9 9 9 9 0 9\"/>\n";
    const std::string header = "<svg xmlns=\"http://www.w3.org/2000/svg\">\n";
    write("long.svg", header + "<path id=\"long\" d=\"" + line + "\"/>\n<path id=\"bad\" d=\"M 1 k\"/>\n" +
                          "<path id=\"short\" d=\"M 60 0 v 1\"/></svg>\n");
    write("many.svg", header + many + "</svg>\n");
    const ProgramResult tooLong = run({"profile", "long.svg", "--only", "long"});
    EXPECT_EQ(tooLong.exitCode, 1);
    EXPECT_THAT(tooLong.err,
                testing::StartsWith("long.svg:2:2: error: a figure shows at most 2000 segments, this profile "
                                    "has 2001\n"));
    EXPECT_THAT(tooLong.err, testing::EndsWith("\n    --only chooses another one\n"));
    fail({"profile", "many.svg", "--only", "none"}, 1,
         "vitrine: --only none: the profiles have the numbers 1 to 30000");
    const ProgramResult bad = run({"profile", "long.svg", "--only", "bad"});
    EXPECT_EQ(bad.exitCode, 1);
    EXPECT_THAT(bad.err, HasSubstr("long.svg:3:"));
    EXPECT_THAT(bad.err, Not(HasSubstr("warning")));
    EXPECT_FALSE(exists("long_profile.svg"));
    succeed({"profile", "long.svg", "--only", "short"});
    write("broken.svg", header + "<path id=\"a\" d=\"M 1 k\"/></svg>\n");
    fail({"profile", "broken.svg", "--only", "b"}, 1, "vitrine: broken.svg: there is no outline in this drawing");
}

TEST_F(ProfileCommand, FilesThatCannotBeReadOrWritten) {
    EXPECT_EQ(run({"profile", "none.pbrt"}).exitCode, 2);
    EXPECT_EQ(run({"profile", "none.svg"}).exitCode, 2);
    const ProgramResult result = run({"profile", "scene.pbrt", "-o", "nowhere/a.svg"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.err, HasSubstr("nowhere/a.svg: cannot be written: No such file or directory"));
}

} // namespace
} // namespace vitrine
