// White furnaces and mixes: under a uniform sky of radiance 1 what loses nothing is invisible.
#include "render_text.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

std::string underSky(const std::string& integrator, const std::string& things) {
    return "LookAt 0 0 5 0 0 0 0 1 0\nCamera \"perspective\" \"float fov\" 10\n"
           "Film \"rgb\" \"integer xresolution\" 4 \"integer yresolution\" 4\nSampler \"zsobol\"\n"
           "PixelFilter \"box\"\nIntegrator " +
           integrator + "\nWorldBegin\nLightSource \"infinite\" \"rgb L\" [1 1 1]\n" + things;
}
/// Long enough for photons that are reflected a thousand times between coat and base.
const std::string white = " \"spectrum reflectance\" [300 1 900 1] \"integer maxdepth\" 2000 ";
const std::string ball = "\nShape \"sphere\"\n";

class WhiteFurnace : public testing::TestWithParam<std::string> {};

TEST_P(WhiteFurnace, IsInvisible) {
    EXPECT_RADIANCE(underSky("\"path\" \"integer maxdepth\" 100", GetParam() + ball), 1.);
    EXPECT_RADIANCE(underSky("\"path\" \"integer maxdepth\" 100 \"bool nee\" false", GetParam() + ball), 1.);
}

INSTANTIATE_TEST_SUITE_P(
    Materials, WhiteFurnace,
    testing::Values("Material \"coateddiffuse\" \"float thickness\" 0" + white,
                    "Material \"coateddiffuse\" \"float thickness\" .5 \"spectrum albedo\" [300 1 900 1] "
                    "\"float g\" .4" +
                        white,
                    "Material \"coatedconductor\" \"float thickness\" .7 \"spectrum albedo\" [300 1 900 1] "
                    "\"spectrum conductor.eta\" [300 0 900 0] \"spectrum conductor.k\" [300 3 900 3] "
                    "\"integer maxdepth\" 2000",
                    "Material \"coatedconductor\" \"float thickness\" 0 \"spectrum conductor.eta\" [300 0 900 0] "
                    "\"spectrum conductor.k\" [300 3 900 3]",
                    "Material \"diffusetransmission\" \"spectrum reflectance\" [300 .3 900 .3] "
                    "\"spectrum transmittance\" [300 .7 900 .7]",
                    "MakeNamedMaterial \"a\" \"string type\" \"diffuse\" \"spectrum reflectance\" [300 1 900 1]\n"
                    "MakeNamedMaterial \"b\" \"string type\" \"dielectric\"\n"
                    "Material \"mix\" \"string materials\" [\"a\" \"b\"] \"float amount\" .4"));

TEST(Mix, ReflectsTheMeanOfItsPartsInEveryIntegrator) {
    const std::string mixed =
        "MakeNamedMaterial \"a\" \"string type\" \"diffuse\" \"spectrum reflectance\" [300 .2 900 .2]\n"
        "MakeNamedMaterial \"b\" \"string type\" \"diffuse\" \"spectrum reflectance\" [300 .9 900 .9]\n"
        "Material \"mix\" \"string materials\" [\"a\" \"b\"] \"float amount\" .3" +
        ball;
    const double expected = 0.7 * 0.2 + 0.3 * 0.9;
    EXPECT_RADIANCE(underSky("\"path\"", mixed), expected);
    // Photons on a ball lie on a smaller area than their disks: 1 % for disks of a tenth of its radius.
    for (const char* integrator : {"\"lightpath\" \"integer photonsperiteration\" 20000",
                                   "\"sppm\" \"integer photonsperiteration\" 5000 \"float radius\" .1",
                                   "\"ppm\" \"integer photonsperiteration\" 5000 \"float radius\" .1",
                                   "\"sppm\" \"integer photonsperiteration\" 20000 \"bool directbyphotons\" true "
                                   "\"float radius\" .1"}) {
        const Measured measured = measure(underSky(integrator, mixed), 64);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(measured.mean[c], expected, 5 * measured.error[c] + 0.01 * expected) << integrator << c;
            EXPECT_LT(measured.error[c], 0.02 * expected) << integrator << ": too noisy for a test";
        }
    }
}

} // namespace
} // namespace vitrine
