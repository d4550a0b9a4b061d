// Scenes whose radiance is known in closed form, by photons: what photon mapping and light tracing must show besides the
// bias of their disks, which the scenes keep below the tolerance.
#include "known_values.h"
#include "render_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

/// Within 5 standard errors and half a percent.
/// \param noisiest the largest standard error, as a part of `expected`, with which this is a test
void expectRadiance(const std::string& text, double expected, std::uint64_t passes, double noisiest = 0.05) {
    vitrine::expectRadiance(text, expected, passes, 5e-3, noisiest);
}

// ---- White furnace: a closed room that emits 1 and reflects a shows 1 / (1 - a). ----

struct Method {
    const char* name;
    const char* integrator;
};

class PhotonFurnace : public testing::TestWithParam<Method> {};

TEST_P(PhotonFurnace, SphereOfAlbedoA) {
    for (const double a : {0.25, 0.8})
        expectRadiance(head("Camera \"perspective\" \"float fov\" 60\n", GetParam().integrator, 8) +
                           fmt::format("Material \"diffuse\" \"spectrum reflectance\" [300 {0} 900 {0}]\n"
                                       "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\nReverseOrientation\n"
                                       "Shape \"sphere\" \"float radius\" 2\n",
                                       a),
                       1 / (1 - a), 16, 0.005);
}

TEST_P(PhotonFurnace, GreyIsGreyAfterSixteenPasses) {
    const Measured measured = measure(head("Camera \"perspective\" \"float fov\" 60\n", GetParam().integrator, 8) +
                                          "Material \"diffuse\" \"spectrum reflectance\" [300 .5 900 .5]\n"
                                          "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\nReverseOrientation\n"
                                          "Shape \"sphere\" \"float radius\" 2\n",
                                      16, 2);
    // Photons are grey too, so that their noise is the same in all channels.
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(measured.mean[c] / measured.mean[1], 1, 2e-3) << "channel " << c;
}

INSTANTIATE_TEST_SUITE_P(
    Methods, PhotonFurnace,
    testing::Values(
        Method{"sppm", "\"sppm\" \"integer maxdepth\" 60 \"integer photonsperiteration\" 6000 \"float radius\" .2"},
        Method{"constantKernel", "\"sppm\" \"integer maxdepth\" 60 \"integer photonsperiteration\" 6000 "
                                 "\"float radius\" .2 \"string kernel\" \"constant\""},
        Method{"perpoint", "\"sppm\" \"integer maxdepth\" 60 \"integer photonsperiteration\" 6000 "
                           "\"float radius\" .2 \"string radiusrule\" \"perpoint\""},
        Method{"ppm", "\"ppm\" \"integer maxdepth\" 60 \"integer photonsperiteration\" 6000 \"float radius\" .2"},
        Method{"ppmTree", "\"ppm\" \"integer maxdepth\" 60 \"integer photonsperiteration\" 6000 \"float radius\" .2 "
                          "\"string lookup\" \"kdtree\" \"string radiusrule\" \"perpoint\""},
        Method{"directByPhotons", "\"sppm\" \"integer maxdepth\" 60 \"integer photonsperiteration\" 6000 "
                                  "\"float radius\" .2 \"bool directbyphotons\" true"},
        Method{"lightpath", "\"lightpath\" \"integer maxdepth\" 60 \"integer photonsperiteration\" 6000"}),
    [](const auto& m) { return std::string(m.param.name); });

// ---- Irradiance of a matt floor seen from above, all light by photons, by next-event estimation, or by light paths. ----

