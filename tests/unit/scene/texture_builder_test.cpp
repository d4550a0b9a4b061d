// Textures as scenes write them.
#include "scene_text.h"
#include "support/texture_points.h"
#include "texture_text.h"

namespace vitrine {
namespace {

void expectNear(const SampledSpectrum& found, const SampledSpectrum& expected) {
    for (int i = 0; i < spectrumSamples; ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-6);
}

/// Texture "t" "float" of this type.
std::string number(const std::string& type, const std::string& parameters = "") {
    return "Texture \"t\" \"float\" \"" + type + "\" " + parameters + "\n";
}
/// Texture "t" "spectrum" of this type.
std::string spectrum(const std::string& type, const std::string& parameters = "") {
    return "Texture \"t\" \"spectrum\" \"" + type + "\" " + parameters + "\n";
}

float valueOf(const std::string& text, const TexturePoint& point = {}) {
    return Textures(text).number("t", point);
}

Lines textureErrors(const std::string& text) {
    return errorsOf("WorldBegin\n" + text);
}

TEST(TextureBuilder, DefaultsArePbrts) {
    EXPECT_EQ(valueOf(number("constant")), 1);
    EXPECT_EQ(valueOf(number("scale")), 1);
    EXPECT_EQ(valueOf(number("mix")), 0.5f);
    EXPECT_EQ(valueOf(number("directionmix")), 1) << "a normal along z, the direction is y: tex2";
    EXPECT_EQ(valueOf(number("bilerp"), uvAt({0.3f, 0.25f})), 0.25f);
    EXPECT_EQ(valueOf(number("checkerboard"), uvAt({0.5f, 0.5f})), 1);
    EXPECT_EQ(valueOf(number("checkerboard"), uvAt({1.5f, 0.5f})), 0);
    EXPECT_EQ(valueOf(number("dots"), uvAt({-8, -3})), 1);
    EXPECT_EQ(valueOf(number("dots"), uvAt({-7, -3})), 0);
    const V3d p(0.3, 0.4, 0.7);
    EXPECT_NEAR(valueOf(number("fbm"), pointAt(p)), 0.01135266f, 1e-5) << "octaves 8, roughness 0.5";
    EXPECT_NEAR(valueOf(number("wrinkled"), pointAt(p)), 0.29653367f, 1e-5);
    EXPECT_NE(valueOf(number("windy"), pointAt(p)), 0);
    for (const char* type : {"constant", "scale", "mix", "directionmix", "bilerp", "checkerboard", "dots"}) {
        const TexturePoint point = uvAt({0.3f, 0.25f});
        expectNear(Textures(spectrum(type)).spectrum("t", SpectrumUse::Illuminant, point),
                   SampledSpectrum(valueOf(number(type), point)));
    }
}

TEST(TextureBuilder, ParametersArrive) {
    EXPECT_EQ(valueOf(number("constant", "\"float value\" 3")), 3);
    EXPECT_EQ(valueOf(number("scale", "\"float tex\" 3 \"float scale\" .5")), 1.5f);
    EXPECT_EQ(valueOf(number("mix", "\"float tex1\" 3 \"float tex2\" 5 \"float amount\" .25")), 3.5f);
    EXPECT_EQ(valueOf(number("directionmix", "\"float tex1\" 3 \"float tex2\" 5 \"vector3 dir\" [0 0 -2]")), 3);
    EXPECT_EQ(valueOf("Rotate 90 1 0 0\n" + number("directionmix", "\"float tex1\" 3 \"float tex2\" 5")), 3);
    const std::string corners = "\"float v00\" 1 \"float v01\" 2 \"float v10\" 3 \"float v11\" 4";
    EXPECT_EQ(valueOf(number("bilerp", corners), uvAt({0, 1})), 2);
    EXPECT_EQ(valueOf(number("bilerp", corners), uvAt({1, 0})), 3);
    EXPECT_EQ(valueOf(number("bilerp", corners), uvAt({1, 1})), 4);
    const std::string cubes = number("checkerboard", "\"integer dimension\" 3 \"float tex1\" 3 \"float tex2\" 5");
    EXPECT_EQ(valueOf(cubes, pointAt({0.5, 0.5, 0.5})), 3);
    EXPECT_EQ(valueOf(cubes, pointAt({0.5, 0.5, 1.5})), 5);
    EXPECT_EQ(valueOf("Scale 2 2 2\n" + cubes, pointAt({0.5, 0.5, 1.5})), 3);
    const std::string dots = number("dots", "\"float inside\" 3 \"float outside\" 5");
    EXPECT_EQ(valueOf(dots, uvAt({-8, -3})), 3);
    EXPECT_EQ(valueOf(dots, uvAt({-7, -3})), 5);
    EXPECT_EQ(valueOf(number("fbm", "\"integer octaves\" 0"), pointAt({0.3, 0.4, 0.7})), 0);
    EXPECT_NE(valueOf(number("fbm", "\"float roughness\" .7"), pointAt({0.3, 0.4, 0.7})),
              valueOf(number("fbm"), pointAt({0.3, 0.4, 0.7})));
    EXPECT_NEAR(valueOf(number("wrinkled", "\"integer octaves\" 0"), pointAt({0.3, 0.4, 0.7})), 0.2f, 1e-6);
    const auto marble = [](const std::string& parameters, const V3d& p) {
        return Textures(spectrum("marble", parameters)).spectrum("t", SpectrumUse::Albedo, pointAt(p));
    };
    expectNear(marble("\"float scale\" 2 \"float variation\" 0", {0.1, 0.2, 0.3}),
               marble("\"float variation\" 0", {0.1, 0.4, 0.3}));
    expectNear(marble("\"integer octaves\" 0", {0.1, 0.2, 0.3}), marble("\"float variation\" 0", {0.1, 0.2, 0.3}));
    EXPECT_NE(marble("\"float roughness\" .9", {0.1, 0.9, 0.3})[0], marble("", {0.1, 0.9, 0.3})[0]);
}

TEST(TextureBuilder, MappingsArrive) {
    const auto s = [](const std::string& mapping, const TexturePoint& point, const std::string& before = "") {
        return valueOf(
            before + number("bilerp", "\"float v00\" 0 \"float v01\" 0 \"float v10\" 1 \"float v11\" 1 " + mapping),
            point);
    };
    const auto t = [](const std::string& mapping, const TexturePoint& point) {
        return valueOf(number("bilerp", mapping), point);
    };
    const TexturePoint uv = uvAt({0.25f, 0.5f});
    const std::string scaled = "\"string mapping\" \"uv\" \"float uscale\" 2 \"float vscale\" 3 \"float udelta\" .25 "
                               "\"float vdelta\" -.5";
    EXPECT_EQ(s(scaled, uv), 0.75f);
    EXPECT_EQ(t(scaled, uv), 1);
    EXPECT_EQ(s("\"string mapping\" \"spherical\"", pointAt({0, 2, 0})), 0.5f);
    EXPECT_EQ(t("\"string mapping\" \"spherical\"", pointAt({0, 2, 0})), 0.25f);
    EXPECT_EQ(s("\"string mapping\" \"cylindrical\"", pointAt({0, 2, 0.5})), 0.75f);
    EXPECT_EQ(t("\"string mapping\" \"cylindrical\"", pointAt({0, 2, 0.5})), 0.5f);
    EXPECT_EQ(s("\"string mapping\" \"planar\"", pointAt({3, 4, 5})), 3);
    EXPECT_EQ(t("\"string mapping\" \"planar\"", pointAt({3, 4, 5})), 4);
    const std::string planar = "\"string mapping\" \"planar\" \"vector3 v1\" [0 0 1] \"vector3 v2\" [.5 0 0] "
                               "\"float udelta\" 1 \"float vdelta\" 2";
    EXPECT_EQ(s(planar, pointAt({3, 4, 5})), 6);
    EXPECT_EQ(t(planar, pointAt({3, 4, 5})), 3.5f);
    EXPECT_EQ(s("\"string mapping\" \"axis\"", pointAt({3, 4, 5})), 4);
    EXPECT_EQ(t("\"string mapping\" \"axis\"", pointAt({3, 4, 5})), 0.5f);
    EXPECT_EQ(s("\"string mapping\" \"axis\" \"vector3 axis\" [7 0 0] \"float period\" 2 \"float offset\" 1",
                pointAt({3, 4, 5})),
              1);
    EXPECT_EQ(s("\"string mapping\" \"planar\"", pointAt({3, 4, 5}), "Translate 1 0 0\nScale 2 2 2\n"), 1)
        << "in the texture's space";
    EXPECT_EQ(s("\"string mapping\" \"uv\"", uv, "Translate 1 0 0\n"), 0.25f);
}

/// The same RGB is another spectrum as a reflectance, as an index or as light.
TEST(TextureBuilder, SpectraAreWhatTheyAreUsedFor) {
    const Rgb orange(0.8f, 0.4f, 0.1f);
    const RgbColorSpace& srgb = RgbColorSpace::srgb();
    const RgbAlbedoSpectrum albedo(srgb, orange);
    const RgbUnboundedSpectrum unbounded(srgb, orange);
    const RgbIlluminantSpectrum illuminant(srgb, orange);
    const std::string rgb = "[.8 .4 .1]";
    for (const std::string& text :
         {spectrum("constant", "\"rgb value\" " + rgb), spectrum("scale", "\"rgb tex\" " + rgb),
          spectrum("mix", "\"rgb tex1\" " + rgb + " \"rgb tex2\" " + rgb),
          spectrum("directionmix", "\"rgb tex1\" " + rgb + " \"rgb tex2\" " + rgb),
          spectrum("bilerp", "\"rgb v00\" " + rgb + "\"rgb v01\" " + rgb + "\"rgb v10\" " + rgb + "\"rgb v11\" " + rgb),
          spectrum("checkerboard", "\"rgb tex1\" " + rgb + " \"rgb tex2\" " + rgb),
          spectrum("dots", "\"rgb inside\" " + rgb + " \"rgb outside\" " + rgb)}) {
        Textures textures(text);
        expectNear(textures.spectrum("t", SpectrumUse::Albedo), albedo.sample(Textures::lambda()));
        expectNear(textures.spectrum("t", SpectrumUse::Unbounded), unbounded.sample(Textures::lambda()));
        expectNear(textures.spectrum("t", SpectrumUse::Illuminant), illuminant.sample(Textures::lambda()));
    }
}

TEST(TextureBuilder, TexturesReferToTextures) {
    const std::string parts = "Texture \"half\" \"float\" \"constant\" \"float value\" .5\n"
                              "Texture \"red\" \"spectrum\" \"constant\" \"rgb value\" [.8 .1 .1]\n";
    EXPECT_EQ(valueOf(parts + number("mix", "\"texture tex1\" \"half\" \"float tex2\" 2 \"texture amount\" \"half\"")),
              1.25f);
    EXPECT_EQ(valueOf(parts + number("scale", "\"texture tex\" \"half\" \"texture scale\" \"half\"")), 0.25f);
    const SampledSpectrum red = Textures(parts).spectrum("red");
    expectNear(Textures(parts + spectrum("scale", "\"texture tex\" \"red\" \"texture scale\" \"half\"")).spectrum("t"),
               red * 0.5f);
    expectNear(Textures(parts + spectrum("checkerboard", "\"texture tex1\" \"red\"")).spectrum("t"), red);
    expectNear(Textures(parts + spectrum("dots", "\"texture outside\" \"red\"")).spectrum("t"), red);
    expectNear(
        Textures(parts + spectrum("mix", "\"texture tex1\" \"red\" \"spectrum tex2\" [400 1 700 1] \"float amount\" 0"))
            .spectrum("t"),
        red);
}

TEST(TextureBuilder, AMaterialTakesThem) {
    const Scene scene = built("WorldBegin\n" + spectrum("checkerboard", "\"rgb tex1\" [1 0 0]") +
                              "Material \"diffuse\" \"texture reflectance\" \"t\"\nShape \"sphere\"\n"
                              "Material \"diffuse\"\nShape \"sphere\"\n");
    EXPECT_TRUE(scene.world.surfaces[0].filtersTextures());
    EXPECT_FALSE(scene.world.surfaces[1].filtersTextures());
}

TEST(TextureBuilder, WrongTypesAndNamesAreTold) {
    using testing::ElementsAre;
    using testing::IsEmpty;
    EXPECT_THAT(textureErrors(number("chekerboard")),
                ElementsAre("2:21: error: unknown float texture \"chekerboard\""));
    EXPECT_THAT(textureErrors(number("marble")), ElementsAre("2:21: error: unknown float texture \"marble\""));
    EXPECT_THAT(textureErrors(spectrum("fbm")), ElementsAre("2:24: error: unknown spectrum texture \"fbm\""));
    EXPECT_THAT(textureErrors(number("ptex", "\"string filename\" \"x.ptx\"")),
                ElementsAre("2:21: error: float texture \"ptex\" is not yet supported"));
    EXPECT_THAT(textureErrors(spectrum("ptex", "\"string filename\" \"x.ptx\"")),
                ElementsAre("2:24: error: spectrum texture \"ptex\" is not yet supported"));
    EXPECT_THAT(textureErrors(number("checkerboard", "\"string mapping\" \"sphercal\"")),
                ElementsAre("2:53: error: \"mapping\" cannot be \"sphercal\""));
    EXPECT_THAT(textureErrors(number("checkerboard", "\"integer dimension\" 4")),
                ElementsAre("2:56: error: \"dimension\" must be 2 or 3"));
    EXPECT_THAT(textureErrors(number("mix", "\"texture tex1\" \"none\"")),
                ElementsAre("2:27: error: no float texture \"none\""));
    EXPECT_THAT(
        textureErrors("Texture \"red\" \"spectrum\" \"constant\"\n" + number("mix", "\"texture tex1\" \"red\"")),
        ElementsAre("3:27: error: no float texture \"red\""));
    EXPECT_THAT(textureErrors(number("mix", "\"texture tex1\" \"t\"")),
                ElementsAre("2:27: error: texture \"t\" refers to itself"));
    EXPECT_EQ(textureErrors(number("mix", "\"rgb tex1\" [1 1 1]")).size(), 1u);
    EXPECT_EQ(textureErrors(number("bilerp", "\"texture v00\" \"t\"")).size(), 1u) << "constants only, as in pbrt-v4";
    EXPECT_THAT(textureErrors(spectrum("mix", "\"float tex1\" 1")), IsEmpty());
}

TEST(TextureBuilder, ParametersThatPlayNoPartAreRefused) {
    for (const std::string& text :
         {number("constant", "\"string mapping\" \"uv\""), number("scale", "\"float uscale\" 2"),
          number("checkerboard", "\"string mapping\" \"spherical\" \"float uscale\" 2"),
          number("checkerboard", "\"vector3 v1\" [1 0 0]"), number("checkerboard", "\"float period\" 2"),
          number("checkerboard", "\"string mapping\" \"planar\" \"float uscale\" 2"),
          number("checkerboard", "\"integer dimension\" 3 \"string mapping\" \"uv\""),
          number("windy", "\"integer octaves\" 2"), number("fbm", "\"float scale\" 2"),
          spectrum("marble", "\"rgb color\" [1 1 1]")})
        EXPECT_EQ(textureErrors(text).size(), 1u) << text;
}

TEST(TextureBuilder, ValuesThatMakeNoSenseAreRefused) {
    using testing::ElementsAre;
    EXPECT_THAT(textureErrors(number("fbm", "\"integer octaves\" -1")),
                ElementsAre("2:1: error: \"octaves\" is -1, must lie in [0, 100]"));
    EXPECT_THAT(textureErrors(number("checkerboard", "\"string mapping\" \"axis\" \"float period\" 0")),
                ElementsAre("2:1: error: \"period\" must not be 0"));
    EXPECT_THAT(textureErrors(number("checkerboard", "\"string mapping\" \"axis\" \"vector3 axis\" [0 0 0]")),
                ElementsAre("2:1: error: \"axis\" must not be the zero vector"));
    EXPECT_THAT(textureErrors(number("directionmix", "\"vector3 dir\" [0 0 0]")),
                ElementsAre("2:1: error: \"dir\" must not be the zero vector"));
}

TEST(TextureBuilder, SpacesThatMoveAreRefusedWhereTheyCount) {
    const std::string moving = "ActiveTransform EndTime\nTranslate 1 0 0\nActiveTransform All\n";
    for (const std::string& text : {number("fbm"), number("checkerboard", "\"string mapping\" \"planar\""),
                                    number("directionmix"), number("checkerboard", "\"integer dimension\" 3")})
        EXPECT_EQ(textureErrors(moving + text), Lines{"5:1: error: animated transformations are not yet supported"});
    EXPECT_TRUE(textureErrors(moving + number("checkerboard")).empty());
    EXPECT_TRUE(textureErrors(moving + number("constant")).empty());
}

} // namespace
} // namespace vitrine
