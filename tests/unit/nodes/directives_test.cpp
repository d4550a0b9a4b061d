// Every directive does what pbrt-v4's does to the nodes.
#include "scene_text.h"

#include <gmock/gmock.h>

namespace vitrine {
namespace {

TEST(Directives, DefaultsArePbrts) {
    const SceneNodes scene = world("");
    EXPECT_EQ(scene.camera.type, "perspective");
    EXPECT_EQ(scene.film.type, "rgb");
    EXPECT_EQ(scene.filter.type, "gaussian");
    EXPECT_EQ(scene.sampler.type, "zsobol");
    EXPECT_EQ(scene.integrator.type, "volpath");
    EXPECT_EQ(scene.accelerator.type, "bvh");
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].type, "diffuse");
    EXPECT_TRUE(scene.camera.worldFromCamera->start.isIdentity());
}

TEST(Directives, OptionsBlock) {
    const SceneNodes scene = parseSceneString("Sampler \"stratified\" \"integer xsamples\" 4\n"
                                              "Integrator \"path\" \"integer maxdepth\" [ 7 ]\n"
                                              "PixelFilter \"box\" \"float xradius\" .5\n"
                                              "Film \"rgb\" \"string filename\" \"a.exr\" \"integer xresolution\" 64\n"
                                              "Accelerator \"kdtree\"\n"
                                              "Camera \"orthographic\"\n"
                                              "WorldBegin\n");
    EXPECT_EQ(scene.sampler.type, "stratified");
    EXPECT_EQ(scene.sampler.parameters.getInteger("xsamples", 0), 4);
    EXPECT_EQ(scene.integrator.type, "path");
    EXPECT_EQ(scene.integrator.parameters.getInteger("maxdepth", 0), 7);
    EXPECT_EQ(scene.filter.type, "box");
    EXPECT_EQ(scene.filter.parameters.getFloat("xradius", 0), 0.5);
    EXPECT_EQ(scene.film.parameters.getString("filename", ""), "a.exr");
    EXPECT_EQ(scene.accelerator.type, "kdtree");
    EXPECT_EQ(scene.camera.type, "orthographic");
    EXPECT_EQ(scene.camera.place.toString(), "<string>:6:1");
    EXPECT_EQ(scene.camera.typePlace.toString(), "<string>:6:8");
}

TEST(Directives, OptionHasThePbrtNamesAndTypes) {
    const SceneNodes scene =
        parseSceneString("Option \"disable-pixel_Jitter\" true\nOption \"seed\" -3\n"
                         "Option \"displacementedgescale\" 1.5\nOption \"rendercoordsys\" \"world\"\n"
                         "Option \"mse-reference-image\" \"ref.exr\"\nOption \"seed\" 5\nWorldBegin");
    EXPECT_EQ(std::get<bool>(scene.options.at("disablepixeljitter").value), true);
    EXPECT_EQ(std::get<int>(scene.options.at("seed").value), 5);
    EXPECT_EQ(std::get<double>(scene.options.at("displacementedgescale").value), 1.5);
    EXPECT_EQ(std::get<std::string>(scene.options.at("rendercoordsys").value), "world");
    EXPECT_EQ(std::get<std::string>(scene.options.at("msereferenceimage").value), "ref.exr");
    EXPECT_THAT(errorsOf("Option \"sed\" 1\nWorldBegin"), testing::HasSubstr("did you mean \"seed\"?"));
    EXPECT_THAT(errorsOf("Option \"integer seed\" 1\nWorldBegin"), testing::HasSubstr("did you mean \"seed\"?"));
    EXPECT_THAT(errorsOf("Option \"wavefront\" 1\nWorldBegin"),
                testing::HasSubstr("expected true or false, got \"1\""));
    EXPECT_THAT(errorsOf("Option \"rendercoordsys\" \"wrld\"\nWorldBegin"),
                testing::HasSubstr("did you mean \"world\"?"));
}

