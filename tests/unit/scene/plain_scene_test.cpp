// What pbrt-v4 has not, said as it can say it.
#include "core/random.h"
#include "film/imageio.h"
#include "nodes/parser.h"
#include "nodes/scene_writer.h"
#include "scene/plain_scene.h"
#include "scene/rewritten.h"
#include "scene/world_builder.h"
#include "scene_text.h"
#include "shapes/ply_writer.h"
#include "shapes/revolution/revolution.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace vitrine {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Plain : public testing::Test {
  protected:
    PlainScene plain(const std::string& text, const MeshOptions& options = {}) const {
        std::ofstream(folder_.file("scene.pbrt")) << text;
        return makePlainScene(folder_.file("scene.pbrt"), options);
    }
    PlainScene world(const std::string& text) const { return plain("WorldBegin\n" + text); }

    static std::vector<std::string> warnings(const PlainScene& scene) {
        std::vector<std::string> messages;
        for (const auto& warning : scene.warnings)
            messages.push_back(warning.message);
        return messages;
    }
    /// The meshed scene, read by our own reader and built.
    Scene readBack(const PlainScene& scene) const {
        std::filesystem::create_directories(folder_.file("out/meshes"));
        for (const auto& mesh : scene.meshes)
            writePly(folder_.file("out/" + mesh.fileName), mesh.make());
        return loadSceneString(writeScene(scene.nodes), "plain.pbrt", {}, folder_.file("out"));
    }
    static std::optional<CasterHit> cast(const Scene& scene, const V3d& o, const V3d& d) {
        CasterHit hit;
        return scene.world.caster->intersect(Ray{o, d, infinityD}, hit) ? std::optional(hit) : std::nullopt;
    }

    test::TemporaryFolder folder_;
};

constexpr const char* bowl = "Shape \"revolution\" \"integer degree\" 1 \"point2 P\" [ 0 0  1 0  1 1  0 1 ]\n";

TEST_F(Plain, RevolutionsOfOneProfileShareAMesh) {
    const std::string half = "Shape \"revolution\" \"integer degree\" 1 \"float phimax\" 180 "
                             "\"point2 P\" [ 0 0  1 0  1 1  0 1 ]\n";
    const PlainScene scene = world(bowl + std::string("Translate 5 0 0\n") + bowl + half);
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[0].make().triangles.size(), 3 * scene.meshes[0].triangles);
    ASSERT_EQ(scene.nodes.shapes.size(), 3u);
    std::vector<std::string> files;
    for (const auto& shape : scene.nodes.shapes) {
        EXPECT_EQ(shape.type, "plymesh");
        files.push_back(shape.parameters.getString("filename", ""));
    }
    EXPECT_THAT(files, ElementsAre("meshes/revolution-1.ply", "meshes/revolution-1.ply", "meshes/revolution-2.ply"));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(Plain, ToleranceIsOfTheShapesSize) {
    MeshOptions options;
    options.tolerance = 1e-3;
    EXPECT_DOUBLE_EQ(plain("WorldBegin\n" + std::string(bowl), options).meshes[0].tolerance, 2e-3);
    options.triangles = 5000;
    const PlainScene counted = plain("WorldBegin\n" + std::string(bowl), options);
    EXPECT_LE(counted.meshes[0].triangles, 5000u);
    EXPECT_GE(counted.meshes[0].triangles, 2500u);
}

TEST_F(Plain, TextureCoordinatesFollowTheShape) {
    const PlainScene scene = world("Shape \"revolution\" \"string vmap\" \"arclength\" "
                                   "\"point2 P\" [ 1 0  1 .1  1 .2  1 4 ]\n");
    const Revolution& exact = *scene.meshes[0].shape;
    const MeshInput mesh = scene.meshes[0].make();
    for (std::size_t i = 0; i < mesh.p.size(); ++i)
        EXPECT_NEAR(mesh.uv[i].y, mesh.p[i].y / 4, 1e-5); // a straight wall: its length is its height
    EXPECT_NE(exact.textureV(0.5), 0.5);
}

