// What the Option directive does to a scene.
#include "scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

using testing::HasSubstr;

std::string errorOf(const std::string& options) {
    try {
        loadSceneString(options + "\nWorldBegin\nShape \"sphere\"\n", "scene");
    } catch (const SceneError& e) {
        return e.what();
    }
    return "none";
}

TEST(Options, ThatChangeThePictureAreRefused) {
    for (const std::string name : {"disablepixeljitter", "disablewavelengthjitter", "forcediffuse", "pixelstats"}) {
        const std::string error = errorOf("Option \"" + name + "\" true");
        EXPECT_THAT(error, HasSubstr("option \"" + name + "\" is not yet supported"));
        EXPECT_THAT(error, HasSubstr("scene:1:8"));
        EXPECT_EQ(errorOf("Option \"" + name + "\" false"), "none");
    }
    EXPECT_THAT(errorOf("Option \"msereferenceimage\" \"a.exr\""), HasSubstr("is not yet supported"));
}

TEST(Options, OfPbrtsInnerWorkingsChangeNothing) {
    EXPECT_EQ(errorOf("Option \"wavefront\" true\nOption \"rendercoordsys\" \"world\"\n"
                      "Option \"displacementedgescale\" 2\nOption \"disabletexturefiltering\" true"),
              "none");
}

} // namespace
} // namespace vitrine
