// Scenes whose radiance is known in closed form, through the whole program: reader, builder, path tracer, film.
#include "known_values.h"
#include "render_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

/// 4 x 4 pixels that look from +z to the origin.
std::string head(const std::string& camera, const std::string& integrator = "\"integer maxdepth\" 200") {
    return vitrine::head(camera, "\"path\" " + integrator);
}
const std::string inside = "Camera \"perspective\" \"float fov\" 60\n";
const std::string fromFar = "LookAt 0 0 5 0 0 0 0 1 0\nCamera \"perspective\" \"float fov\" 10\n";
/// Parallel rays along -z through the middle.
const std::string parallel =
    "LookAt 0 0 5 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.1 .1 -.1 .1]\n";
const std::string sky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";

// ---- White furnace: a closed room that emits 1 and reflects a shows 1 / (1 - a) everywhere. ----

class Furnace : public testing::TestWithParam<double> {};

TEST_P(Furnace, SphereOfAlbedoA) {
    const double a = GetParam();
    const std::string room = fmt::format("Material \"diffuse\" \"spectrum reflectance\" [300 {0} 900 {0}]\n"
                                         "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\nReverseOrientation\n"
                                         "Shape \"sphere\" \"float radius\" 2\n",
                                         a);
    EXPECT_RADIANCE(head(inside) + room, 1 / (1 - a));
    EXPECT_RADIANCE(head(inside, "\"integer maxdepth\" 200 \"bool nee\" false") + room, 1 / (1 - a));
}

TEST_P(Furnace, RevolvedRoom) {
    const double a = GetParam();
    // A closed profile has its normal outside; the room shines inwards.
    EXPECT_RADIANCE(head(inside) + fmt::format("Material \"diffuse\" \"spectrum reflectance\" [300 {0} 900 {0}]\n"
                                               "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\nReverseOrientation\n"
                                               "Shape \"revolution\" \"point2 P\" [0 -2  3 -2  3 2  0 2]\n",
                                               a),
                    1 / (1 - a));
}

INSTANTIATE_TEST_SUITE_P(Albedos, Furnace, testing::Values(0.25, 0.5, 0.8));

// ---- What neither absorbs nor emits is invisible under a uniform sky. ----

class Invisible : public testing::TestWithParam<const char*> {};

TEST_P(Invisible, UnderAUniformSky) {
    EXPECT_RADIANCE(head(fromFar) + sky + GetParam() + "\nShape \"sphere\"\n", 1.);
}

TEST_P(Invisible, BeforeAUniformSkyAndRevolved) {
    EXPECT_RADIANCE(
        head(fromFar) + sky + GetParam() +
            "\nShape \"revolution\" \"integer degree\" 3 \"point2 P\" [0 -1  .55 -1  1 -.55  1 0  1 .55  .55 1  0 1]\n",
        1.);
}

INSTANTIATE_TEST_SUITE_P(Materials, Invisible,
                         testing::Values("Material \"dielectric\"", "Material \"dielectric\" \"float eta\" 2.4",
                                         "Material \"dielectric\" \"spectrum eta\" \"glass-F11\"",
                                         "Material \"dielectric\" \"float eta\" 1.0",
                                         "Material \"dielectric\" \"float eta\" 0.7",
                                         "Material \"dielectric\" \"integer priority\" 3",
                                         "Material \"thindielectric\"", "Material \"interface\""));

TEST(Invisible, NestedSolidsOfEveryOrder) {
    for (const int inner : {1, 2, 3})
        EXPECT_RADIANCE(head(fromFar) + sky +
                            fmt::format("Material \"dielectric\" \"integer priority\" 2\nShape \"sphere\"\n"
                                        "Material \"dielectric\" \"float eta\" 1.33 \"integer priority\" {}\n"
                                        "Translate .3 0 .2\nShape \"sphere\" \"float radius\" .9\n",
                                        inner),
                        1.);
}

// ---- Absorption and interfaces at normal incidence, in closed form. ----

/// What a slab shows under a uniform sky of radiance 1: reflected plus transmitted, over all inner reflections.
double slab(double reflectance, double transmittance) {
    return reflectance + (1 - reflectance) * (1 - reflectance) * transmittance / (1 - reflectance * transmittance);
}

TEST(Absorption, SlabAtNormalIncidence) {
    const std::string box = "Shape \"box\" \"point3 pmin\" [-9 -9 -.5] \"point3 pmax\" [9 9 .5]\n";
    const std::string absorbing = "\"spectrum absorption\" [300 .7 900 .7]\n";
    EXPECT_RADIANCE(head(parallel) + sky + "Material \"dielectric\" \"float eta\" 1 " + absorbing + box, std::exp(-.7));
    EXPECT_RADIANCE(head(parallel) + sky + "Material \"dielectric\" " + absorbing + box,
                    slab(fresnel(1, 1.5), std::exp(-.7)));
}