/// Directions in which normals point, seen from outside, must not change: exact and written scenes are asked by rays.
TEST_F(Plain, NormalsStayHoweverShapesArePlaced) {
    const std::string shapes[] = {bowl, "Shape \"box\" \"point3 pmin\" [ -.5 0 -1 ] \"point3 pmax\" [ 2 1 1 ]\n",
                                  "Shape \"plane\" \"normal n\" [ 0 2 1 ] \"float d\" 3\n"};
    for (const std::string& shape : shapes)
        for (const std::string placed :
             {"", "Scale -1 1 1\n", "ReverseOrientation\n", "Scale 1 1 -2\nReverseOrientation\nRotate 20 1 2 3\n"}) {
            const std::string text = "WorldBegin\n" + placed + shape;
            const Scene exact = built(text), written = readBack(plain(text));
            int compared = 0;
            RandomStream random(streamKey(5));
            for (int i = 0; i < 60; ++i) {
                const auto point = [&] {
                    return V3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
                };
                const V3d o = point() * 4, d = point() * 0.7 - o;
                const auto a = cast(exact, o, d), b = cast(written, o, d);
                if (!a || !b) continue;
                const SurfacePoint& p = a->point;
                const SurfacePoint& q = b->point;
                if ((p.p - q.p).length() > 1e-3) continue; // past an edge that the mesh has cut
                ++compared;
                EXPECT_GT(p.ng.dot(q.ng), 0.9) << text;
                EXPECT_GT(p.ns.dot(q.ns), 0.99) << text;
                if (shape.find("plane") == std::string::npos) {
                    EXPECT_NEAR(p.uv.y, q.uv.y, 0.01) << text;
                }
                if (shape.find("box") != std::string::npos) {
                    EXPECT_NEAR(p.uv.x, q.uv.x, 1e-4) << text;
                }
            }
            EXPECT_GT(compared, 10) << text;
        }
}

TEST_F(Plain, BoxesAreClosedMeshes) {
    const PlainScene scene = world("Shape \"box\" \"point3 pmax\" [ 2 3 4 ]\n");
    ASSERT_EQ(scene.nodes.shapes[0].type, "trianglemesh");
    Diagnostics diagnostics;
    BuildContext context(scene.nodes, diagnostics);
    const auto shapes = buildShape(context, scene.nodes.shapes[0]);
    diagnostics.throwIfErrors();
    ASSERT_EQ(shapes.size(), 1u);
    EXPECT_TRUE(shapes[0]->isClosed());
    EXPECT_NEAR(shapes[0]->area(), 2 * (3 * 4 + 3 * 5 + 4 * 5), 1e-4);
}

TEST_F(Plain, PlanesBecomeDisksThatReachBeyondEverything) {
    const PlainScene scene = plain("LookAt 0 2 30  0 0 0  0 1 0\nCamera \"perspective\"\nWorldBegin\n"
                                   "Shape \"sphere\"\nShape \"plane\" \"point3 p\" [ 0 -1 0 ]\n");
    EXPECT_THAT(warnings(scene), ElementsAre(HasSubstr("no infinite plane")));
    const ShapeNode& disk = scene.nodes.shapes[1];
    EXPECT_EQ(disk.type, "disk");
    const double radius = disk.parameters.getFloat("radius", 0);
    EXPECT_GT(radius, 1e5);
    EXPECT_LT(radius, 1e6);
    EXPECT_NEAR(disk.worldFromObject->start.point(V3d(0, 0, 0)).y, -1, 1e-12);
}

