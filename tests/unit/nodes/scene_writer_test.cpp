// Scenes that are written read back as the same nodes.
#include "nodes/parser.h"
#include "nodes/scene_writer.h"
#include "scene_text.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

void expectSame(const ParameterList& a, const ParameterList& b, const std::string& where) {
    ASSERT_EQ(a.size(), b.size()) << where;
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i]->name, b[i]->name) << where;
        EXPECT_EQ(a[i]->type, b[i]->type) << where << a[i]->name;
        EXPECT_EQ(a[i]->values, b[i]->values) << where << a[i]->name;
        EXPECT_EQ(a[i]->colorSpace, b[i]->colorSpace) << where << a[i]->name;
    }
}

/// \param skipped a parameter that may have come or gone: "type" of a named material
void expectSame(const Node& a, const Node& b, const std::string& where, std::string_view skipped = {}) {
    const auto without = [&](const Node& node) {
        ParameterList own = node.parameters.own();
        std::erase_if(own, [&](const ParameterPtr& p) { return p->name == skipped; });
        return own;
    };
    EXPECT_EQ(a.type, b.type) << where;
    EXPECT_EQ(a.parameters.colorSpace(), b.parameters.colorSpace()) << where;
    expectSame(without(a), without(b), where);
    expectSame(a.parameters.defaults(), b.parameters.defaults(), where + " (Attribute)");
}

void expectSame(const MovingTransformPtr& a, const MovingTransformPtr& b, const std::string& where) {
    EXPECT_EQ(a->start.matrix(), b->start.matrix()) << where;
}

std::string mediumName(const SceneNodes& scene, int medium) {
    return medium < 0 ? "" : scene.media[std::size_t(medium)].name;
}

void expectSame(const SceneNodes& a, const SceneNodes& b, const std::vector<ShapeNode>& as,
                const std::vector<ShapeNode>& bs) {
    ASSERT_EQ(as.size(), bs.size());
    for (std::size_t i = 0; i < as.size(); ++i) {
        const std::string where = "shape " + std::to_string(i);
        expectSame(as[i], bs[i], where);
        expectSame(as[i].worldFromObject, bs[i].worldFromObject, where);
        EXPECT_EQ(as[i].reverseOrientation, bs[i].reverseOrientation) << where;
        expectSame(a.materials[std::size_t(as[i].material)], b.materials[std::size_t(bs[i].material)],
                   "material of " + where, "type");
        EXPECT_EQ(mediumName(a, as[i].insideMedium), mediumName(b, bs[i].insideMedium)) << where;
        EXPECT_EQ(mediumName(a, as[i].outsideMedium), mediumName(b, bs[i].outsideMedium)) << where;
        ASSERT_EQ(as[i].areaLight < 0, bs[i].areaLight < 0) << where;
        if (as[i].areaLight >= 0)
            expectSame(a.areaLights[std::size_t(as[i].areaLight)], b.areaLights[std::size_t(bs[i].areaLight)],
                       "area light of " + where);
    }
}

void expectSame(const SceneNodes& a, const SceneNodes& b) {
    expectSame(a.film, b.film, "film");
    expectSame(a.filter, b.filter, "filter");
    expectSame(a.sampler, b.sampler, "sampler");
    expectSame(a.integrator, b.integrator, "integrator");
    expectSame(a.camera, b.camera, "camera");
    // The camera's matrix is inverted twice on the way.
    EXPECT_TRUE(
        a.camera.worldFromCamera->start.matrix().equalWithAbsError(b.camera.worldFromCamera->start.matrix(), 1e-12));
    EXPECT_EQ(mediumName(a, a.camera.medium), mediumName(b, b.camera.medium));
    ASSERT_EQ(a.options.size(), b.options.size());
    for (const auto& [name, option] : a.options)
        EXPECT_EQ(option.value, b.options.at(name).value) << name;
    expectSame(a, b, a.shapes, b.shapes);
    ASSERT_EQ(a.objects.size(), b.objects.size());
    for (std::size_t i = 0; i < a.objects.size(); ++i) {
        EXPECT_EQ(a.objects[i].name, b.objects[i].name);
        expectSame(a, b, a.objects[i].shapes, b.objects[i].shapes);
    }
    ASSERT_EQ(a.instances.size(), b.instances.size());
    for (std::size_t i = 0; i < a.instances.size(); ++i) {
        EXPECT_EQ(a.instances[i].object, b.instances[i].object);
        expectSame(a.instances[i].worldFromInstance, b.instances[i].worldFromInstance, "instance");
    }
    ASSERT_EQ(a.lights.size(), b.lights.size());
    for (std::size_t i = 0; i < a.lights.size(); ++i) {
        expectSame(a.lights[i], b.lights[i], "light");
        expectSame(a.lights[i].worldFromLight, b.lights[i].worldFromLight, "light");
        EXPECT_EQ(mediumName(a, a.lights[i].medium), mediumName(b, b.lights[i].medium));
    }
    ASSERT_EQ(a.floatTextures.size(), b.floatTextures.size());
    for (std::size_t i = 0; i < a.floatTextures.size(); ++i) {
        EXPECT_EQ(a.floatTextures[i].name, b.floatTextures[i].name);
        expectSame(a.floatTextures[i], b.floatTextures[i], "float texture");
        expectSame(a.floatTextures[i].worldFromTexture, b.floatTextures[i].worldFromTexture, "float texture");
    }
    ASSERT_EQ(a.spectrumTextures.size(), b.spectrumTextures.size());
    ASSERT_EQ(a.media.size(), b.media.size());
    ASSERT_EQ(a.namedMaterials.size() <= b.namedMaterials.size(), true);
    for (const auto& [name, index] : a.namedMaterials)
        expectSame(a.materials[std::size_t(index)], b.materials[std::size_t(b.namedMaterials.at(name))], name, "type");
}