class PhotonIrradiance : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(PhotonIrradiance, OfAMattFloor) {
    const auto [lights, irradiance] = GetParam();
    const std::string camera =
        "LookAt 0 0 1 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.1 .1 -.1 .1]\n";
    const std::string floor = "Material \"diffuse\" \"spectrum reflectance\" [300 .6 900 .6]\n"
                              "Shape \"disk\" \"float radius\" 3\n";
    for (const char* integrator : {"\"sppm\" \"integer maxdepth\" 1 \"integer photonsperiteration\" 20000 "
                                   "\"float radius\" .1 \"bool directbyphotons\" true",
                                   "\"sppm\" \"integer maxdepth\" 1 \"integer photonsperiteration\" 100",
                                   "\"lightpath\" \"integer maxdepth\" 1 \"integer photonsperiteration\" 20000"})
        expectRadiance(head(camera, integrator) + lights + floor, .6 / double(piD) * irradiance, 16);
}

INSTANTIATE_TEST_SUITE_P(Lights, PhotonIrradiance, testing::ValuesIn(lightsOverAFloor));

// ---- Light through slabs at normal incidence, which path tracing cannot find. ----

/// A floor below a slab, seen from between them, lit straight from above; 1 falls on the slab.
std::string underSlab(const std::string& glass, const std::string& integrator) {
    return head("LookAt 0 0 .5 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.1 .1 -.1 .1]\n",
                integrator) +
           "LightSource \"distant\" \"rgb L\" [1 1 1] \"point3 from\" [0 0 1] \"point3 to\" [0 0 0]\n"
           "Material \"diffuse\" \"spectrum reflectance\" [300 .5 900 .5]\nShape \"disk\" \"float radius\" 1\n"
           "Material \"dielectric\" " +
           glass + "\nShape \"box\" \"point3 pmin\" [-1 -1 .8] \"point3 pmax\" [1 1 1]\n";
}

class Slab : public testing::TestWithParam<const char*> {};

TEST_P(Slab, LetsLightThrough) {
    // Of what the floor reflects nothing is to come back: events are bounded to two surfaces, once through, and the floor.
    const double r = fresnel(1, 1.5);
    expectRadiance(underSlab("\"float eta\" 1.5", GetParam()), .5 / piD * (1 - r) * (1 - r), 32, 0.02);
}

TEST_P(Slab, Absorbs) {
    const double r = fresnel(1, 1.5);
    const double expected = .5 / piD * (1 - r) * (1 - r) * std::exp(-.2 * 3);
    expectRadiance(underSlab("\"float eta\" 1.5 \"spectrum absorption\" [300 3 900 3]", GetParam()), expected, 32,
                   0.02);
    expectRadiance(
        underSlab("\"float eta\" 1.5 \"integer priority\" 1 \"spectrum absorption\" [300 3 900 3]", GetParam()),
        expected, 32, 0.02);
}

TEST_P(Slab, DispersesWithoutLosingLight) {
    // Between BK7's indices at both ends of the spectrum the transmittance differs by 0.4 %.
    const double r = fresnel(1, 1.52);
    expectRadiance(underSlab("\"spectrum eta\" \"glass-BK7\"", GetParam()), .5 / piD * (1 - r) * (1 - r), 64, 0.03);
}

INSTANTIATE_TEST_SUITE_P(
    Methods, Slab,
    testing::Values("\"sppm\" \"integer maxdepth\" 3 \"integer photonsperiteration\" 5000 \"float radius\" .1",
                    "\"ppm\" \"integer maxdepth\" 3 \"integer photonsperiteration\" 5000 \"float radius\" .1",
                    "\"lightpath\" \"integer maxdepth\" 3 \"integer photonsperiteration\" 5000"));

TEST(Photons, DispersedEyePathsMeetDispersedPhotons) {
    // The same floor seen through the slab it is lit through: heroes of eye and photon must count once.
    const double r = fresnel(1, 1.52);
    std::string scene = underSlab("\"spectrum eta\" \"glass-BK7\"",
                                  "\"sppm\" \"integer maxdepth\" 5 \"integer photonsperiteration\" 6000 "
                                  "\"float radius\" .1");
    scene.replace(scene.find("LookAt 0 0 .5"), 13, "LookAt 0 0 3");
    scene.replace(scene.find("resolution\" 4"), 13, "resolution\" 16");
    scene.replace(scene.find("yresolution\" 4"), 14, "yresolution\" 16");
    expectRadiance(scene, .5 / piD * std::pow(1 - r, 4), 32, 0.02);
}