TEST_F(Plain, AbsorptionIsAMediumThatDoesNotScatter) {
    const PlainScene scene = plain("Integrator \"path\" \"integer maxdepth\" 7 \"integer rrdepth\" 3\nWorldBegin\n"
                                   "Material \"dielectric\" \"float absorption\" .25 \"integer priority\" 2\n"
                                   "Shape \"sphere\"\nTranslate 5 0 0\n"
                                   "MakeNamedMaterial \"g\" \"string type\" \"dielectric\" "
                                   "\"rgb absorption\" [ 1 0 2 ]\nNamedMaterial \"g\"\nShape \"sphere\"\n");
    EXPECT_THAT(warnings(scene),
                ElementsAre(HasSubstr("no \"priority\" of nested dielectrics"), HasSubstr("no parameter \"rrdepth\"")));
    EXPECT_EQ(scene.nodes.integrator.type, "volpath");
    EXPECT_THAT(scene.nodes.integrator.parameters.names(), ElementsAre("maxdepth"));
    ASSERT_EQ(scene.nodes.media.size(), 2u);
    const std::string text = writeScene(scene.nodes);
    EXPECT_THAT(text, HasSubstr("\"spectrum sigma_a\" [ 360 0.25 830 0.25 ]"));
    EXPECT_THAT(text, HasSubstr("\"rgb sigma_a\" [ 1 0 2 ]"));
    EXPECT_THAT(text, HasSubstr("\"spectrum sigma_s\" [ 360 0 830 0 ]"));
    EXPECT_THAT(text, HasSubstr("MediumInterface \"absorption-g\" \"\""));
    EXPECT_EQ(text.find("priority"), std::string::npos);
    EXPECT_EQ(text.find("\"float absorption\""), std::string::npos);
}

TEST_F(Plain, SolidsInAbsorbingSolidsAreWarnedOf) {
    const std::string glass = "Material \"dielectric\" \"rgb absorption\" [ 1 0 2 ]\nShape \"sphere\"\n";
    const std::string other = "Material \"dielectric\"\nShape \"sphere\" \"float radius\" .5\n";
    EXPECT_THAT(warnings(world(glass + other)), ElementsAre(HasSubstr("in another one that absorbs")));
    EXPECT_TRUE(world(glass + "Translate 3 0 0\n" + other).warnings.empty());
}

TEST_F(Plain, IntegratorsOfOursAreReplacedAloud) {
    const PlainScene nee = plain("Integrator \"path\" \"bool nee\" false\nWorldBegin\n");
    EXPECT_THAT(warnings(nee), ElementsAre(HasSubstr("no parameter \"nee\"")));
    EXPECT_EQ(nee.nodes.integrator.type, "path");
    const std::string lit = "WorldBegin\nLightSource \"infinite\"\nShape \"disk\"\n"; // photons need it
    const PlainScene ppm = plain("Integrator \"ppm\" \"integer maxdepth\" 6 \"float radius\" .1\n" + lit);
    EXPECT_THAT(warnings(ppm), ElementsAre(HasSubstr("no integrator \"ppm\": written as \"path\""),
                                           HasSubstr("no parameter \"radius\"")));
    EXPECT_THAT(ppm.nodes.integrator.parameters.names(), ElementsAre("maxdepth"));
    const PlainScene sppm = plain("Integrator \"sppm\" \"float radius\" .1 \"string radiusrule\" \"shared\"\n" + lit);
    EXPECT_THAT(warnings(sppm), ElementsAre(HasSubstr("no parameter \"radiusrule\"")));
    EXPECT_EQ(sppm.nodes.integrator.type, "sppm");
    const PlainScene filled = plain("Integrator \"sppm\"\n" + lit +
                                    "Material \"dielectric\" \"float absorption\" 1\n"
                                    "Shape \"sphere\"\n");
    EXPECT_THAT(warnings(filled), ElementsAre(HasSubstr("\"sppm\" follows no light through media")));
    EXPECT_EQ(filled.nodes.integrator.type, "volpath");
    // pbrt-v4's "path" lets surfaces without a material block light.
    EXPECT_EQ(plain("Integrator \"path\"\nWorldBegin\nMaterial \"none\"\nShape \"sphere\"\n").nodes.integrator.type,
              "volpath");
}

