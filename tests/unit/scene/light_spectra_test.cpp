// Every way to give a light its spectrum, with every light; and what of pbrt-v4's lights is refused.
#include "scene_text.h"
#include "spectrum/colorspace.h"

namespace vitrine {
namespace {

struct Light {
    std::string directive, spectrum, more;
    /// Divides lumens into the unit of the spectrum's parameter.
    double unit;
};
const Light lights[] = {{"LightSource \"point\"", "I", "", 4 * piD},
                        {"LightSource \"spot\"", "I", " \"float coneangle\" 90 \"float conedeltaangle\" 0", 2 * piD},
                        {"LightSource \"distant\"", "L", "", 0},
                        {"LightSource \"infinite\"", "L", "", 0},
                        {"AreaLightSource \"diffuse\"", "L", "", piD * 2 * piD* piD}};

/// Luminous flux of the one light over the one sphere.
double lumens(const Light& light, const std::string& parameters) {
    const Scene scene = built("WorldBegin\n" + light.directive + light.more + parameters +
                              "\nShape \"sphere\" \"float radius\" " + std::to_string(std::sqrt(piD / 2)) + "\n");
    const auto& all = scene.world.lights.lights();
    EXPECT_EQ(all.size(), 1u);
    double y = 0;
    constexpr int strata = 471; // whole nanometres: where the emission is tabulated
    for (int nm = 0; nm < strata; ++nm) {
        const auto lambda = SampledWavelengths::uniform((float(nm) + 0.5f) / strata / spectrumSamples);
        y += double((all[0]->power(lambda) * cieY().sample(lambda)).average()) * 470 / strata;
    }
    return y;
}

/// One and the same white of the colour space has a luminance of one; of each other spectrum pbrt-v4 makes as much.
const char* const spectra[] = {"\"rgb %\" [1 1 1]",
                               "\"blackbody %\" 3000",
                               "\"blackbody %\" 9000",
                               "\"spectrum %\" \"stdillum-A\"",
                               "\"spectrum %\" \"stdillum-D65\"",
                               "\"spectrum %\" \"illum-acesD60\"",
                               "\"spectrum %\" [300 2 900 2]",
                               "\"spectrum %\" [400 0 550 5 700 0]"};

std::string given(const char* spectrum, const Light& light) {
    std::string text = spectrum;
    return " " + text.replace(text.find('%'), 1, light.spectrum);
}

TEST(LightSpectra, EveryOneMakesAsMuchLight) {
    for (const Light& light : lights) {
        const double white = lumens(light, "");
        EXPECT_GT(white, 0) << light.directive;
        if (light.unit > 0) {
            EXPECT_NEAR(white, light.unit, 5e-3 * light.unit) << light.directive;
        }
        for (const char* spectrum : spectra) {
            EXPECT_NEAR(lumens(light, given(spectrum, light)), white, 5e-3 * white) << light.directive << spectrum;
            EXPECT_NEAR(lumens(light, given(spectrum, light) + " \"float scale\" 3"), 3 * white, 15e-3 * white)
                << light.directive << spectrum;
        }
    }
}

TEST(LightSpectra, PowerAndIlluminanceStandForTheirAmounts) {
    for (const Light& light : lights)
        for (const char* spectrum : spectra) {
            const bool hasPower = light.unit > 0;
            const double ten = lumens(light, given(spectrum, light) +
                                                 (hasPower ? " \"float power\" 10" : " \"float illuminance\" 10"));
            if (hasPower) {
                EXPECT_NEAR(ten, 10, 0.05) << light.directive << spectrum;
            } else {
                const double one = lumens(light, given(spectrum, light) + " \"float illuminance\" 1");
                EXPECT_NEAR(ten, 10 * one, 0.02 * ten) << light.directive << spectrum;
            }
        }
}

TEST(LightSpectra, WhatIsRefusedIsNamed) {
    const auto errors = [](const std::string& light) { return errorsOf("WorldBegin\n" + light); };
    EXPECT_EQ(errors("LightSource \"goniometric\" \"string filename\" \"a.exr\"\n"),
              Lines{"2:13: error: light \"goniometric\" is not yet supported"});
    EXPECT_EQ(errors("LightSource \"projection\" \"string filename\" \"a.exr\"\n"),
              Lines{"2:13: error: light \"projection\" is not yet supported"});
    EXPECT_EQ(errors("LightSource \"infinite\" \"point3 portal\" [0 0 0  1 0 0  1 1 0  0 1 0]\n"),
              Lines{"2:24: error: parameter \"portal\" is not yet supported"});
    EXPECT_EQ(errors("AreaLightSource \"diffuse\" \"string filename\" \"a.exr\"\nShape \"sphere\"\n"),
              Lines{"2:27: error: parameter \"filename\" is not yet supported"});
}

TEST(WorldBuilder, AWarningOfPhotonsPointsAtNoDirectiveWhenTheCommandLineChoseThem) {
    Overrides overrides;
    overrides.integrator = "sppm";
    const auto told =
        built("Integrator \"path\"\nWorldBegin\nLightSource \"distant\"\nShape \"plane\"\n", overrides).warnings;
    ASSERT_EQ(told.size(), 1u);
    EXPECT_TRUE(told[0].message.starts_with("photons of lights at infinity"));
    EXPECT_FALSE(told[0].place);
}

} // namespace
} // namespace vitrine