TEST(NestedDielectrics, AnOverlapIsWhatPrioritySays) {
    // Wine reaches .2 into the glass pane; the pane (higher priority) is there, so that the wine is .8 thick.
    const std::string scene =
        "Material \"dielectric\" \"float eta\" 1.5 \"integer priority\" 2\n"
        "Shape \"box\" \"point3 pmin\" [-9 -9 0] \"point3 pmax\" [9 9 1]\n"
        "Material \"dielectric\" \"float eta\" 1.5 \"integer priority\" 1 \"spectrum absorption\" [300 .5 900 .5]\n"
        "Shape \"box\" \"point3 pmin\" [-9 -9 -.8] \"point3 pmax\" [9 9 .2]\n";
    // Equal indices: nothing reflects between them, one slab with .8 of absorption.
    EXPECT_RADIANCE(head(parallel) + sky + scene, slab(fresnel(1, 1.5), std::exp(-.5 * .8)));
}

TEST(NestedDielectrics, TheInterfaceIsRelative) {
    // Glass against wine of another index: three interfaces; the closed form by adding layers.
    const double r1 = fresnel(1, 1.5), r2 = fresnel(1.5, 1.33), r3 = fresnel(1.33, 1);
    const double t = std::exp(-.5 * .8);
    // Reflection and transmission of the last two layers seen from inside the glass, then of the whole stack.
    const double r23 = r2 + (1 - r2) * (1 - r2) * r3 * t * t / (1 - r2 * r3 * t * t);
    const double t23 = (1 - r2) * (1 - r3) * t / (1 - r2 * r3 * t * t);
    const double expected = r1 + (1 - r1) * (1 - r1) * r23 / (1 - r1 * r23) + (1 - r1) * t23 / (1 - r1 * r23);
    const std::string scene =
        "Material \"dielectric\" \"float eta\" 1.5 \"integer priority\" 2\n"
        "Shape \"box\" \"point3 pmin\" [-9 -9 0] \"point3 pmax\" [9 9 1]\n"
        "Material \"dielectric\" \"float eta\" 1.33 \"integer priority\" 1 \"spectrum absorption\" [300 .5 900 .5]\n"
        "Shape \"box\" \"point3 pmin\" [-9 -9 -.8] \"point3 pmax\" [9 9 .2]\n";
    EXPECT_RADIANCE(head(parallel) + sky + scene, expected);
}

TEST(NestedDielectrics, SolidsThatTouchMakeNoEnergyAndAreNoticed) {
    // They should overlap: of faces in one place a path meets only one. Light may be misled then, but never made.
    const std::string scene = head(parallel) + sky +
                              "Material \"dielectric\" \"integer priority\" 2\n"
                              "Shape \"box\" \"point3 pmin\" [-9 -9 -1] \"point3 pmax\" [9 9 1]\n"
                              "Material \"dielectric\" \"float eta\" 1.33 \"integer priority\" 1\n"
                              "Shape \"box\" \"point3 pmin\" [-9 -9 1] \"point3 pmax\" [9 9 3]\n";
    const Measured measured = measure(scene);
    for (int c = 0; c < 3; ++c)
        EXPECT_LE(measured.mean[c], 1 + 5 * measured.error[c] + 1e-3);
    const Scene loaded = loadSceneString(scene);
    Film film(loaded.film);
    RenderCounters counters;
    loaded.integrator->addPasses(loaded.world, {0, 16}, film, counters);
    EXPECT_GT(counters.lostExits, counters.samples / 10);
}

TEST(NestedDielectrics, ClosedOverlappingSolidsAreNeverLost) {
    const Scene loaded = loadSceneString(head(fromFar) + sky +
                                         "Material \"dielectric\" \"integer priority\" 2\nShape \"sphere\"\n"
                                         "Material \"dielectric\" \"float eta\" 1.33 \"integer priority\" 1\n"
                                         "Translate .3 0 .2\nShape \"sphere\" \"float radius\" .9\n");
    Film film(loaded.film);
    RenderCounters counters;
    loaded.integrator->addPasses(loaded.world, {0, 4096}, film, counters);
    EXPECT_LE(counters.lostExits * 10000, counters.samples);
}

TEST(Absorption, RaysOfAnOrthographicCameraMayStartInDifferentSolids) {
    // Half of the picture starts in the middle of a block of thickness 2, the other half beside it.
    const std::string camera =
        "LookAt 0 0 0 0 0 -1 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-4 4 -4 4]\n";
    EXPECT_RADIANCE(head(camera) + sky +
                        "Material \"dielectric\" \"float eta\" 1 \"spectrum absorption\" [300 .5 900 .5]\n"
                        "Shape \"box\" \"point3 pmin\" [0 -9 -1] \"point3 pmax\" [9 9 1]\n",
                    (1 + std::exp(-.5)) / 2);
}