TEST(Directives, ShapesTakeTheState) {
    const SceneNodes scene = world("Material \"conductor\"\n"
                                   "AttributeBegin\n"
                                   "  ReverseOrientation\n"
                                   "  AreaLightSource \"diffuse\" \"rgb L\" [ 1 2 3 ]\n"
                                   "  Material \"dielectric\"\n"
                                   "  Translate 1 2 3\n"
                                   "  Shape \"sphere\"\n"
                                   "  Shape \"disk\"\n"
                                   "  AreaLightSource \"\"\n"
                                   "  Shape \"disk\"\n"
                                   "AttributeEnd\n"
                                   "Shape \"cylinder\"\n");
    ASSERT_EQ(scene.shapes.size(), 4u);
    const auto& sphere = scene.shapes[0];
    EXPECT_EQ(sphere.type, "sphere");
    EXPECT_TRUE(sphere.reverseOrientation);
    EXPECT_EQ(scene.materials[std::size_t(sphere.material)].type, "dielectric");
    ASSERT_EQ(sphere.areaLight, 0);
    EXPECT_EQ(scene.areaLights[0].type, "diffuse");
    EXPECT_EQ(sphere.worldFromObject->start.point(V3d(0, 0, 0)), V3d(1, 2, 3));
    EXPECT_EQ(scene.shapes[1].areaLight, 0);
    EXPECT_EQ(scene.shapes[1].worldFromObject, sphere.worldFromObject) << "one transformation for both";
    EXPECT_EQ(scene.shapes[2].areaLight, -1);
    const auto& cylinder = scene.shapes[3];
    EXPECT_FALSE(cylinder.reverseOrientation);
    EXPECT_EQ(scene.materials[std::size_t(cylinder.material)].type, "conductor");
    EXPECT_EQ(cylinder.areaLight, -1);
    EXPECT_TRUE(cylinder.worldFromObject->start.isIdentity());
}

TEST(Directives, NamedMaterialsMayComeAfterTheirUse) {
    const SceneNodes scene = world("NamedMaterial \"gold\"\nShape \"sphere\"\n"
                                   "MakeNamedMaterial \"gold\" \"string type\" \"conductor\" \"float roughness\" .1\n"
                                   "Material \"diffuse\"\nShape \"disk\"");
    const auto& gold = scene.materials[std::size_t(scene.shapes[0].material)];
    EXPECT_EQ(gold.type, "conductor");
    EXPECT_EQ(gold.name, "gold");
    EXPECT_EQ(gold.parameters.getFloat("roughness", 0), 0.1);
    EXPECT_EQ(scene.namedMaterials.at("gold"), scene.shapes[0].material);
    EXPECT_EQ(scene.materials[std::size_t(scene.shapes[1].material)].type, "diffuse");
    EXPECT_THAT(errorsOf("WorldBegin\nMakeNamedMaterial \"a\" \"float roughness\" 1"),
                testing::HasSubstr("MakeNamedMaterial needs a \"string type\""));
    EXPECT_THAT(errorsOf("WorldBegin\nMakeNamedMaterial \"a\" \"float type\" 1"),
                testing::HasSubstr("expected \"string type\", got \"float type\""));
    EXPECT_THAT(errorsOf("WorldBegin\nMakeNamedMaterial \"a\" \"string type\" \"mix\"\n"
                         "MakeNamedMaterial \"a\" \"string type\" \"mix\""),
                testing::HasSubstr("material \"a\" is defined twice"));
}

TEST(Directives, MediaAndTheirInterfaces) {
    const SceneNodes scene = parseSceneString("MediumInterface \"\" \"air\"\nCamera \"perspective\"\n"
                                              "MakeNamedMedium \"air\" \"string type\" \"homogeneous\"\nWorldBegin\n"
                                              "LightSource \"point\"\n"
                                              "MediumInterface \"milk\"\nShape \"sphere\"\n"
                                              "MediumInterface \"milk\" \"\"\nShape \"sphere\"\n"
                                              "Scale 2 2 2\nMakeNamedMedium \"milk\" \"string type\" \"cloud\"\n");
    ASSERT_EQ(scene.media.size(), 2u);
    EXPECT_EQ(scene.media[0].name, "air");
    EXPECT_EQ(scene.media[0].type, "homogeneous");
    EXPECT_EQ(scene.media[1].type, "cloud");
    EXPECT_EQ(scene.media[1].worldFromMedium->start.point(V3d(1)), V3d(2));
    EXPECT_EQ(scene.camera.medium, 0);
    EXPECT_EQ(scene.lights[0].medium, 0);
    EXPECT_EQ(scene.shapes[0].insideMedium, 1);
    EXPECT_EQ(scene.shapes[0].outsideMedium, 1);
    EXPECT_EQ(scene.shapes[1].insideMedium, 1);
    EXPECT_EQ(scene.shapes[1].outsideMedium, -1);
    EXPECT_THAT(
        errorsOf("MediumInterface \"mlik\" \"\"\nMakeNamedMedium \"milk\" \"string type\" \"cloud\"\nWorldBegin"),
        testing::HasSubstr("there is no medium \"mlik\""));
}