SceneNodes writtenAndRead(const SceneNodes& scene) {
    return parseSceneString(writeScene(scene, {"a comment"}), "written.pbrt");
}

constexpr const char* everything = R"(
Option "seed" 7
Option "msereferenceimage" "a \"quoted\" name\\.exr"
Option "disablepixeljitter" true
ColorSpace "rec2020"
Film "rgb" "integer xresolution" 33 "string filename" "out\\put.exr"
PixelFilter "box" "float xradius" .7
Sampler "stratified" "integer xsamples" 3 "bool jitter" false
Integrator "path" "integer maxdepth" 9
Accelerator "bvh"
ColorSpace "srgb"
MakeNamedMedium "air" "string type" "homogeneous" "rgb sigma_a" [ .1 .2 .3 ]
MediumInterface "" "air"
Scale -1 1 1
LookAt 1 2 3  0 .1 .2  0 1 0
Camera "perspective" "float fov" 31.25
MediumInterface "" ""
WorldBegin
Texture "t1" "float" "constant" "float value" .123456789012345
Translate 1 2 3
Texture "t2" "spectrum" "imagemap" "string filename" "x.png"
MakeNamedMedium "fog" "string type" "homogeneous" "spectrum sigma_s" [ 400 1 700 2 ]
MakeNamedMaterial "material-1" "string type" "diffuse" "rgb reflectance" [ 1 0 .5 ]
Attribute "shape" "float radius" 2.5 "float alpha" 1
Attribute "light" "float scale" 3
ColorSpace "aces2065-1"
Attribute "material" "rgb reflectance" [ .1 .1 .1 ]
LightSource "point" "rgb I" [ 1 2 3 ] "point3 from" [ 0 1 0 ]
ColorSpace "dci-p3"
Material "diffuse" "rgb reflectance" [ .3 .2 .1 ]
AttributeBegin
  Rotate 33 1 2 3
  ReverseOrientation
  MediumInterface "fog" "air"
  AreaLightSource "diffuse" "blackbody L" 4000
  Shape "sphere" "float radius" 1e-7
AttributeEnd
Attribute "shape" "float radius" 3.5
NamedMaterial "material-1"
ObjectBegin "thing \"one\""
  Translate 0 5 0
  Shape "disk"
  Shape "trianglemesh" "integer indices" [ 0 1 2 ] "point3 P" [ 0 0 0 1 0 0 .1 .33333333333333331 1e30 ]
ObjectEnd
ConcatTransform [ 1 .1 0 0  0 1 .2 0  0 0 1 0  7 8 9 1 ]
ObjectInstance "thing \"one\""
Material "interface"
Shape "cylinder"
)";

TEST(SceneWriter, EverythingReadsBackTheSame) {
    const SceneNodes scene = parseSceneString(everything, "scene.pbrt");
    expectSame(scene, writtenAndRead(scene));
}

TEST(SceneWriter, WritingAgainChangesNothing) {
    const SceneNodes once = writtenAndRead(parseSceneString(everything, "scene.pbrt"));
    const std::string text = writeScene(once);
    EXPECT_EQ(writeScene(parseSceneString(text, "again.pbrt")), text);
}

TEST(SceneWriter, InlineMaterialsTakeNamesThatAreFree) {
    const std::string text = writeScene(parseSceneString(everything, "scene.pbrt"));
    EXPECT_NE(text.find("MakeNamedMaterial \"material-1\"\n"), std::string::npos);
    EXPECT_NE(text.find("MakeNamedMaterial \"material-2\" \"string type\""), std::string::npos);
    const std::string clash = writeScene(world("MakeNamedMaterial \"material-2\" \"string type\" \"diffuse\"\n"
                                               "Material \"conductor\"\nShape \"sphere\"\n"
                                               "NamedMaterial \"material-2\"\nShape \"sphere\"\n"));
    EXPECT_NE(clash.find("MakeNamedMaterial \"material-2'\" \"string type\" \"conductor\""), std::string::npos)
        << clash;
}

TEST(SceneWriter, IncludesAreWrittenOut) {
    const ScratchDirectory folder;
    folder.write("part.pbrt", "Shape \"sphere\" \"float radius\" 2\n");
    const SceneNodes scene = parseSceneFile(folder.write("scene.pbrt", "WorldBegin\nInclude \"part.pbrt\"\n"));
    EXPECT_EQ(writtenAndRead(scene).shapes.size(), 1u);
}

TEST(SceneWriter, MotionIsRefused) {
    EXPECT_THROW(writeScene(world("ActiveTransform EndTime\nTranslate 1 0 0\nShape \"sphere\"\n")), SceneError);
}

} // namespace
} // namespace vitrine