TEST(Absorption, TheCameraMayStandUnderAnInfinitePlane) {
    const std::string camera =
        "LookAt 0 0 0 0 0 1 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.1 .1 -.1 .1]\n";
    EXPECT_RADIANCE(head(camera) + sky +
                        "Material \"dielectric\" \"float eta\" 1 \"spectrum absorption\" [300 .5 900 .5]\n"
                        "Shape \"plane\" \"normal n\" [0 0 1] \"float d\" 1\n",
                    std::exp(-.5));
}

TEST(NestedDielectrics, TheCameraMayStandInside) {
    const std::string camera =
        "LookAt 0 0 0 0 0 -1 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.1 .1 -.1 .1]\n";
    // In the middle of an absorbing slab of index 1.5: half of the slab's way; what is reflected goes the whole way.
    // Inside, radiance is eta^2 times that outside.
    const double r = fresnel(1, 1.5), t = std::exp(-.4);
    EXPECT_RADIANCE(head(camera) + sky +
                        "Material \"dielectric\" \"integer priority\" 1 \"spectrum absorption\" [300 .4 900 .4]\n"
                        "Shape \"box\" \"point3 pmin\" [-9 -9 -1] \"point3 pmax\" [9 9 1]\n",
                    1.5 * 1.5 * t * (1 - r) / (1 - r * t * t));
}

TEST(ShadowRays, PassOverruledAndInterfaceSurfacesWithoutBias) {
    // A matt floor inside a pane that fills all around it, lit through surfaces that are not there.
    const std::string scene = "Material \"diffuse\" \"spectrum reflectance\" [300 .5 900 .5]\n"
                              "Shape \"disk\" \"float radius\" 50\n"
                              "Material \"dielectric\" \"float eta\" 1 \"integer priority\" 2\n"
                              "Shape \"box\" \"point3 pmin\" [-60 -60 -3] \"point3 pmax\" [60 60 60]\n"
                              "Material \"dielectric\" \"float eta\" 1.5 \"integer priority\" 1\n"
                              "Shape \"box\" \"point3 pmin\" [-40 -40 -1] \"point3 pmax\" [40 40 1]\n"
                              "Material \"interface\"\n"
                              "Shape \"box\" \"point3 pmin\" [-30 -30 -1] \"point3 pmax\" [30 30 2]\n"
                              "AreaLightSource \"diffuse\" \"rgb L\" [5 5 5]\nTranslate 0 0 4\nRotate 180 1 0 0\n"
                              "Shape \"disk\" \"float radius\" 1\n";
    const std::string camera =
        "LookAt 0 0 3 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.01 .01 -.01 .01]\n";
    const double irradiance = double(piD) * 5 * (1. / (16 + 1)); // disk seen from its axis: pi L r^2 / (d^2 + r^2)
    const double expected = .5 / double(piD) * irradiance;
    EXPECT_RADIANCE(head(camera, "\"integer maxdepth\" 1") + scene, expected);
    EXPECT_RADIANCE(head(camera, "\"integer maxdepth\" 1 \"bool nee\" false") + scene, expected);
}

// ---- Irradiance of a matt floor seen from above. ----

class Irradiance : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(Irradiance, OfAMattFloor) {
    const auto [lights, irradiance] = GetParam();
    const std::string camera =
        "LookAt 0 0 1 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.001 .001 -.001 .001]\n";
    const std::string floor = "Material \"diffuse\" \"spectrum reflectance\" [300 .6 900 .6]\n"
                              "Shape \"plane\" \"normal n\" [0 0 1] \"float d\" 0\n";
    EXPECT_RADIANCE(head(camera, "\"integer maxdepth\" 1") + lights + floor, .6 / double(piD) * irradiance);
}

INSTANTIATE_TEST_SUITE_P(Lights, Irradiance, testing::ValuesIn(lightsOverAFloor));
INSTANTIATE_TEST_SUITE_P(
    MoreLights, Irradiance,
    testing::Values(
        std::pair("LightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [2 0 2]\n", 3. / 8 * M_SQRT1_2),
        // A disk with a power in lumens: L = P / (pi A).
        std::pair("AttributeBegin\nAreaLightSource \"diffuse\" \"float power\" 100\nTranslate 0 0 3\nRotate 180 1 0 0\n"
                  "Shape \"disk\" \"float radius\" 2\nAttributeEnd\n",
                  100 / (M_PI * 4.) * 4. / (9 + 4))));

} // namespace
} // namespace vitrine
