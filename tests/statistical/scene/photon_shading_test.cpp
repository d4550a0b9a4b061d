// Photons and light paths on surfaces whose shading normals differ from the true ones, and through frosted and thin glass.
#include "known_values.h"
#include "render_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

// ---- Shading normals ----

constexpr double tilt = 0.5; ///< sine of the shading normal's angle to the true one, in x

/// A square of 2 x 2 in z = 0 that is shaded as if it leaned towards the sun, which stands at atan(1/2) in x and shines
/// on what faces it with an irradiance of 1.
std::string leaningFloor() {
    const std::string normal = fmt::format("{} 0 {} ", tilt, std::sqrt(1 - tilt * tilt));
    return "LightSource \"distant\" \"rgb L\" [1 1 1] \"point3 from\" [2 0 1] \"point3 to\" [0 0 0]\n"
           "Material \"diffuse\" \"spectrum reflectance\" [300 .6 900 .6]\n"
           "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point3 P\" [-1 -1 0  1 -1 0  1 1 0  -1 1 0]\n"
           "\"normal N\" [" +
           normal + normal + normal + normal + "]\n";
}

/// Radiance that the floor reflects: by the cosine at the shading normal.
double ofFloor() {
    const double shadingCosine = (2 * tilt + std::sqrt(1 - tilt * tilt)) / std::sqrt(5.);
    return .6 / M_PI * shadingCosine;
}

/// Form factor from an element to a parallel square of 2 x 2 at distance 1 below it: four times that of a quarter.
double formFactor() {
    return 4 / (2 * M_PI) * 2 * M_SQRT1_2 * std::atan(M_SQRT1_2);
}

/// Within 5 standard errors and one percent.
void expectRadiance(const std::string& text, double expected, std::uint64_t passes) {
    vitrine::expectRadiance(text, expected, passes, 0.01, 0.05);
}

constexpr const char* byPhotons = "\"sppm\" \"integer photonsperiteration\" 20000 \"float radius\" .05 "
                                  "\"bool directbyphotons\" true";
constexpr const char* byLightPaths = "\"lightpath\" \"integer photonsperiteration\" 20000";

class ShadingNormals : public testing::TestWithParam<const char*> {};

TEST_P(ShadingNormals, WherePhotonsLand) {
    const std::string camera =
        "LookAt 0 0 1 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.2 .2 -.2 .2]\n";
    expectRadiance(head(camera, GetParam() + std::string(" \"integer maxdepth\" 1")) + leaningFloor(), ofFloor(), 16);
}

/// A small disk above the floor, seen from below: light that left the floor against the order of eye paths (Veach 1997,
/// sec. 5.3.2).
TEST_P(ShadingNormals, WherePhotonsWereScattered) {
    const std::string camera =
        "LookAt 0 0 .5 0 0 1 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.1 .1 -.1 .1]\n";
    expectRadiance(head(camera, GetParam() + std::string(" \"integer maxdepth\" 2")) + leaningFloor() +
                       "Translate 0 0 1\nShape \"disk\" \"float radius\" .2\n",
                   .6 * ofFloor() * formFactor(), 24);
}

INSTANTIATE_TEST_SUITE_P(Methods, ShadingNormals, testing::Values(byPhotons, byLightPaths));

// ---- Thin and frosted glass ----

constexpr const char* methods[] = {"\"sppm\" \"float radius\" .1",
                                   "\"sppm\" \"float radius\" .1 \"bool directbyphotons\" true", "\"lightpath\""};

TEST(Panes, ThinGlassLetsLightThrough) {
    // Of all orders of reflection between the sheet's faces 2R / (1 + R) goes back.
    const double r = fresnel(1, 1.5), through = (1 - r) / (1 + r);
    const std::string camera =
        "LookAt 0 0 .5 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.1 .1 -.1 .1]\n";
    for (const std::string method : methods)
        expectRadiance(head(camera, method + " \"integer maxdepth\" 2 \"integer photonsperiteration\" 5000") +
                           "LightSource \"distant\" \"rgb L\" [1 1 1] \"point3 from\" [0 0 1] \"point3 to\" [0 0 0]\n"
                           "Material \"diffuse\" \"spectrum reflectance\" [300 .5 900 .5]\n"
                           "Shape \"disk\" \"float radius\" 1\nMaterial \"thindielectric\" \"float eta\" 1.5\n"
                           "Translate 0 0 1\nShape \"disk\" \"float radius\" 1\n",
                       .5 / M_PI * through, 16);
}

/// A pane of frosted glass between a lamp and a floor. \param up the camera looks at the pane, else at the floor
std::string frosted(const std::string& integrator, bool up) {
    return head(fmt::format("LookAt 0 .01 .5 0 0 {} 0 1 0\nCamera \"perspective\" \"float fov\" 90\n", up ? 1 : 0),
                integrator + " \"integer maxdepth\" 6", 8) +
           "Material \"diffuse\" \"spectrum reflectance\" [300 .5 900 .5]\nShape \"disk\" \"float radius\" 1\n"
           "Material \"dielectric\" \"float eta\" 1.5 \"float roughness\" .4\n"
           "Shape \"box\" \"point3 pmin\" [-1 -1 .8] \"point3 pmax\" [1 1 1]\n"
           "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\nTranslate 0 0 1.5\nRotate 180 1 0 0\n"
           "Shape \"disk\" \"float radius\" 1.2\n";
}

TEST(Panes, FrostedGlassAgreesWithPathTracing) {
    for (const bool up : {false, true}) {
        const Measured path = measure(frosted("\"path\"", up), 256);
        for (const std::string method : {methods[0], methods[2]}) { // no light is direct: the second is the first
            const Measured ours = measure(frosted(method + " \"integer photonsperiteration\" 8000", up), 8, 4);
            for (int c = 0; c < 3; ++c) {
                const double error = std::hypot(path.error[c], ours.error[c]);
                EXPECT_NEAR(ours.mean[c], path.mean[c], 5 * error + 0.01 * path.mean[c]) << method << up << c;
                EXPECT_LT(error, 0.03 * path.mean[c]) << method << up << ": too noisy for a test";
            }
        }
    }
}

} // namespace
} // namespace vitrine
