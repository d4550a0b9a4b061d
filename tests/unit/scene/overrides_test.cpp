// --integrator, --set and the fingerprint that keeps partial renders of different pictures apart.
#include "scene_text.h"

namespace vitrine {
namespace {

const std::string text = "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8\n"
                         "Integrator \"path\" \"integer maxdepth\" 3\nWorldBegin\nShape \"sphere\"\n";

Overrides set(std::vector<std::string> settings) {
    Overrides overrides;
    overrides.settings = std::move(settings);
    return overrides;
}

TEST(Overrides, SetReachesFilmSamplerAndIntegrator) {
    EXPECT_EQ(built(text, set({"xresolution=5", "pixelsamples=9"})).film.resolution, V2i(5, 8));
    EXPECT_EQ(built(text, set({"pixelsamples=9"})).samplesPerPixel, 9u);
    EXPECT_EQ(built(text, set({"integer xresolution=5"})).film.resolution, V2i(5, 8));
    EXPECT_EQ(built(text, set({"pixelbounds=1,3,2,4"})).film.cropMin, V2i(1, 2));
    EXPECT_EQ(built(text, set({"xresolution=5", "xresolution=6"})).film.resolution, V2i(6, 8)) << "the last one counts";
}

TEST(Overrides, SetRefusesUnknownNamesAndValues) {
    EXPECT_EQ(errorsOf(text, set({"xresolutio=5"})),
              Lines{"--set:1:1: error: no integrator, film or sampler parameter is called \"xresolutio\""});
    EXPECT_EQ(errorsOf(text, set({"float xresolution=5"})).size(), 1u);
    EXPECT_EQ(errorsOf(text, set({"xresolution=0"})).size(), 1u);
    EXPECT_EQ(errorsOf(text, set({"maxdepth=1,2"})).size(), 1u);
    for (const char* bad : {"", "=", "a=", "=3", "maxdepth", "a b c=3"})
        EXPECT_EQ(errorsOf(text, set({bad})).size(), 1u) << bad;
}

TEST(Overrides, IntegratorKeepsWhatItKnowsAndNamesTheRest) {
    Overrides overrides;
    overrides.integrator = "path";
    const Scene scene = built("Integrator \"sppm\" \"integer maxdepth\" 3 \"float radius\" 1\nWorldBegin\n", overrides);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0].message, "integrator \"path\" has no parameter \"radius\": dropped");
    EXPECT_EQ(scene.integratorType, "path");
    EXPECT_EQ(errorsOf("Integrator \"sppm\" \"integer maxdepth\" \"deep\"\nWorldBegin\n", overrides).size(), 1u);
}

TEST(Overrides, SetIsForTheChosenIntegrator) {
    const std::string sppm =
        "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8\n"
        "Integrator \"sppm\" \"float radius\" 1\nWorldBegin\nLightSource \"point\"\nShape \"disk\"\n";
    Overrides overrides = set({"radiuspixels=2", "xresolution=5"});
    EXPECT_EQ(errorsOf(sppm, overrides), Lines{});
    overrides.integrator = "path";
    EXPECT_EQ(errorsOf(sppm, overrides).back(),
              "--set:1:1: error: no integrator, film or sampler parameter is called \"radiuspixels\"");
    overrides.settings = {"xresolution=5"};
    const Scene scene = built(sppm, overrides);
    ASSERT_EQ(scene.warnings.size(), 1u) << "of the scene's radius, not of --set xresolution";
    EXPECT_EQ(scene.warnings[0].message, "integrator \"path\" has no parameter \"radius\": dropped");
}

