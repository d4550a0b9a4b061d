// Photon mapping on surfaces between matt and polished, where eye paths gather some photons and go on for other light: all
// light must count once, whatever the roughness.
#include "known_values.h"
#include "render_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

std::string metal(double alpha) {
    return fmt::format("Material \"conductor\" \"bool remaproughness\" false \"float roughness\" {}\n", alpha);
}

class RoughMetal : public testing::TestWithParam<double> {};

/// A metal floor lit straight from above through a pane, seen from between them, against the same without the pane by the
/// path tracer, which cannot look for a distant light through glass.
TEST_P(RoughMetal, ShowsAllThatOnlyPhotonsFind) {
    const auto scene = [&](const std::string& integrator, const std::string& pane) {
        return "LookAt .03 0 .5 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.1 .1 -.1 .1]\n"
               "Film \"rgb\" \"integer xresolution\" 4 \"integer yresolution\" 4\nPixelFilter \"box\"\n"
               "Sampler \"zsobol\"\nIntegrator " +
               integrator +
               "\nWorldBegin\nLightSource \"distant\" \"rgb L\" [1 1 1] \"point3 from\" [0 0 1] "
               "\"point3 to\" [0 0 0]\n" +
               metal(GetParam()) + "Shape \"disk\" \"float radius\" 1\n" + pane;
    };
    const Measured direct = measure(scene("\"path\" \"integer maxdepth\" 1", ""), 64, 2);
    const double through = (1 - fresnel(1, 1.5)) * (1 - fresnel(1, 1.5));
    for (const char* integrator : {"\"sppm\"", "\"ppm\""}) {
        const Measured measured =
            measure(scene(integrator + std::string(" \"integer maxdepth\" 3 \"integer photonsperiteration\" 5000 "
                                                   "\"float radius\" .1"),
                          "Material \"dielectric\" \"float eta\" 1.5\n"
                          "Shape \"box\" \"point3 pmin\" [-1 -1 .8] \"point3 pmax\" [1 1 1]\n"),
                    64);
        for (int c = 0; c < 3; ++c) {
            const double expected = through * direct.mean[c];
            EXPECT_NEAR(measured.mean[c], expected, 5 * measured.error[c] + 5e-3 * expected) << integrator << c;
            EXPECT_LT(measured.error[c], 0.02 * expected) << "too noisy for a test";
        }
    }
}

/// A lamp of some size, so that the path tracer finds its light through a glass ball too, above metal and a matt wall.
TEST_P(RoughMetal, AgreesWithPathTracing) {
    const auto scene = [&](const std::string& integrator) {
        return "LookAt 0 3.2 4  0 .3 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
               "Film \"rgb\" \"integer xresolution\" 24 \"integer yresolution\" 24\nPixelFilter \"box\"\n"
               "Sampler \"zsobol\"\nIntegrator " +
               integrator + " \"integer maxdepth\" 7\nWorldBegin\n" + metal(GetParam()) +
               "AttributeBegin\nRotate -90 1 0 0\nShape \"disk\" \"float radius\" 2.5\nAttributeEnd\n"
               "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5]\nAttributeBegin\nTranslate 0 0 -2.5\n"
               "Shape \"disk\" \"float radius\" 2.5\nAttributeEnd\n"
               "AttributeBegin\nTranslate 0 .9 0\nMaterial \"dielectric\"\nShape \"sphere\" \"float radius\" .6\n"
               "AttributeEnd\nAreaLightSource \"diffuse\" \"rgb L\" [4 4 4]\nTranslate -2 4 1\n"
               "Shape \"sphere\" \"float radius\" 1.2\n";
    };
    const Measured path = measure(scene("\"path\""), 256, 8);
    const Measured photons =
        measure(scene("\"sppm\" \"integer photonsperiteration\" 12000 \"float radius\" .06"), 64, 8);
    for (int c = 0; c < 3; ++c) {
        const double error = std::hypot(path.error[c], photons.error[c]);
        EXPECT_NEAR(photons.mean[c], path.mean[c], 5 * error + 2e-3 * path.mean[c]) << "channel " << c;
        EXPECT_LT(error, 0.01 * path.mean[c]) << "too noisy for a test";
    }
}

// Between the roughnesses at which more and more photons are gathered, and at both ends.
INSTANTIATE_TEST_SUITE_P(Alphas, RoughMetal, testing::Values(0.06, 0.12, 0.3, 0.6));

} // namespace
} // namespace vitrine
