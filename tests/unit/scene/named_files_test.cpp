// Files that scenes name: which one is read, and what its values mean.
#include "film/imageio.h"
#include "lights/image_infinite_light.h"
#include "scene_text.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>

#include <fstream>

namespace vitrine {
namespace {

void write(const std::string& path, const std::string& text) {
    std::ofstream(path) << text;
}

TEST(NamedFiles, TheSameTextInTwoFoldersIsTwoSpectra) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a", "b"}) {
        std::filesystem::create_directory(folder.file(name));
        write(folder.file(std::string(name) + "/lamp.pbrt"), "LightSource \"point\" \"spectrum I\" \"lamp.spd\"\n");
    }
    write(folder.file("a/lamp.spd"), "400 1\n500 1\n");
    write(folder.file("b/lamp.spd"), "600 1\n700 1\n");
    write(folder.file("scene.pbrt"), "WorldBegin\nInclude \"a/lamp.pbrt\"\nInclude \"b/lamp.pbrt\"\n");
    const Scene scene = loadScene(folder.file("scene.pbrt"));
    const auto& lights = scene.world.lights.lights();
    ASSERT_EQ(lights.size(), 2u);
    const auto lambda = SampledWavelengths::uniform(0.05f); // 383.5, 501, 618.5, 736
    EXPECT_EQ(lights[0]->power(lambda)[2], 0);
    EXPECT_GT(lights[1]->power(lambda)[2], 0);
}

const Image fourTexels{2, 2, 3, {.8f, .4f, .1f, .8f, .4f, .1f, .8f, .4f, .1f, .8f, .4f, .1f}};

LightPtr skyOf(const std::string& file) {
    const Scene scene = built("WorldBegin\nLightSource \"infinite\" \"string filename\" \"" + file + "\"\n");
    return scene.world.lights.lights().at(0);
}

TEST(NamedFiles, EnvironmentsAreInTheColourSpaceOfTheirFile) {
    const test::TemporaryFolder folder;
    const auto lambda = SampledWavelengths::visible(0.3f);
    for (const char* name : {"srgb", "rec2020", "aces2065-1", "dci-p3"}) {
        ImageInfiniteLight::Parameters parameters;
        parameters.colorSpace = RgbColorSpace::named(name);
        ImageMetadata metadata;
        for (std::size_t i = 0; i < 8; ++i)
            metadata.chromaticities[i] = parameters.colorSpace->chromaticities()[i / 2][int(i % 2)];
        writeImage(folder.file("sky.exr"), fourTexels, metadata);
        const auto expected =
            ImageInfiniteLight::create(Transform(), fourTexels, parameters)->escaped(V3f(0, 0, 1), lambda);
        const SampledSpectrum found = skyOf(folder.file("sky.exr"))->escaped(V3f(0, 0, 1), lambda);
        for (int i = 0; i < spectrumSamples; ++i)
            EXPECT_EQ(found[i], expected[i]) << name;
    }
}

TEST(NamedFiles, EnvironmentsOfAnUnknownColourSpaceKeepTheirColour) {
    const test::TemporaryFolder folder;
    ImageMetadata metadata; // Adobe RGB (1998)
    const float adobe[8] = {.64f, .33f, .21f, .71f, .15f, .06f, .3127f, .329f};
    std::copy_n(adobe, 8, metadata.chromaticities);
    writeImage(folder.file("sky.exr"), fourTexels, metadata);
    const LightPtr sky = skyOf(folder.file("sky.exr"));
    Xyz xyz(0);
    constexpr int n = 500;
    for (int i = 0; i < n; ++i) {
        const auto lambda = SampledWavelengths::uniform((float(i) + 0.5f) / n / 4);
        xyz += sensorXyz(sky->escaped(V3f(0, 0, 1), lambda), lambda) / n;
    }
    // Bruce Lindbloom's matrix of Adobe RGB.
    const Xyz expected(0.5767309f * .8f + 0.1855540f * .4f + 0.1881852f * .1f,
                       0.2973769f * .8f + 0.6273491f * .4f + 0.0752741f * .1f,
                       0.0270343f * .8f + 0.0706872f * .4f + 0.9911085f * .1f);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(xyz[c], expected[c], 0.01f) << c;
}

TEST(NamedFiles, EnvironmentsWithoutRedGreenAndBlueAreRefused) {
    const test::TemporaryFolder folder;
    ImageMetadata metadata;
    metadata.channelNames = {"X", "Y", "Z"};
    writeImage(folder.file("sky.exr"), fourTexels, metadata);
    const Lines errors =
        errorsOf("WorldBegin\nLightSource \"infinite\" \"string filename\" \"" + folder.file("sky.exr") + "\"");
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_THAT(errors[0], testing::HasSubstr("there are no channels R, G and B, but X, Y, Z"));
}

} // namespace
} // namespace vitrine
