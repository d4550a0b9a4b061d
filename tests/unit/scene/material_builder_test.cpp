// Materials of scene texts: parameters of the layered ones, mixes by name, and what is wrong with them.
#include "scene_text.h"

namespace vitrine {
namespace {

std::vector<std::string> worldErrors(const std::string& text) {
    return errorsOf("WorldBegin\n" + text);
}
const std::string named = "MakeNamedMaterial \"a\" \"string type\" \"diffuse\"\n"
                          "MakeNamedMaterial \"b\" \"string type\" \"dielectric\" \"float eta\" 1.4\n";

TEST(MaterialBuilder, ReadsAllParametersOfTheCoatedOnes) {
    EXPECT_EQ(worldErrors("Texture \"t\" \"float\" \"constant\"\nTexture \"s\" \"spectrum\" \"constant\"\n"
                          "Material \"coateddiffuse\" \"texture reflectance\" \"s\" \"float eta\" 1.4 "
                          "\"texture roughness\" \"t\" \"float uroughness\" .1 \"float vroughness\" .2 "
                          "\"bool remaproughness\" false \"texture thickness\" \"t\" \"texture albedo\" \"s\" "
                          "\"texture g\" \"t\" \"integer maxdepth\" 3 \"integer nsamples\" 2\n"
                          "Material \"coatedconductor\" \"spectrum interface.eta\" \"glass-BK7\" "
                          "\"float interface.roughness\" .1 \"float interface.uroughness\" .1 "
                          "\"float interface.vroughness\" .2 \"float thickness\" .1 "
                          "\"spectrum conductor.eta\" \"metal-Au-eta\" \"spectrum conductor.k\" \"metal-Au-k\" "
                          "\"float conductor.roughness\" .1 \"float conductor.uroughness\" .1 "
                          "\"float conductor.vroughness\" .2 \"rgb albedo\" [0 .1 .2] \"float g\" -.3 "
                          "\"integer maxdepth\" 3 \"integer nsamples\" 2 \"bool remaproughness\" true\n"
                          "Material \"coatedconductor\" \"rgb reflectance\" [.1 .2 .3]\n"
                          "Material \"diffusetransmission\" \"rgb reflectance\" [.1 .2 .3] "
                          "\"texture transmittance\" \"s\" \"float scale\" 2\n"),
              Lines{});
}

TEST(MaterialBuilder, RefusesByName) {
    EXPECT_EQ(
        worldErrors("Material \"coatedconductor\" \"rgb reflectance\" [1 1 1] "
                    "\"spectrum conductor.eta\" \"metal-Au-eta\""),
        Lines{"2:28: error: a conductor takes \"reflectance\" or \"conductor.eta\" and \"conductor.k\", not both"});
    EXPECT_EQ(worldErrors("Material \"coateddiffuse\" \"float thickness\" -1"),
              Lines{"2:1: error: \"thickness\" is -1, but must be 0 or more and finite"});
    EXPECT_EQ(worldErrors("Material \"coatedconductor\" \"float roughness\" .1"),
              Lines{"2:28: error: unused parameter \"roughness\""});
    for (const char* later : {"hair", "measured", "subsurface"})
        EXPECT_EQ(worldErrors(std::string("Material \"") + later + "\""),
                  Lines{std::string("2:10: error: material \"") + later + "\" is not yet supported"});
}

TEST(MaterialBuilder, MixesMaterialsByNameAlsoOfLaterOnes) {
    EXPECT_EQ(worldErrors("Material \"mix\" \"string materials\" [\"a\" \"m\"] \"float amount\" .2\n"
                          "MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string materials\" [\"a\" \"b\"]\n" +
                          named),
              Lines{});
    const Scene scene =
        built("WorldBegin\n" + named +
              "Material \"mix\" \"string materials\" [\"a\" \"b\"] \"float amount\" 1\nShape \"sphere\"\n");
    EXPECT_NE(scene.world.surfaces.at(0).interior(), nullptr) << "painted glass bounds a solid";
}

TEST(MaterialBuilder, WrongMixes) {
    EXPECT_EQ(worldErrors(named + "Material \"mix\" \"string materials\" [\"a\" \"bb\"]"),
              Lines{"4:40: error: no material \"bb\""});
    EXPECT_EQ(worldErrors(named + "Material \"mix\" \"string materials\" [\"a\"]"),
              Lines{"4:16: error: a mix takes the names of two materials: \"string materials\""});
    EXPECT_EQ(worldErrors("Material \"mix\"").size(), 1u);
    EXPECT_EQ(worldErrors("MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string materials\" [\"m\" \"m\"]").size(),
              2u);
    EXPECT_EQ(worldErrors("MakeNamedMaterial \"i\" \"string type\" \"interface\"\n"
                          "Material \"mix\" \"string materials\" [\"i\" \"i\"]"),
              Lines{"3:1: error: an \"interface\" material cannot be part of a mix"});
    EXPECT_EQ(worldErrors(named + "MakeNamedMaterial \"c\" \"string type\" \"dielectric\"\n"
                                  "Material \"mix\" \"string materials\" [\"c\" \"b\"]"),
              Lines{"5:1: error: the two materials of a mix bound different solids: their \"eta\", \"absorption\" and "
                    "\"priority\" must be the same"});
    // Said once, not again for the mix.
    EXPECT_EQ(worldErrors("MakeNamedMaterial \"a\" \"string type\" \"diffuse\" \"float x\" 1\n"
                          "Material \"mix\" \"string materials\" [\"a\" \"a\"]")
                  .size(),
              1u);
}

} // namespace
} // namespace vitrine