TEST(Directives, Textures) {
    const SceneNodes scene =
        world("Texture \"t\" \"float\" \"constant\" \"float value\" .5\n"
              "Translate 1 0 0\nTexture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"a.png\"\n"
              "Material \"diffuse\" \"texture reflectance\" \"t\"\n");
    ASSERT_EQ(scene.floatTextures.size(), 1u);
    ASSERT_EQ(scene.spectrumTextures.size(), 1u);
    EXPECT_EQ(scene.floatTextures[0].name, "t");
    EXPECT_EQ(scene.floatTextures[0].type, "constant");
    EXPECT_EQ(scene.spectrumTextures[0].type, "imagemap");
    EXPECT_EQ(scene.spectrumTextures[0].worldFromTexture->start.point(V3d(0)), V3d(1, 0, 0));
    EXPECT_EQ(scene.materials[1].parameters.findTexture("reflectance"), "t");
    EXPECT_THAT(errorsOf("WorldBegin\nTexture \"t\" \"color\" \"constant\""),
                testing::HasSubstr("pbrt-v4 calls it \"spectrum\""));
    EXPECT_THAT(errorsOf("WorldBegin\nTexture \"t\" \"float\" \"constant\"\nTexture \"t\" \"float\" \"constant\""),
                testing::HasSubstr("float texture \"t\" is defined twice"));
}

TEST(Directives, ObjectsAndInstances) {
    const SceneNodes scene =
        world("Translate 1 0 0\n"
              "ObjectInstance \"pair\"\n"
              "ObjectBegin \"pair\"\n  Translate 0 1 0\n  Shape \"sphere\"\n  Shape \"disk\"\nObjectEnd\n"
              "Translate 0 0 1\nObjectInstance \"pair\"\nShape \"cylinder\"\n");
    ASSERT_EQ(scene.objects.size(), 1u);
    ASSERT_EQ(scene.objects[0].shapes.size(), 2u);
    EXPECT_EQ(scene.objects[0].name, "pair");
    EXPECT_EQ(scene.objects[0].place.line, 4);
    EXPECT_EQ(scene.objects[0].shapes[0].worldFromObject->start.point(V3d(0)), V3d(1, 1, 0));
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.instances[0].object, 0);
    EXPECT_EQ(scene.instances[1].worldFromInstance->start.point(V3d(0)), V3d(1, 0, 1));
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_THAT(errorsOf("WorldBegin\nObjectBegin \"a\"\nObjectBegin \"b\"\nObjectEnd\nObjectEnd"),
                testing::HasSubstr("ObjectBegin inside an object definition"));
    EXPECT_THAT(errorsOf("WorldBegin\nObjectBegin \"a\"\nObjectInstance \"a\"\nObjectEnd"),
                testing::HasSubstr("ObjectInstance inside an object definition"));
    EXPECT_THAT(errorsOf("WorldBegin\nObjectBegin \"a\"\nObjectEnd\nObjectBegin \"a\"\nObjectEnd"),
                testing::HasSubstr("object \"a\" is defined twice"));
    EXPECT_THAT(errorsOf("WorldBegin\nObjectBegin \"a\"\n"), testing::HasSubstr("this ObjectBegin has no ObjectEnd"));
    EXPECT_THAT(errorsOf("WorldBegin\nObjectEnd\n"), testing::HasSubstr("ObjectEnd closes nothing"));
}

TEST(Directives, LightsInObjectsAreWarnedAbout) {
    const SceneNodes scene = world("ObjectBegin \"a\"\nLightSource \"point\"\nLightSource \"point\"\nObjectEnd");
    EXPECT_EQ(scene.lights.size(), 2u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0].severity, Diagnostic::Severity::Warning);
    EXPECT_EQ(scene.warnings[0].place.line, 3);
}