// ---- Leaks ----

TEST(Photons, DoNotPassAThinWall) {
    // A bright room and a dark one share a wall of 1e-4; the dark one's side is seen, wall and floor and all.
    const std::string rooms = "Material \"diffuse\" \"rgb reflectance\" [.8 .8 .8]\n"
                              "Shape \"box\" \"point3 pmin\" [-.00005 -1.1 -1.1] \"point3 pmax\" [.00005 1.1 1.1]\n"
                              "AttributeBegin\nTranslate -.2 0 -.8\n"
                              "Shape \"sphere\" \"float radius\" .1\nAttributeEnd\n"
                              "ReverseOrientation\nShape \"box\"  \"point3 pmin\" [-1 -1 -1] \"point3 pmax\" [1 1 1]\n"
                              "LightSource \"point\" \"rgb I\" [1 1 1] \"point3 from\" [-.5 0 .5]\n";
    const std::string camera = "LookAt .9 0 .2  0 0 -.6  0 0 1\nCamera \"perspective\" \"float fov\" 80\n";
    for (const char* integrator :
         {"\"sppm\" \"integer maxdepth\" 6 \"integer photonsperiteration\" 6000 \"float radiuspixels\" 6",
          "\"ppm\" \"integer maxdepth\" 6 \"integer photonsperiteration\" 6000 \"float radiuspixels\" 6",
          "\"sppm\" \"integer maxdepth\" 6 \"integer photonsperiteration\" 20000 \"bool directbyphotons\" true"}) {
        const Measured measured = measure(head(camera, integrator, 32) + rooms, 8, 2);
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(measured.mean[c], 0) << integrator;
    }
    // The bright side is bright, so that there was something to leak.
    const std::string other = "LookAt -.9 0 .2  0 0 -.6  0 0 1\nCamera \"perspective\" \"float fov\" 80\n";
    const Measured bright =
        measure(head(other, "\"sppm\" \"integer maxdepth\" 6 \"integer photonsperiteration\" 20000", 32) + rooms, 8, 2);
    EXPECT_GT(bright.mean[1], 0.05);
}

// ---- Units ----

TEST(Photons, ASceneOfAnotherUnitGivesTheSamePicture) {
    const auto scene = [](double unit) {
        return fmt::format("Scale {0} {0} {0}\n", 1.) +
               head(fmt::format("LookAt 0 {1} {0}  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\n", 4 * unit,
                                2 * unit),
                    "\"sppm\" \"integer maxdepth\" 6", 16) +
               fmt::format(
                   "Scale {0} {0} {0}\nMaterial \"diffuse\"\nRotate -90 1 0 0\nShape \"disk\" \"float radius\" 3\n"
                   "AttributeBegin\nTranslate 0 0 .8\nMaterial \"dielectric\"\nShape \"sphere\" \"float radius\" "
                   ".7\nAttributeEnd\nAreaLightSource \"diffuse\" \"rgb L\" [9 9 9]\nTranslate 1 0 3\nShape "
                   "\"sphere\" \"float radius\" .3\n",
                   unit);
    };
    const auto picture = [&](double unit) {
        const Scene loaded = loadSceneString(scene(unit));
        Film film(loaded.film);
        RenderCounters counters;
        loaded.integrator->addPasses(loaded.world, {0, 8}, film, counters);
        return film.image();
    };
    const Image one = picture(1);
    for (const double unit : {1024., 1. / 1024}) {
        const Image other = picture(unit);
        double difference = 0, sum = 0;
        for (std::size_t i = 0; i < one.pixels.size(); ++i) {
            difference += std::abs(double(one.pixels[i]) - double(other.pixels[i]));
            sum += double(one.pixels[i]);
        }
        EXPECT_LT(difference, 1e-3 * sum) << unit;
    }
}

} // namespace
} // namespace vitrine
