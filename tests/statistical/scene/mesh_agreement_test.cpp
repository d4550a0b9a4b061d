// A scene with turned glass, and the same written by `vitrine mesh`: their pictures agree.
#include "nodes/scene_writer.h"
#include "render_text.h"
#include "scene/plain_scene.h"
#include "shapes/ply_writer.h"
#include "support/long_run.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace vitrine {
namespace {

/// A goblet of glass between a sphere that shines and a table: caustics, of light that is large enough to find.
constexpr const char* goblet = R"(
LookAt .3 1.25 3.6  .12 .58 0  0 1 0
Camera "perspective" "float fov" 30
Film "rgb" "integer xresolution" 16 "integer yresolution" 16
PixelFilter "box"
Integrator "path" "integer maxdepth" 24
WorldBegin
LightSource "infinite" "rgb L" [ .3 .5 .7 ]
AttributeBegin
  Translate -1.8 3 -.7
  AreaLightSource "diffuse" "rgb L" [ 2 1.6 1.2 ]
  Shape "sphere" "float radius" 1.4
AttributeEnd
Material "diffuse" "rgb reflectance" [ .6 .5 .4 ]
Shape "plane"
Material "dielectric"
Shape "revolution" "integer degree" 3 "point2 P" [
    0 0  .2 0  .38 0  .4 .02  .42 .05  .06 .05  .05 .15  .045 .3  .045 .42  .06 .5  .1 .58  .42 .62  .42 .95
    .42 1.1  .39 1.2  .37 1.3  .365 1.32  .35 1.32  .345 1.3  .36 1.2  .38 1.1  .38 .95  .38 .7  .15 .6  0 .6 ]
)";

/// The bar is 0.3 % of the mean; the samples are so many that a picture off by twice that is found out.
TEST(MeshAgreement, GobletWithinThreeThousandthsOfTheMean) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.file("scene.pbrt")) << goblet;
    const PlainScene plain = makePlainScene(folder.file("scene.pbrt"));
    std::filesystem::create_directories(folder.file("meshes"));
    ASSERT_EQ(plain.meshes.size(), 1u);
    writePly(folder.file(plain.meshes[0].fileName), plain.meshes[0].make());
    std::string text = writeScene(plain.nodes);
    // render_text.h reads texts that lie nowhere.
    const std::string name = plain.meshes[0].fileName;
    text.replace(text.find(name), name.size(), folder.file(name));

    const std::uint64_t passes = 512 * std::uint64_t(test::longRun());
    const Measured exact = measure(goblet, passes), mesh = measure(text, passes);
    for (int c = 0; c < 3; ++c) {
        const double error = std::hypot(exact.error[c], mesh.error[c]);
        EXPECT_NEAR(mesh.mean[c], exact.mean[c], 0.003 * exact.mean[c] + 4 * error) << "channel " << c;
        EXPECT_LT(4 * error, 0.006 * exact.mean[c]) << "too few samples to say";
        RecordProperty("ratio" + std::to_string(c), std::to_string(mesh.mean[c] / exact.mean[c]));
        RecordProperty("error" + std::to_string(c), std::to_string(error / exact.mean[c]));
    }
}

} // namespace
} // namespace vitrine
