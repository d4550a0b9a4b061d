// Texture "imagemap": from RGB to spectra.
#include "scene_text.h"
#include "support/image_files.h"
#include "support/temporary_folder.h"
#include "support/texture_points.h"
#include "texture_text.h"

#include <fmt/format.h>

namespace vitrine {
namespace {

constexpr int side = 8;

/// All combinations of components, the largest 1.
std::vector<float> colours() {
    std::vector<float> values;
    for (int i = 0; i < side * side; ++i)
        for (const int c : {i % 4, i / 4 % 4, i / 16})
            values.push_back(float(c) / 3);
    return values;
}

Rgb colour(int i) {
    const auto values = colours();
    return {values[std::size_t(3 * i)], values[std::size_t(3 * i + 1)], values[std::size_t(3 * i + 2)]};
}

TexturePoint texel(int i) {
    return uvAt({(float(i % side) + 0.5f) / side, 1 - (float(i / side) + 0.5f) / side});
}

class ImageSpectra : public testing::Test {
  protected:
    /// \param primaries as EXR gives them
    std::string write(const std::vector<float>& values, const float* primaries = nullptr, int channels = 3) {
        OIIO::ImageSpec spec(side, side, channels, OIIO::TypeFloat);
        if (primaries) spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), primaries);
        test::writeFile(folder_.file("a.exr"), spec, values);
        return folder_.file("a.exr");
    }
    static std::string texture(const std::string& path, const std::string& more = "") {
        return fmt::format("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"{}\" {}\n", path, more);
    }
    test::TemporaryFolder folder_;
};

void expectSame(const SampledSpectrum& found, const SampledSpectrum& expected, const Rgb& rgb,
                float tolerance = 1e-5f) {
    for (int i = 0; i < spectrumSamples; ++i)
        EXPECT_NEAR(found[i], expected[i], tolerance * (1 + expected[i])) << rgb;
}

TEST_F(ImageSpectra, AreTheSceneTextsOwnOfTheSameColours) {
    Textures textures(texture(write(colours())));
    const RgbColorSpace& space = RgbColorSpace::srgb();
    const SampledWavelengths lambda = Textures::lambda();
    for (int i = 0; i < side * side; ++i) {
        const Rgb rgb = colour(i);
        expectSame(textures.spectrum("t", SpectrumUse::Albedo, texel(i)), RgbAlbedoSpectrum(space, rgb).sample(lambda),
                   rgb, 1e-3f);
        expectSame(textures.spectrum("t", SpectrumUse::Unbounded, texel(i)),
                   RgbUnboundedSpectrum(space, rgb).sample(lambda), rgb, 1e-3f);
        expectSame(textures.spectrum("t", SpectrumUse::Illuminant, texel(i)),
                   RgbIlluminantSpectrum(space, rgb).sample(lambda), rgb, 1e-3f);
    }
}

/// Under the colour space's white a surface of this texture shows the image's colours again.
TEST_F(ImageSpectra, ComeBackAsTheirColours) {
    Textures textures(texture(write(colours())));
    const RgbColorSpace& space = RgbColorSpace::srgb();
    for (int i = 0; i < side * side; ++i) {
        Xyz sum(0);
        constexpr int samples = 64;
        for (int k = 0; k < samples; ++k) {
            const auto lambda = SampledWavelengths::uniform((float(k) + 0.5f) / samples);
            const SampledSpectrum white = space.illuminant().sample(lambda);
            sum += sensorXyz(textures.spectrum("t", SpectrumUse::Albedo, texel(i), lambda) * white, lambda);
        }
        const Rgb back = space.fromXyz(sum / (float(samples) * cieYIntegral));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(back[c], colour(i)[c], 0.01) << colour(i);
    }
}

TEST_F(ImageSpectra, AlbedosAreClampedOthersNot) {
    std::vector<float> bright = colours();
    for (float& value : bright)
        value *= 3;
    Textures textures(texture(write(bright)));
    const RgbColorSpace& space = RgbColorSpace::srgb();
    for (int i = 1; i < side * side; ++i) {
        const Rgb rgb = colour(i) * 3.f;
        const Rgb clamped(std::min(rgb.x, 1.f), std::min(rgb.y, 1.f), std::min(rgb.z, 1.f));
        expectSame(textures.spectrum("t", SpectrumUse::Albedo, texel(i)),
                   RgbAlbedoSpectrum(space, clamped).sample(Textures::lambda()), rgb, 1e-3f);
        expectSame(textures.spectrum("t", SpectrumUse::Unbounded, texel(i)),
                   RgbUnboundedSpectrum(space, rgb).sample(Textures::lambda()), rgb, 1e-3f);
    }
}

TEST_F(ImageSpectra, ScaleInvertAndNegativeValues) {
    std::vector<float> values(side * side * 3, -0.5f);
    EXPECT_EQ(Textures(texture(write(values))).spectrum("t", SpectrumUse::Unbounded, texel(0))[0], 0);
    values.assign(values.size(), 0.25f);
    const auto grey = [&](const std::string& parameters) {
        return Textures(texture(write(values), parameters)).spectrum("t", SpectrumUse::Albedo, texel(3))[1];
    };
    EXPECT_NEAR(grey(""), 0.25, 1e-6);
    EXPECT_NEAR(grey("\"float scale\" 3"), 0.75, 1e-6);
    EXPECT_NEAR(grey("\"float scale\" 3 \"bool invert\" true"), 0.25, 1e-6);
    EXPECT_NEAR(grey("\"float scale\" 5 \"bool invert\" true"), 0, 1e-6);
}

TEST_F(ImageSpectra, GreyImagesAreGrey) {
    const std::string path = write(std::vector<float>(side * side, 0.3f), nullptr, 1);
    const SampledSpectrum value = Textures(texture(path)).spectrum("t", SpectrumUse::Albedo, texel(0));
    for (int i = 0; i < spectrumSamples; ++i)
        EXPECT_NEAR(value[i], 0.3, 1e-6);
}

TEST_F(ImageSpectra, OfOtherPrimaries) {
    const float rec2020[8] = {0.708f, 0.292f, 0.170f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.3290f};
    Textures textures(texture(write(colours(), rec2020)));
    const RgbColorSpace& space = *RgbColorSpace::named("rec2020");
    for (int i = 0; i < side * side; i += 5)
        expectSame(textures.spectrum("t", SpectrumUse::Albedo, texel(i)),
                   RgbAlbedoSpectrum(space, colour(i)).sample(Textures::lambda()), colour(i), 1e-3f);
    // Of no name: the colours are those of sRGB where it has them. White is white.
    const float odd[8] = {0.64f, 0.33f, 0.28f, 0.62f, 0.15f, 0.06f, 0.3127f, 0.3290f};
    const SampledSpectrum white =
        Textures(texture(write(colours(), odd))).spectrum("t", SpectrumUse::Unbounded, texel(63));
    for (int i = 0; i < spectrumSamples; ++i)
        EXPECT_NEAR(white[i], 1, 2e-2);
}

} // namespace
} // namespace vitrine