TEST_F(Plain, PowerOfMeshesIsNotMultipliedByTheirFaces) {
    const std::string light = "AreaLightSource \"diffuse\" \"float power\" 100 \"float scale\" 2\n";
    const PlainScene scene = world(light + "Shape \"box\"\nShape \"sphere\"\n");
    ASSERT_GE(scene.nodes.shapes[0].areaLight, 0);
    const Node& box = scene.nodes.areaLights[std::size_t(scene.nodes.shapes[0].areaLight)];
    EXPECT_FALSE(box.parameters.has("power"));
    EXPECT_NEAR(box.parameters.getFloat("scale", 0), 2 * 100 / (piD * 24), 1e-9);
    const Node& sphere = scene.nodes.areaLights[std::size_t(scene.nodes.shapes[1].areaLight)];
    EXPECT_EQ(sphere.parameters.getFloat("power", 0), 100);
}

TEST_F(Plain, FilesAreCopiedOnceUnderNamesOfTheirOwn) {
    std::filesystem::create_directories(folder_.file("a"));
    std::filesystem::create_directories(folder_.file("b"));
    const std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                            "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                            "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    for (const char* name : {"a/m.ply", "b/m.ply"})
        std::ofstream(folder_.file(name)) << ply;
    std::ofstream(folder_.file("eta.spd")) << "400 1.5\n700 1.4\n";
    const PlainScene scene = world("Material \"dielectric\" \"spectrum eta\" \"eta.spd\"\n"
                                   "Shape \"plymesh\" \"string filename\" \"a/m.ply\"\n"
                                   "Shape \"plymesh\" \"string filename\" \"b/m.ply\"\n"
                                   "Shape \"plymesh\" \"string filename\" \"a/m.ply\"\n"
                                   "Material \"dielectric\" \"spectrum eta\" \"glass-BK7\"\nShape \"sphere\"\n");
    std::vector<std::string> to;
    for (const auto& copy : scene.copies)
        to.push_back(copy.to);
    EXPECT_THAT(to, ElementsAre("resources/m.ply", "resources/2-m.ply", "resources/eta.spd"));
    EXPECT_EQ(scene.nodes.shapes[2].parameters.getString("filename", ""), "resources/m.ply");
    EXPECT_THAT(writeScene(scene.nodes), HasSubstr("\"spectrum eta\" [ \"glass-BK7\" ]"));
}

TEST_F(Plain, OnlyRevolutionsOnRequest) {
    MeshOptions options;
    options.onlyRevolutions = true;
    const PlainScene scene = plain("Integrator \"path\" \"integer rrdepth\" 3\nWorldBegin\n"
                                   "Material \"dielectric\" \"rgb absorption\" [ 1 0 2 ] \"integer priority\" 2\n"
                                   "Shape \"box\"\nShape \"plane\"\n" +
                                       std::string(bowl),
                                   options);
    EXPECT_TRUE(scene.warnings.empty());
    const Scene back = readBack(scene);
    EXPECT_EQ(back.shapeTypes, (std::map<std::string, int>{{"box", 1}, {"plane", 1}, {"plymesh", 1}}));
    EXPECT_EQ(scene.nodes.integrator.parameters.getInteger("rrdepth", 0), 3);
}

TEST_F(Plain, WhatCannotBeSaidIsRefusedWithItsPlace) {
    MeshOptions options;
    options.tolerance = 1e-9;
    try {
        plain("WorldBegin\n" + std::string(bowl), options);
        FAIL();
    } catch (const SceneError& e) {
        EXPECT_THAT(e.what(), HasSubstr("scene.pbrt:2:1: error: the tolerance 1e-09 is finer than"));
    }
    writeImage(folder_.file("sky.pfm"), Image{4, 2, 3, std::vector<float>(24, 0.5f)});
    try {
        world("LightSource \"infinite\" \"string filename\" \"sky.pfm\"\n");
        FAIL();
    } catch (const SceneError& e) {
        EXPECT_THAT(e.what(), HasSubstr("imgtool makeequiarea"));
    }
}

} // namespace
} // namespace vitrine
