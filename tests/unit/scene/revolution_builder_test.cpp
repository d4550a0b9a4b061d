// Shape "revolution" from SVG: the scene depends on the file.
#include "scene_text.h"
#include "support/temporary_folder.h"

#include <fstream>

namespace vitrine {
namespace {

class RevolutionBySvg : public testing::Test {
  protected:
    void writeSvg(const std::string& content) const {
        std::ofstream(folder_.file("a.svg"), std::ios::binary) << "<svg>" << content << "</svg>";
    }
    Scene built(const std::string& parameters) const {
        return loadSceneString("WorldBegin\nShape \"revolution\" " + parameters, "scene.pbrt", {}, folder_.file(""));
    }
    Box3d boundsOf(const std::string& parameters) const { return built(parameters).world.caster->bounds(); }

    test::TemporaryFolder folder_;
};

TEST_F(RevolutionBySvg, TheFileIsOneOfTheScenes) {
    writeSvg("<path d=\"M0 0H1V-1H0\"/>");
    const std::string parameters = "\"string filename\" \"a.svg\"";
    const Scene before = built(parameters);
    ASSERT_EQ(before.files.size(), 2u);
    EXPECT_TRUE(before.files[1].ends_with("a.svg"));
    EXPECT_EQ(built(parameters).fingerprint, before.fingerprint);
    writeSvg("<path d=\"M0 0H1V-2H0\"/>");
    EXPECT_NE(built(parameters).fingerprint, before.fingerprint);
}

TEST_F(RevolutionBySvg, YPointsDownInFilesAndUpInPathData) {
    writeSvg("<path d=\"M0 0H1V3H0\"/>");
    EXPECT_NEAR(boundsOf("\"string filename\" \"a.svg\"").min.y, -3, 1e-6);
    EXPECT_NEAR(boundsOf("\"string filename\" \"a.svg\" \"bool flipy\" false").max.y, 3, 1e-6);
    EXPECT_NEAR(boundsOf("\"string path\" \"M0 0H1V3H0\"").max.y, 3, 1e-6);
    EXPECT_NEAR(boundsOf("\"string path\" \"M0 0H1V3H0\" \"bool flipy\" true").min.y, -3, 1e-6);
}

TEST_F(RevolutionBySvg, UnitOriginScaleAndAxis) {
    std::ofstream(folder_.file("a.svg"), std::ios::binary)
        << "<svg width=\"20cm\" viewBox=\"0 0 100 100\"><path d=\"M50 50H60V20H50\"/></svg>"; // 2 mm a unit
    const Box3d user = boundsOf("\"string filename\" \"a.svg\" \"point2 origin\" [ 50 50 ]");
    EXPECT_NEAR(user.max.x, 10, 1e-5);
    EXPECT_NEAR(user.max.y, 30, 1e-5);
    const Box3d cm =
        boundsOf("\"string filename\" \"a.svg\" \"point2 origin\" [ 10 10 ] \"string unit\" \"cm\" \"float scale\" 5");
    EXPECT_NEAR(cm.max.x, 10, 1e-5);
    EXPECT_NEAR(cm.max.y, 30, 1e-5);
    const Box3d lying = boundsOf("\"string filename\" \"a.svg\" \"point2 origin\" [ 50 50 ] \"string axis\" \"x\"");
    EXPECT_NEAR(lying.max.x, 30, 1e-5);
    EXPECT_NEAR(lying.max.y, 10, 1e-5);
}

TEST_F(RevolutionBySvg, StringsOfPathDataAreOneText) {
    EXPECT_NEAR(boundsOf("\"string path\" [ \"M 1 0 L 2\" \"1 C 2 2 3\" \"2 3 1\" ]").max.x, 3, 1e-5);
}

} // namespace
} // namespace vitrine
