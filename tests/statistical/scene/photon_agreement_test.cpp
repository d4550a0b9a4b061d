// Three estimators of one scene with everything that bends a photon's way or colour.
#include "render_text.h"
#include "support/long_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

/// A floor and a ball of rough copper, lit by a lamp through a ball of tinted glass that disperses. The camera sees the
/// glass in the copper only: light tracing cannot connect to it.
std::string sceneOf(const std::string& integrator) {
    return "LookAt .2 1.1 2.2  .2 .1 0  0 1 0\nCamera \"perspective\" \"float fov\" 30\n"
           "Film \"rgb\" \"integer xresolution\" 24 \"integer yresolution\" 24\nSampler \"zsobol\"\n"
           "PixelFilter \"box\"\nIntegrator " +
           integrator +
           "\nWorldBegin\nMaterial \"diffuse\" \"rgb reflectance\" [.6 .5 .4]\n"
           "Shape \"bilinearmesh\" \"point3 P\" [-1 0 1.5  1.5 0 1.5  -1 0 -1.5  1.5 0 -1.5]\n"
           "AttributeBegin\nTranslate .55 .25 0\nMaterial \"conductor\" \"spectrum eta\" \"metal-Cu-eta\" "
           "\"spectrum k\" \"metal-Cu-k\" \"float roughness\" .25\nShape \"sphere\" \"float radius\" "
           ".25\nAttributeEnd\n"
           "AttributeBegin\nTranslate 0 1.5 0\nMaterial \"dielectric\" \"spectrum eta\" \"glass-F11\" "
           "\"rgb absorption\" [.3 1 2]\nShape \"sphere\" \"float radius\" .4\nAttributeEnd\n"
           "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [8 8 8]\nTranslate 0 3 0\n"
           "Shape \"sphere\" \"float radius\" .6\nAttributeEnd\n";
}

struct Method {
    const char* name;
    std::string integrator;
    double bias; ///< at most, as a part of the mean
};

TEST(PhotonAgreement, WithPathTracing) {
    const auto work = std::uint64_t(test::longRun());
    const Measured path = measure(sceneOf("\"path\" \"integer maxdepth\" 12"), 1024 * work);
    const std::string common = "\"integer maxdepth\" 12 \"integer photonsperiteration\" 16384 ",
                      small = common + "\"float radiuspixels\" .5 ";
    // Light tracing has no bias. Disks of at most half a pixel of 24 lose light where the copper stands on the floor and at
    // the outlines of what they lie on, some ten pixels long: 10 x 2 x 0.17 x 0.5 of 576.
    for (const Method& method :
         {Method{"sppm", "\"sppm\" " + small, 0.003},
          Method{"all by photons", "\"sppm\" \"bool directbyphotons\" true \"string radiusrule\" \"perpoint\" " + small,
                 0.003},
          Method{"ppm", "\"ppm\" " + small, 0.003}, Method{"lightpath", "\"lightpath\" " + common, 0}}) {
        expectAgreement(method.name, measure(sceneOf(method.integrator), 64 * work), path, method.bias, 0.018);
    }
}

} // namespace
} // namespace vitrine
