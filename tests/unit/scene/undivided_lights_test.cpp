// Which lights lie in the same solids all over.
#include "scene_text.h"

namespace vitrine {
namespace {

/// Of the scene's only light.
bool isUndivided(const std::string& text) {
    const Scene scene = built("Integrator \"sppm\"\nWorldBegin\nShape \"disk\" \"float radius\" 20\n" + text);
    EXPECT_EQ(scene.world.undividedLights.size(), 1u);
    return scene.world.undividedLights.front();
}

const std::string glass = "Material \"dielectric\" \"integer priority\" 1\n";
const std::string lamp =
    "AttributeBegin AreaLightSource \"diffuse\" Shape \"sphere\" \"float radius\" .5 AttributeEnd\n";
const std::string point = "LightSource \"point\"\n", sun = "LightSource \"distant\"\n";

TEST(UndividedLights, LieApartFromAllSolids) {
    EXPECT_TRUE(isUndivided(lamp));
    EXPECT_TRUE(isUndivided(lamp + "Shape \"sphere\" \"float radius\" .6\n")) << "not a solid";
    EXPECT_TRUE(isUndivided(lamp + glass + "Translate 2 0 0 Shape \"sphere\"\n"));
    EXPECT_FALSE(isUndivided(lamp + glass + "Translate 1.4999 0 0 Shape \"sphere\"\n"));
    EXPECT_FALSE(isUndivided(lamp + glass + "Translate .3 0 0 Shape \"sphere\" \"float radius\" 1e-3\n"));
    EXPECT_FALSE(isUndivided(lamp + glass + "Shape \"sphere\" \"float radius\" 3\n")) << "by its box nobody knows";
}

TEST(UndividedLights, MayLieInsideOfAMesh) {
    const std::string tetrahedron = "Shape \"trianglemesh\" \"integer indices\" [0 2 1 0 1 3 1 2 3 2 0 3]\n"
                                    "\"point3 P\" [-9 -9 -9  9 -9 -9  0 9 -9  0 0 9]\n";
    EXPECT_FALSE(isUndivided(lamp + glass + tetrahedron)) << "the box of a slanted face";
    EXPECT_TRUE(
        isUndivided("AttributeBegin Translate 0 0 -8 AreaLightSource \"diffuse\" Shape \"sphere\" \"float radius\" "
                    ".5 AttributeEnd\n" +
                    glass +
                    "Shape \"bilinearmesh\" \"integer indices\" [0 1 2 3 4 5 6 7] \"point3 P\" "
                    "[-9 -9 -9  9 -9 -9  -9 9 -9  9 9 -9  -9 -9 9  9 -9 9  -9 9 9  9 9 9]\n"));
}

TEST(UndividedLights, KnowInstances) {
    const std::string object = "ObjectBegin \"o\"\n" + glass + "Shape \"sphere\"\nObjectEnd\n";
    EXPECT_TRUE(isUndivided(lamp + object)) << "not there";
    EXPECT_TRUE(isUndivided(lamp + object + "Translate 4 0 0 ObjectInstance \"o\"\n"));
    EXPECT_FALSE(isUndivided(lamp + object + "Translate 4 0 0 Scale 4 4 4 ObjectInstance \"o\"\n"));
}

TEST(UndividedLights, ArePointsAndThoseAtInfinity) {
    const std::string ball = glass + "Shape \"sphere\"\n", sea = glass + "Shape \"plane\"\n";
    EXPECT_TRUE(isUndivided(point + ball));
    EXPECT_TRUE(isUndivided(point + sea));
    EXPECT_TRUE(isUndivided(sun + ball));
    EXPECT_FALSE(isUndivided(sun + sea)) << "beams start above and below it";
    EXPECT_FALSE(
        isUndivided("AttributeBegin Translate 0 5 0 AreaLightSource \"diffuse\" Shape \"disk\" AttributeEnd\n" + sea));
}

} // namespace
} // namespace vitrine