TEST(Passes, IterationsComeBeforePixelsamplesAndTheCommandLineBeforeBoth) {
    for (const char* integrator : {"sppm", "ppm", "lightpath"}) {
        const std::string scene = "Sampler \"zsobol\" \"integer pixelsamples\" 7\nIntegrator \"" +
                                  std::string(integrator) + "\" \"integer iterations\" ";
        const std::string world = "\nWorldBegin\nLightSource \"point\"\nShape \"disk\"\n";
        EXPECT_EQ(built(scene + "33" + world).samplesPerPixel, 33u) << integrator;
        EXPECT_EQ(built(scene + "33" + world, set({"iterations=12"})).samplesPerPixel, 12u) << integrator;
        Overrides spp;
        spp.samplesPerPixel = 5;
        EXPECT_EQ(built(scene + "33" + world, spp).samplesPerPixel, 5u) << integrator;
        Overrides quick;
        quick.quick = true;
        EXPECT_EQ(built(scene + "33" + world, quick).samplesPerPixel, 1u) << integrator;
        for (const char* bad : {"0", "-1"})
            EXPECT_EQ(errorsOf(scene + bad + world), Lines{"2:" + std::to_string(15 + std::string(integrator).size()) +
                                                           ": error: \"iterations\" must be at least 1"})
                << integrator;
    }
    EXPECT_EQ(errorsOf("Integrator \"path\" \"integer iterations\" 4\nWorldBegin\n").size(), 1u)
        << "the path tracer has samples";
}

TEST(LightSamplers, UniformChoosesAllAlike) {
    for (const char* integrator : {"path", "volpath", "sppm", "ppm", "lightpath"}) {
        const auto share = [&](const std::string& name) {
            const Scene scene = built("Integrator \"" + std::string(integrator) + "\"" + name +
                                      "\nWorldBegin\nShape \"disk\"\nLightSource \"point\" \"rgb I\" [1 1 1]\n"
                                      "LightSource \"point\" \"rgb I\" [99 99 99]\n");
            return scene.world.lights.probability(scene.world.lights.lights()[0].get());
        };
        EXPECT_FLOAT_EQ(share(" \"string lightsampler\" \"uniform\""), 0.5f) << integrator;
        for (const char* byPower : {"", " \"string lightsampler\" \"power\"", " \"string lightsampler\" \"bvh\""})
            EXPECT_NEAR(share(byPower), 0.8 * 0.01 + 0.2 * 0.5, 1e-3) << integrator << byPower;
    }
    EXPECT_EQ(errorsOf("Integrator \"sppm\" \"string lightsampler\" \"best\"\nWorldBegin\n").size(), 1u);
}

TEST(Fingerprint, DependsOnWhatChangesThePicture) {
    const std::uint64_t same = built(text).fingerprint;
    EXPECT_EQ(built(text).fingerprint, same);
    Overrides more;
    more.samplesPerPixel = 1000;
    EXPECT_EQ(built(text, more).fingerprint, same) << "a checkpoint may go on to more samples";

    std::vector<Overrides> others(5);
    others[0].seed = 1;
    others[1].resolution = V2i(9, 8);
    others[2].integrator = "volpath";
    others[3].settings = {"maxdepth=4"};
    others[4].pixelBounds = {1, 8, 0, 8};
    for (const auto& other : others)
        EXPECT_NE(built(text, other).fingerprint, same);
    EXPECT_NE(built(text + "Shape \"disk\"\n").fingerprint, same);
}

TEST(DefaultOutput, IsNamedAfterTheScene) {
    const auto outputOf = [&](const std::string& name) { return loadSceneString(text, name).outputFile; };
    EXPECT_EQ(outputOf("scene.pbrt"), "scene.exr");
    EXPECT_EQ(outputOf("a/b/scene.pbrt.gz"), "scene.exr");
    EXPECT_EQ(outputOf("v1.2.pbrt"), "v1.2.exr");
    EXPECT_EQ(outputOf("v1.3.pbrt"), "v1.3.exr");
    EXPECT_EQ(outputOf("scene"), "scene.exr");
    EXPECT_EQ(outputOf("<stdin>"), "vitrine.exr");
    EXPECT_EQ(outputOf(".pbrt"), "vitrine.exr");
}

} // namespace
} // namespace vitrine