TEST(Directives, AttributeGivesDefaults) {
    const SceneNodes scene =
        world("Attribute \"shape\" \"float radius\" 2 \"float unknown\" 1\n"
              "Attribute \"shape\" \"float radius\" 3\n"
              "Attribute \"light\" \"float scale\" 4\nAttribute \"material\" \"float roughness\" 5\n"
              "Attribute \"texture\" \"float scale\" 6\nAttribute \"medium\" \"float g\" 7\n"
              "Shape \"sphere\"\nShape \"sphere\" \"float radius\" 8\nLightSource \"point\"\n"
              "AreaLightSource \"diffuse\"\nMaterial \"a\"\nTexture \"t\" \"float\" \"scale\"\n"
              "MakeNamedMedium \"m\" \"string type\" \"homogeneous\"\n");
    EXPECT_EQ(scene.shapes[0].parameters.getFloat("radius", 1), 3);
    EXPECT_EQ(scene.shapes[1].parameters.getFloat("radius", 1), 8);
    EXPECT_EQ(scene.lights[0].parameters.getFloat("scale", 1), 4);
    EXPECT_EQ(scene.areaLights[0].parameters.getFloat("scale", 1), 4);
    EXPECT_EQ(scene.materials[1].parameters.getFloat("roughness", 1), 5);
    EXPECT_EQ(scene.floatTextures[0].parameters.getFloat("scale", 1), 6);
    EXPECT_EQ(scene.media[0].parameters.getFloat("g", 1), 7);
    Diagnostics diagnostics;
    scene.shapes[0].parameters.report(diagnostics);
    EXPECT_FALSE(diagnostics.hasErrors()) << "defaults may stay unread";
    EXPECT_THAT(errorsOf("Attribute \"shpae\" \"float radius\" 1\nWorldBegin"),
                testing::HasSubstr("unknown attribute target \"shpae\""));
}

TEST(Directives, AttributesEndWithTheirBlock) {
    const SceneNodes scene =
        world("AttributeBegin\nAttribute \"shape\" \"float radius\" 2\nAttributeEnd\nShape \"sphere\"");
    EXPECT_FALSE(scene.shapes[0].parameters.has("radius"));
}

TEST(Directives, ColorSpaces) {
    const SceneNodes scene = parseSceneString("ColorSpace \"Rec2020\"\nFilm \"rgb\"\nWorldBegin\n"
                                              "LightSource \"point\" \"rgb I\" [ 1 1 1 ]\nAttributeBegin\n"
                                              "ColorSpace \"dci-p3\"\nAttribute \"shape\" \"rgb c\" [ 1 0 0 ]\n"
                                              "ColorSpace \"aces2065-1\"\nShape \"sphere\"\nAttributeEnd\n"
                                              "Shape \"disk\" \"rgb c\" [ 0 1 0 ]\n");
    EXPECT_EQ(scene.film.parameters.colorSpace(), "rec2020");
    EXPECT_EQ(scene.lights[0].parameters.findSpectrum("I")->colorSpace, "rec2020");
    EXPECT_EQ(scene.shapes[0].parameters.colorSpace(), "aces2065-1");
    EXPECT_EQ(scene.shapes[0].parameters.findSpectrum("c")->colorSpace, "dci-p3") << "that of the Attribute directive";
    EXPECT_EQ(scene.shapes[1].parameters.findSpectrum("c")->colorSpace, "rec2020");
    EXPECT_EQ(world("").film.parameters.colorSpace(), "srgb");
    EXPECT_THAT(errorsOf("ColorSpace \"rec202\"\nWorldBegin"), testing::HasSubstr("did you mean \"rec2020\"?"));
}

TEST(Directives, OldTransformBlocksWarnOnce) {
    const SceneNodes scene =
        world("TransformBegin\nTranslate 1 0 0\nTransformEnd\nTransformBegin\nTransformEnd\nShape \"sphere\"");
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0].message, "TransformBegin and TransformEnd are deprecated");
    EXPECT_TRUE(scene.shapes[0].worldFromObject->start.isIdentity());
}

TEST(Directives, ParametersEndAtTheNextDirective) {
    const SceneNodes scene = world("Shape \"sphere\"\"float radius\"[2]Shape\"disk\"");
    ASSERT_EQ(scene.shapes.size(), 2u);
    EXPECT_EQ(scene.shapes[0].parameters.getFloat("radius", 0), 2);
}

TEST(Directives, UnknownTypeNamesTheNearestOrTheNewName) {
    const SceneNodes scene = world("Shape \"sphear\"\nMaterial \"glass\"\nMaterial \"zzz\"");
    const std::vector<std::string> shapes = {"sphere", "disk"}, materials = {"diffuse", "dielectric"};
    EXPECT_STREQ(unknownType(scene.shapes[0], "shape", shapes).what(),
                 "scene.pbrt:2:7: error: unknown shape \"sphear\"\n"
                 "    Shape \"sphear\"\n"
                 "          ^^^^^^^^\n"
                 "    did you mean \"sphere\"?");
    EXPECT_THAT(unknownType(scene.materials[1], "material", materials).what(),
                testing::HasSubstr("pbrt-v4 calls it \"dielectric\""));
    EXPECT_EQ(unknownType(scene.materials[2], "material", materials).diagnostics()[0].hint, "");
}

} // namespace
} // namespace vitrine
