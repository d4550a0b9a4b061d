// The exact text of scene errors: it is what users see.
#include "scene_text.h"

namespace vitrine {
namespace {

TEST(SceneErrors, UnknownDirective) {
    EXPECT_EQ(errorsOf("WorldBegin\n  Shpae \"sphere\" \"float radius\" 1\n"),
              "scene.pbrt:2:3: error: unknown directive \"Shpae\"\n"
              "      Shpae \"sphere\" \"float radius\" 1\n"
              "      ^^^^^\n"
              "    did you mean \"Shape\"?");
}

TEST(SceneErrors, UnknownParameterType) {
    EXPECT_EQ(errorsOf("Camera \"perspective\" \"flaot fov\" 40\nWorldBegin"),
              "scene.pbrt:1:22: error: unknown parameter type \"flaot\"\n"
              "    Camera \"perspective\" \"flaot fov\" 40\n"
              "                         ^^^^^^^^^^^\n"
              "    did you mean \"float\"?");
}

TEST(SceneErrors, ColorOfVersion3) {
    EXPECT_EQ(errorsOf("WorldBegin\nLightSource \"point\" \"color I\" [ 1 1 1 ]"),
              "scene.pbrt:2:21: error: unknown parameter type \"color\"\n"
              "    LightSource \"point\" \"color I\" [ 1 1 1 ]\n"
              "                        ^^^^^^^^^\n"
              "    pbrt-v4 calls it \"rgb\"");
}

TEST(SceneErrors, WordAmongNumbers) {
    EXPECT_EQ(errorsOf("WorldBegin\nShape \"trianglemesh\" \"point3 P\" [ 0 0 zero ]"),
              "scene.pbrt:2:39: error: \"point3 P\": expected a number, got \"zero\"\n"
              "    Shape \"trianglemesh\" \"point3 P\" [ 0 0 zero ]\n"
              "                                          ^^^^");
}

TEST(SceneErrors, RealForInteger) {
    EXPECT_EQ(errorsOf("Sampler \"independent\" \"integer pixelsamples\" 1.5\nWorldBegin"),
              "scene.pbrt:1:46: error: \"integer pixelsamples\": expected an integer, got \"1.5\"\n"
              "    Sampler \"independent\" \"integer pixelsamples\" 1.5\n"
              "                                                 ^^^");
}

TEST(SceneErrors, StringForNumber) {
    EXPECT_EQ(errorsOf("Camera \"perspective\" \"float fov\" \"wide\"\nWorldBegin"),
              "scene.pbrt:1:34: error: \"float fov\": expected a number, got the string \"wide\"\n"
              "    Camera \"perspective\" \"float fov\" \"wide\"\n"
              "                                     ^^^^^^");
}

TEST(SceneErrors, NumbersThatAreNotFinite) {
    EXPECT_EQ(errorsOf("WorldBegin\nShape \"sphere\" \"float radius\" nan"),
              "scene.pbrt:2:31: error: \"float radius\": numbers must be finite, got \"nan\"\n"
              "    Shape \"sphere\" \"float radius\" nan\n"
              "                                  ^^^");
    EXPECT_EQ(errorsOf("WorldBegin\nTranslate 0 -inf 0"),
              "scene.pbrt:2:13: error: numbers must be finite, got \"-inf\"\n"
              "    Translate 0 -inf 0\n"
              "                ^^^^");
}

TEST(SceneErrors, NumberTooLarge) {
    EXPECT_EQ(errorsOf("Film \"rgb\" \"integer xresolution\" 99999999999\nWorldBegin"),
              "scene.pbrt:1:34: error: \"integer xresolution\": \"99999999999\" does not fit in a 32-bit integer\n"
              "    Film \"rgb\" \"integer xresolution\" 99999999999\n"
              "                                     ^^^^^^^^^^^");
    EXPECT_EQ(errorsOf("WorldBegin\nScale 1e300 1 1"),
              "scene.pbrt:2:7: error: \"1e300\" is too large: numbers go up to 3.4e38\n"
              "    Scale 1e300 1 1\n"
              "          ^^^^^");
}

TEST(SceneErrors, ParameterGivenTwice) {
    EXPECT_EQ(errorsOf("WorldBegin\nShape \"sphere\" \"float radius\" 1\n    \"float radius\" 2"),
              "scene.pbrt:3:5: error: parameter \"radius\" is given twice\n"
              "        \"float radius\" 2\n"
              "        ^^^^^^^^^^^^^^\n"
              "    first at scene.pbrt:2:16");
}

TEST(SceneErrors, MissingBracket) {
    EXPECT_EQ(errorsOf("WorldBegin\nShape \"sphere\" \"float radius\" [ 1\nIdentity\n"),
              "scene.pbrt:3:1: error: expected \"]\", got \"Identity\"\n"
              "    Identity\n"
              "    ^^^^^^^^\n"
              "    the list of \"radius\" begins at 2:31");
}

TEST(SceneErrors, WordsAmongBoolsAndStrings) {
    EXPECT_EQ(errorsOf("WorldBegin\nShape \"curve\" \"string type\" [ Flat ]"),
              "scene.pbrt:2:31: error: \"string type\": expected a string, got \"Flat\"\n"
              "    Shape \"curve\" \"string type\" [ Flat ]\n"
              "                                  ^^^^\n"
              "    strings stand in double quotes");
    EXPECT_EQ(errorsOf("WorldBegin\nShape \"curve\" \"bool b\" True"),
              "scene.pbrt:2:24: error: \"bool b\": expected true or false, got \"True\"\n"
              "    Shape \"curve\" \"bool b\" True\n"
              "                           ^^^^");
}

TEST(SceneErrors, MissingQuote) {
    EXPECT_EQ(errorsOf("WorldBegin\nShape \"sphere\nIdentity"),
              "scene.pbrt:2:7: error: the string lacks its closing quote\n"
              "    Shape \"sphere\n"
              "          ^^^^^^^");
}

TEST(SceneErrors, UnknownEscape) {
    EXPECT_EQ(errorsOf("Film \"rgb\" \"string filename\" \"C:\\x\"\nWorldBegin"),
              "scene.pbrt:1:33: error: unknown escape \"\\x\" in a string\n"
              "    Film \"rgb\" \"string filename\" \"C:\\x\"\n"
              "                                    ^^\n"
              "    write \"\\\\\" for a backslash");
}

TEST(SceneErrors, DeclarationWithoutType) {
    EXPECT_EQ(errorsOf("WorldBegin\nShape \"sphere\" \"radius\" 1"),
              "scene.pbrt:2:16: error: \"radius\" is no parameter: it needs a type and a name, as in \"float radius\"\n"
              "    Shape \"sphere\" \"radius\" 1\n"
              "                   ^^^^^^^^");
}

TEST(SceneErrors, EmptyList) {
    EXPECT_EQ(errorsOf("WorldBegin\nShape \"sphere\" \"float radius\" [ ]"),
              "scene.pbrt:2:31: error: \"float radius\" has no value\n"
              "    Shape \"sphere\" \"float radius\" [ ]\n"
              "                                  ^");
}

TEST(SceneErrors, OptionsAfterWorldBegin) {
    EXPECT_EQ(errorsOf("WorldBegin\nFilm \"rgb\""), "scene.pbrt:2:1: error: Film must stand before WorldBegin\n"
                                                    "    Film \"rgb\"\n"
                                                    "    ^^^^");
    EXPECT_EQ(errorsOf("WorldBegin\nWorldBegin"), "scene.pbrt:2:1: error: WorldBegin stands here a second time\n"
                                                  "    WorldBegin\n"
                                                  "    ^^^^^^^^^^");
}

TEST(SceneErrors, ShapesWithoutWorldBeginAreOneError) {
    EXPECT_EQ(errorsOf("Shape \"sphere\"\nShape \"disk\"\nMaterial \"diffuse\""),
              "scene.pbrt:1:1: error: Shape must stand after WorldBegin\n"
              "    Shape \"sphere\"\n"
              "    ^^^^^");
}

TEST(SceneErrors, NoWorldAtAll) {
    EXPECT_EQ(errorsOf(""), "scene.pbrt: error: the scene ends without WorldBegin");
    EXPECT_EQ(errorsOf("# nothing\n"), "scene.pbrt: error: the scene ends without WorldBegin");
}

TEST(SceneErrors, WorldEndOfVersion3) {
    EXPECT_EQ(errorsOf("WorldBegin\nWorldEnd\n"), "scene.pbrt:2:1: error: unknown directive \"WorldEnd\"\n"
                                                  "    WorldEnd\n"
                                                  "    ^^^^^^^^\n"
                                                  "    a pbrt-v4 scene ends with its file: remove it");
}

TEST(SceneErrors, BlocksThatDoNotMatch) {
    EXPECT_EQ(errorsOf("WorldBegin\nAttributeEnd"), "scene.pbrt:2:1: error: AttributeEnd closes nothing\n"
                                                    "    AttributeEnd\n"
                                                    "    ^^^^^^^^^^^^");
    EXPECT_EQ(errorsOf("WorldBegin\nAttributeBegin\n"),
              "scene.pbrt:2:1: error: this AttributeBegin has no AttributeEnd\n"
              "    AttributeBegin\n"
              "    ^^^^^^^^^^^^^^");
    EXPECT_EQ(errorsOf("WorldBegin\nObjectBegin \"a\"\nAttributeEnd\nObjectEnd"),
              "scene.pbrt:3:1: error: AttributeEnd inside the object definition of line 2, which is still open\n"
              "    AttributeEnd\n"
              "    ^^^^^^^^^^^^");
    EXPECT_EQ(errorsOf("WorldBegin\nObjectBegin \"a\"\nAttributeBegin\nObjectEnd"),
              "scene.pbrt:4:1: error: ObjectEnd inside an AttributeBegin block\n"
              "    ObjectEnd\n"
              "    ^^^^^^^^^\n"
              "    the block begins at scene.pbrt:3:1");
}

TEST(SceneErrors, NamesThatNobodyDefined) {
    EXPECT_EQ(
        errorsOf("WorldBegin\nMakeNamedMaterial \"glass\" \"string type\" \"dielectric\"\nNamedMaterial \"galss\"\n"
                 "Shape \"sphere\"\nObjectInstance \"tree\""),
        "scene.pbrt:3:15: error: there is no material \"galss\"\n"
        "    NamedMaterial \"galss\"\n"
        "                  ^^^^^^^\n"
        "    did you mean \"glass\"?\n"
        "scene.pbrt:5:16: error: there is no object \"tree\"\n"
        "    ObjectInstance \"tree\"\n"
        "                   ^^^^^^");
}

TEST(SceneErrors, Transformations) {
    EXPECT_EQ(errorsOf("Scale 1 0 1\nWorldBegin"), "scene.pbrt:1:1: error: Scale: a scale factor must not be zero\n"
                                                   "    Scale 1 0 1\n"
                                                   "    ^^^^^");
    EXPECT_EQ(errorsOf("LookAt 0 0 0  0 0 1  0 0 2\nWorldBegin"),
              "scene.pbrt:1:1: error: LookAt: the up vector must not be parallel to the viewing direction\n"
              "    LookAt 0 0 0  0 0 1  0 0 2\n"
              "    ^^^^^^");
    EXPECT_EQ(errorsOf("Transform [1 0 0 0  2 0 0 0  0 0 1 0  0 0 0 1]\nWorldBegin"),
              "scene.pbrt:1:1: error: Transform: the matrix is singular\n"
              "    Transform [1 0 0 0  2 0 0 0  0 0 1 0  0 0 0 1]\n"
              "    ^^^^^^^^^");
    EXPECT_EQ(errorsOf("Translate 1 2\nWorldBegin"),
              "scene.pbrt:2:1: error: Translate takes 3 numbers: expected number 3, got \"WorldBegin\"\n"
              "    WorldBegin\n"
              "    ^^^^^^^^^^");
}

TEST(SceneErrors, SeveralInOneRun) {
    EXPECT_EQ(errorsOf("Camera \"perspective\" \"float fov\" wide\nSampler independent\nWorldBegin\nShape \"sphere\" "
                       "\"float\" 1\n"),
              "scene.pbrt:1:34: error: \"float fov\": expected a number, got \"wide\"\n"
              "    Camera \"perspective\" \"float fov\" wide\n"
              "                                     ^^^^\n"
              "scene.pbrt:2:9: error: expected the type of Sampler, got \"independent\"\n"
              "    Sampler independent\n"
              "            ^^^^^^^^^^^\n"
              "    strings stand in double quotes\n"
              "scene.pbrt:4:16: error: \"float\" is no parameter: it needs a type and a name, as in \"float radius\"\n"
              "    Shape \"sphere\" \"float\" 1\n"
              "                   ^^^^^^^");
}

TEST(SceneErrors, ReadingStopsAfterTheMost) {
    std::string text = "WorldBegin\n";
    for (int i = 0; i < 1000; ++i)
        text += "Shape sphere\n";
    EXPECT_EQ(errorCount(text), Diagnostics::maxErrors);
}

TEST(SceneErrors, AnUnknownBlockDirectiveIsOneError) {
    EXPECT_EQ(errorCount("WorldBegin\nAttributBegin\nShape \"sphere\"\nAttributeEnd\n"), 1u);
    EXPECT_EQ(errorCount("WorldBegin\nAttributeBegin\nShape \"sphere\"\nAtributeEnd\n"), 1u);
}

TEST(SceneErrors, BytesThatAreNoText) {
    EXPECT_EQ(errorsOf(std::string("WorldBegin\nShape \0", 18)),
              "scene.pbrt:2:7: error: a NUL byte: this is not the text of a scene\n"
              "    Shape  \n"
              "          ^");
    EXPECT_EQ(errorsOf("\xff\xfeW"), "scene.pbrt: error: the file is UTF-16\n    save it as UTF-8");
}

} // namespace
} // namespace vitrine
