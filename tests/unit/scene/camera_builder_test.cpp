// Apertures and movements as scenes write them, and what is said of wrong ones.
#include "film/imageio.h"
#include "scene/scene.h"
#include "support/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

using Lines = std::vector<std::string>;

/// "line: message" each; empty for a scene that loads.
Lines errorsOf(const std::string& text, const std::string& folder = "") {
    Lines lines;
    try {
        loadSceneString(text, "scene.pbrt", {}, folder);
    } catch (const SceneError& e) {
        for (const Diagnostic& d : e.diagnostics())
            lines.push_back(fmt::format("{}: {}", d.place.line, d.message));
    }
    return lines;
}

Lines cameraErrors(const std::string& type, const std::string& parameters, const std::string& folder = "") {
    return errorsOf(fmt::format("Camera \"{}\" {}\nWorldBegin\n", type, parameters), folder);
}

TEST(CameraBuilder, Apertures) {
    const test::TemporaryFolder folder;
    writeImage(folder.file("mask.pfm"), Image{2, 1, 1, {1, 0}});
    writeImage(folder.file("black.pfm"), Image{2, 1, 1, {0, 0}});
    for (const char* type : {"perspective", "orthographic"}) {
        for (const char* good :
             {"\"string aperture\" \"circular\"", "\"string aperture\" \"pentagon\"",
              "\"string aperture\" \"square\" \"float aperturerotation\" 20", "\"string aperture\" \"star\"",
              "\"integer apertureblades\" 7", "\"string aperture\" \"mask.pfm\""})
            EXPECT_EQ(cameraErrors(type, std::string("\"float lensradius\" .1 ") + good, folder.file("")), Lines{})
                << type << good;
        EXPECT_EQ(cameraErrors(type, "\"integer apertureblades\" 2"), Lines{"1: an aperture has 3 blades or more"});
        EXPECT_EQ(cameraErrors(type, "\"string aperture\" \"star\" \"integer apertureblades\" 5"),
                  Lines{"1: a camera takes \"aperture\" or \"apertureblades\", not both"});
        EXPECT_EQ(cameraErrors(type, "\"string aperture\" \"black.pfm\"", folder.file("")),
                  Lines{"1: the aperture's image is black: no light passes"});
        const Lines missing = cameraErrors(type, "\"string aperture\" \"pentagn\"", folder.file(""));
        ASSERT_EQ(missing.size(), 1u);
        EXPECT_NE(missing[0].find("pentagn"), std::string::npos) << missing[0];
    }
    EXPECT_EQ(cameraErrors("spherical", "\"string aperture\" \"star\"").size(), 1u) << "it has no lens";
}

TEST(CameraBuilder, Movements) {
    const std::string move = "ActiveTransform EndTime\nTranslate 1 0 0\nActiveTransform All\n";
    const auto world = [&](const std::string& text) { return errorsOf("WorldBegin\n" + move + text); };
    EXPECT_EQ(errorsOf(move + "Camera \"perspective\"\nWorldBegin\n"), Lines{});
    for (const char* good : {"Shape \"sphere\"\n", "LightSource \"point\"\n", "LightSource \"infinite\"\n",
                             "AreaLightSource \"diffuse\"\nShape \"disk\"\n", "Shape \"plane\"\n",
                             "ObjectBegin \"o\"\nShape \"sphere\"\nObjectEnd\nObjectInstance \"o\"\n"})
        EXPECT_EQ(world(good), Lines{}) << good;
    EXPECT_EQ(world("Texture \"t\" \"spectrum\" \"checkerboard\" \"integer dimension\" 3\n"),
              Lines{"5: animated transformations are not yet supported"});
    EXPECT_EQ(errorsOf("TransformTimes 2 1\nWorldBegin\n" + move + "Shape \"sphere\"\n"),
              Lines{"6: TransformTimes gives an end before the start"});
    EXPECT_EQ(errorsOf("WorldBegin\nActiveTransform EndTime\nScale -1 1 1\nShape \"sphere\"\n"),
              Lines{"4: the transformation mirrors at one of its ends alone: between them it would be flat"});
}

} // namespace
} // namespace vitrine
