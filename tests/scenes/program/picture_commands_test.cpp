// vitrine convert and vitrine diff, run as a user runs them.
#include "film/imageio.h"
#include "film/srgb.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace vitrine {
namespace {

using test::ProgramResult;
using test::runVitrine;
using testing::HasSubstr;

/// A grey ramp, 16 x 16.
Image ramp(float scale) {
    Image image{16, 16, 3, {}};
    for (int i = 0; i < 256; ++i)
        image.pixels.insert(image.pixels.end(), 3, scale * float(i) / 255);
    return image;
}

class PictureCommands : public testing::Test {
  protected:
    PictureCommands() {
        writeImage(folder.file("dark.exr"), ramp(1));
        writeImage(folder.file("bright.exr"), ramp(2));
    }
    test::TemporaryFolder folder;
};

TEST_F(PictureCommands, ConvertExposesAndToneMaps) {
    const ProgramResult plain =
        runVitrine({"convert", folder.file("dark.exr"), folder.file("a.png"), "--exposure", "1"});
    EXPECT_EQ(plain.exitCode, 0) << plain.describe();
    const Image a = readImage(folder.file("a.png"));
    for (int i = 0; i < 256; ++i)
        EXPECT_EQ(a.pixels[std::size_t(3 * i)], float(linearFromSrgb(srgbByte(2 * (float(i) / 255)) / 255.))) << i;

    const ProgramResult mapped = runVitrine(
        {"convert", folder.file("dark.exr"), folder.file("b.exr"), "--exposure=-1", "--tonemap", "reinhard"});
    EXPECT_EQ(mapped.exitCode, 0) << mapped.describe();
    const Image b = readImage(folder.file("b.exr"));
    for (int i = 0; i < 256; ++i) {
        const float x = float(i) / 510;
        EXPECT_NEAR(b.pixels[std::size_t(3 * i + 2)], x / (1 + x), 1e-6f) << i;
    }
}

TEST_F(PictureCommands, ConvertNamesWhatIsWrong) {
    const auto run = [&](const std::string& in, const std::string& out, const std::string& toneMap) {
        return runVitrine({"convert", folder.file(in), folder.file(out), "--tonemap", toneMap});
    };
    const ProgramResult noInput = run("none.exr", "a.png", "none");
    EXPECT_EQ(noInput.exitCode, 2) << noInput.describe();
    EXPECT_THAT(noInput.err, HasSubstr("none.exr: cannot be read: no such file"));
    const ProgramResult noFormat = run("dark.exr", "a.pgn", "none");
    EXPECT_EQ(noFormat.exitCode, 2) << noFormat.describe();
    EXPECT_THAT(noFormat.err, HasSubstr("did you mean \"png\"?"));
    const ProgramResult noMap = run("dark.exr", "a.png", "film");
    EXPECT_EQ(noMap.exitCode, 1) << noMap.describe();
    EXPECT_THAT(noMap.err, HasSubstr("one of none, reinhard, filmic"));
    EXPECT_FALSE(std::filesystem::exists(folder.file("a.png")));
}

TEST_F(PictureCommands, DiffSpeaksTextAndJson) {
    const std::string dark = folder.file("dark.exr"), bright = folder.file("bright.exr");
    const ProgramResult text = runVitrine({"diff", bright, dark});
    EXPECT_EQ(text.exitCode, 0) << text.describe();
    EXPECT_THAT(text.out, HasSubstr("mean ratio  2.000000 2.000000 2.000000"));

    const ProgramResult json = runVitrine({"diff", bright, dark, "--json"});
    EXPECT_EQ(json.exitCode, 0) << json.describe();
    const auto values = nlohmann::json::parse(json.out);
    // (2x - x)^2 / (x^2 + 0.01) over the ramp; of 256 pixels none is dropped.
    double relMse = 0, mse = 0;
    for (int i = 0; i < 256; ++i) {
        const double x = i / 255.;
        relMse += x * x / (x * x + 0.01) / 256;
        mse += x * x / 256;
    }
    EXPECT_NEAR(values["relMSE"].get<double>(), relMse, 1e-6);
    EXPECT_NEAR(values["PSNR"].get<double>(), -10 * std::log10(mse), 1e-5);
    EXPECT_EQ(values["pixels"], 256);

    const auto equal = nlohmann::json::parse(runVitrine({"diff", dark, dark, "--json"}).out);
    EXPECT_EQ(equal["relMSE"], 0);
    EXPECT_TRUE(equal["PSNR"].is_null());
    EXPECT_EQ(equal["SSIM"], 1);
}

TEST_F(PictureCommands, DiffTakesVarianceAndWritesAHeatMap) {
    const std::string dark = folder.file("dark.exr"), bright = folder.file("bright.exr"), map = folder.file("heat.png");
    const Image constant{16, 16, 3, std::vector<float>(16 * 16 * 3, 0.01f)};
    writeImage(folder.file("variance.exr"), constant);
    const auto run = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"diff", bright, dark, "--json"});
        return nlohmann::json::parse(runVitrine(more).out)["relMSE"].get<double>();
    };
    double own = 0;
    for (int i = 0; i < 256; ++i)
        own += 0.01 / (sqr(i / 255.) + 0.01) / 256;
    EXPECT_NEAR(run({"--out", map}) - run({"--variance", folder.file("variance.exr")}), own, 1e-6);
    const Image heat = readImage(map);
    EXPECT_EQ(heat.at(15, 15, 0), 1); // twice as bright
    EXPECT_EQ(heat.at(15, 15, 2), 0);
}

TEST_F(PictureCommands, ValuesThatAreNotFiniteAreTold) {
    Image broken = readImage(folder.file("dark.exr"));
    for (int i = 0; i < 12; ++i)
        broken.pixels[std::size_t(i)] = std::nanf("");
    writeImage(folder.file("broken.exr"), broken);
    const std::string dark = folder.file("dark.exr"), nan = folder.file("broken.exr"), png = folder.file("a.png");
    const std::string warning = "vitrine: warning: the pictures are not comparable: 4 pixels of " + nan + " and 0 of " +
                                dark + " are not finite\n";
    const ProgramResult text = runVitrine({"diff", nan, dark});
    EXPECT_EQ(text.exitCode, 0) << text.describe();
    EXPECT_THAT(text.out, HasSubstr("relMSE      none: not all pixels are finite (0 over those that are in both)\n"));
    EXPECT_EQ(text.err, warning);
    const ProgramResult json = runVitrine({"diff", nan, dark, "--json"});
    EXPECT_TRUE(nlohmann::json::parse(json.out)["relMSE"].is_null());
    EXPECT_EQ(nlohmann::json::parse(json.out)["relMSEOfFinite"], 0);
    EXPECT_EQ(json.err, warning);
    const ProgramResult converted = runVitrine({"convert", nan, png});
    EXPECT_EQ(converted.exitCode, 0) << converted.describe();
    EXPECT_EQ(converted.err, "vitrine: warning: " + nan + ": 12 values are not finite\n");
    EXPECT_EQ(runVitrine({"convert", dark, png}).err, "");
}

TEST_F(PictureCommands, DiffRefusesPicturesOfDifferentSize) {
    writeImage(folder.file("small.exr"), Image{2, 2, 3, std::vector<float>(12)});
    const ProgramResult result = runVitrine({"diff", folder.file("small.exr"), folder.file("dark.exr")});
    EXPECT_EQ(result.exitCode, 1) << result.describe();
    EXPECT_THAT(result.err, HasSubstr("differ in size: 2 x 2 pixels of 3 channels against 16 x 16 of 3"));
}

} // namespace
} // namespace vitrine
