// Shapes, lights, materials and instances: from the text to the world that paths travel through.
#include "scene_text.h"

namespace vitrine {
namespace {

std::vector<std::string> worldErrors(const std::string& text) {
    return errorsOf("WorldBegin\n" + text);
}
Scene world(const std::string& text) {
    return built("WorldBegin\n" + text);
}

TEST(WorldBuilder, SurfacesHaveTheMaterialsOfTheirPlace) {
    const Scene scene = world("Shape \"sphere\"\nMaterial \"dielectric\"\nShape \"sphere\"\n"
                              "AttributeBegin\nMaterial \"interface\"\nShape \"disk\"\nAttributeEnd\nShape \"disk\"\n");
    ASSERT_EQ(scene.world.surfaces.size(), 4u);
    const auto& surfaces = scene.world.surfaces;
    EXPECT_EQ(surfaces[0].material->interior(), nullptr) << "the default is diffuse";
    EXPECT_NE(surfaces[1].material->interior(), nullptr);
    EXPECT_TRUE(surfaces[2].material->isInterface());
    EXPECT_EQ(surfaces[3].material, surfaces[1].material) << "built once";
}

TEST(WorldBuilder, AreaLightsBelongToTheirShapes) {
    const Scene scene =
        world("AttributeBegin\nAreaLightSource \"diffuse\"\nShape \"sphere\"\nShape \"disk\"\nAttributeEnd\n"
              "Shape \"sphere\"\nLightSource \"infinite\"\n");
    ASSERT_EQ(scene.world.surfaces.size(), 3u);
    EXPECT_NE(scene.world.surfaces[0].light, nullptr);
    EXPECT_NE(scene.world.surfaces[1].light, nullptr);
    EXPECT_NE(scene.world.surfaces[0].light, scene.world.surfaces[1].light);
    EXPECT_EQ(scene.world.surfaces[2].light, nullptr);
    EXPECT_EQ(scene.world.infiniteLights.size(), 1u);
}

TEST(WorldBuilder, BoundsHoldInstancesToo) {
    const Scene scene = world("ObjectBegin \"o\"\nShape \"sphere\"\nObjectEnd\nTranslate 10 0 0\nScale 2 2 2\n"
                              "ObjectInstance \"o\"\nTranslate -10 0 0\nObjectInstance \"o\"\n");
    EXPECT_NEAR(scene.world.caster->bounds().max.x, 12, 1e-5);
    EXPECT_NEAR(scene.world.caster->bounds().min.x, -12, 1e-5);
    EXPECT_EQ(scene.instances, 2u);
    EXPECT_EQ(scene.primitives, 1u) << "the definition counts once";
}

TEST(WorldBuilder, AttributesReachTheShapes) {
    const Scene scene = world("Attribute \"shape\" \"float radius\" 3\nShape \"sphere\"\n");
    EXPECT_NEAR(scene.world.caster->bounds().max.y, 3, 1e-5);
}

TEST(WorldBuilder, TheSunIsChosenAlsoWherePlanesAreAllOrMostThereIs) {
    const auto chanceOfSun = [](const std::string& shapes, const std::string& lamp) {
        const Scene scene = built("LookAt 0 3 0  0 0 0  0 0 1\nCamera \"orthographic\"\nWorldBegin\n"
                                  "LightSource \"distant\" \"point3 from\" [0 1 0] \"point3 to\" [0 0 0]\n" +
                                  lamp + shapes);
        const LightSampler& lights = scene.world.lights;
        return lights.probability(lights.lights().front().get());
    };
    const std::string plane = "Shape \"plane\"\n", ball = "Shape \"sphere\" \"float radius\" 1e-4\n";
    const std::string lamp = "LightSource \"point\" \"point3 from\" [0 2 0] \"float scale\" ";
    EXPECT_GT(chanceOfSun(plane, lamp + "1e-3\n"), 0.8);
    EXPECT_GT(chanceOfSun(plane, lamp + "1\n"), 0.1);
    EXPECT_GT(chanceOfSun(plane + ball, lamp + "1\n"), 0.1);
    EXPECT_GT(chanceOfSun(ball, lamp + "1\n"), 0.1);
    EXPECT_GT(chanceOfSun("", lamp + "1\n"), 0.1);
    EXPECT_EQ(chanceOfSun(plane, ""), 1);
}

TEST(WorldBuilder, TellsThatPhotonsFromInfinityCoverAPartOfAPlane) {
    const std::string sun = "LightSource \"distant\"\n", sky = "LightSource \"infinite\"\n",
                      lamp = "LightSource \"point\"\n";
    const std::string plane = "Shape \"plane\"\n", ball = "Shape \"sphere\"\n";
    const auto warnings = [](const std::string& integrator, const std::string& things) {
        return built("Integrator \"" + integrator + "\"\nWorldBegin\n" + things).warnings;
    };
    for (const char* integrator : {"sppm", "ppm", "lightpath"}) {
        for (const std::string& light : {sun, sky}) {
            const auto told = warnings(integrator, light + light + lamp + plane + ball);
            ASSERT_EQ(told.size(), 1u) << integrator;
            EXPECT_TRUE(told[0].message.starts_with("photons of lights at infinity reach surfaces without end only"));
            EXPECT_EQ(told[0].place.line, 1);
            EXPECT_TRUE(warnings(integrator, light + ball).empty()) << "no plane";
        }
        EXPECT_TRUE(warnings(integrator, lamp + plane + ball).empty()) << "no light at infinity";
    }
    EXPECT_TRUE(warnings("path", sun + plane).empty()) << "starts no paths at lights";
}

TEST(WorldBuilder, BeamsFromInfinityFillWhatIsBoundedAndNoMore) {
    const std::string sun = "LightSource \"distant\" \"point3 from\" [0 1 0] \"point3 to\" [0 0 0]\n";
    const Scene scene = built("LookAt 0 900 0  0 0 0  0 0 1\nCamera \"perspective\"\nWorldBegin\n" + sun +
                              "LightSource \"point\" \"point3 from\" [0 1e5 0]\nShape \"sphere\"\n");
    const auto emitted =
        scene.world.lights.lights().front()->emit(V2f(0.99f, 0.3f), V2f(0.5f), SampledWavelengths::visible(0.5f));
    ASSERT_TRUE(emitted);
    EXPECT_LT(maxAbs(emitted->ray.o), 4);
}

TEST(WorldBuilder, WrongShapes) {
    EXPECT_EQ(worldErrors("Shape \"sphere\" \"float radius\" 0"),
              Lines{"2:1: error: \"radius\" is 0, must be positive"});
    EXPECT_EQ(worldErrors("Shape \"plane\" \"float d\" 1 \"point3 p\" [ 0 0 0 ]"),
              Lines{"2:15: error: a plane takes \"d\" or \"p\", not both"});
    EXPECT_EQ(worldErrors("Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 ]"),
              Lines{"2:1: error: a mesh needs vertices: \"point3 P\""});
    EXPECT_FALSE(worldErrors("Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 1 ]").empty());
    EXPECT_EQ(
        worldErrors("Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] \"integer indices\" [ 0 1 -2 ]").size(),
        1u);
    EXPECT_EQ(worldErrors("Shape \"revolution\" \"point2 P\" [ 0 0 1 0 1 1 ] \"integer degree\" 3").size(), 1u);
    EXPECT_EQ(worldErrors("Shape \"revolution\" \"point2 P\" [ 0 0 1 0 1 1 ] \"integer degree\" 0").size(), 1u);
    EXPECT_EQ(worldErrors("Shape \"revolution\" \"point2 P\" [ 0 0 1 0 ] \"float phimax\" -3").size(), 1u);
    EXPECT_EQ(worldErrors("Shape \"cylinder\" \"float zmin\" 1 \"float zmax\" 1").size(), 1u);
    EXPECT_EQ(worldErrors("Shape \"box\" \"point3 pmin\" [ 1 1 1 ] \"point3 pmax\" [ 0 0 0 ]").size(), 1u);
    EXPECT_EQ(worldErrors("Shape \"plane\" \"normal n\" [ 0 0 0 ]").size(), 1u);
}

TEST(WorldBuilder, WrongMaterialsAndLights) {
    EXPECT_EQ(worldErrors("Material \"diffuse\" \"rgb reflectance\" [ 1.5 0 0 ]"),
              Lines{"2:20: error: \"rgb reflectance\" is a reflectance: its values must lie in [0, 1]"});
    EXPECT_EQ(worldErrors("Material \"conductor\" \"rgb reflectance\" [ 1 1 1 ] \"spectrum eta\" \"metal-Au-eta\""),
              Lines{"2:22: error: a conductor takes \"reflectance\" or \"eta\" and \"k\", not both"});
    EXPECT_EQ(worldErrors("Material \"dielectric\" \"float eta\" -1").size(), 1u);
    EXPECT_EQ(worldErrors("Material \"dielectric\" \"float roughness\" -1").size(), 1u);
    EXPECT_EQ(worldErrors("LightSource \"point\" \"rgb I\" [ -1 0 0 ]").size(), 1u);
    EXPECT_EQ(worldErrors("LightSource \"spot\" \"float coneangle\" 300").size(), 1u);
    EXPECT_EQ(worldErrors("LightSource \"infinite\" \"string filename\" \"x.exr\" \"rgb L\" [ 1 1 1 ]"),
              Lines{"2:50: error: an infinite light takes \"L\" or \"filename\", not both"});
    EXPECT_EQ(worldErrors("AreaLightSource \"diffuse\" \"float scale\" nan\nShape \"sphere\"").size(), 1u);
}

TEST(WorldBuilder, WrongAreaLightIsReportedOnceNotOnceAShape) {
    EXPECT_EQ(worldErrors("AreaLightSource \"diffuse\" \"float scal\" 2\nShape \"sphere\"\nShape \"disk\"\n"),
              Lines{"2:27: error: unused parameter \"scal\""});
}

TEST(WorldBuilder, WhatIsNeverUsedIsCheckedToo) {
    EXPECT_EQ(worldErrors("AreaLightSource \"diffus\"").size(), 1u);
    EXPECT_EQ(worldErrors("MakeNamedMaterial \"m\" \"string type\" \"diffus\"").size(), 1u);
    EXPECT_EQ(worldErrors("ObjectBegin \"o\"\nShape \"sphere\" \"float radius\" -1\nObjectEnd").size(), 1u);
}

TEST(WorldBuilder, AShapeWithoutAreaSharesNoPower) {
    // Nothing is divided by the area 0.
    const Scene scene = world("AreaLightSource \"diffuse\" \"float power\" 10\n"
                              "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 2 0 0 ]\n");
    EXPECT_TRUE(scene.world.lights.empty());
}

} // namespace
} // namespace vitrine
