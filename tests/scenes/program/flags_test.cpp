// The flags of `vitrine render`.
#include "program_test.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace vitrine {
namespace {

using namespace test;
using Json = nlohmann::json;

class Flags : public ProgramTest {
  protected:
    void SetUp() override { writeScene(); }

    Arguments render(const std::string& picture, const Arguments& more = {}) const {
        Arguments all{"render", "scene.pbrt", "-o", picture};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    Image picture(const Arguments& more = {}) const {
        succeed(render("picture.exr", more));
        return readImage(path("picture.exr"));
    }
    Json stats(const Arguments& more) const {
        Arguments all = render("picture.exr", more);
        all.insert(all.end(), {"--stats", "stats.json"});
        succeed(all);
        return Json::parse(read("stats.json"));
    }
    static double mean(const Image& image) {
        double sum = 0;
        for (const float x : image.pixels)
            sum += double(x);
        return sum / double(image.pixels.size());
    }
};

TEST_F(Flags, DefaultOutputIsNamedAfterTheScene) {
    succeed({"render", "scene.pbrt"});
    EXPECT_EQ(readImage(path("scene.exr")).width, 24);
    std::filesystem::create_directory(path("sub"));
    std::filesystem::rename(path("scene.pbrt"), path("sub/other.v2.pbrt"));
    succeed({"render", "sub/other.v2.pbrt"});
    EXPECT_TRUE(exists("other.exr") || exists("other.v2.exr"));
}

TEST_F(Flags, MayStandBeforeTheScene) {
    succeed({"render", "-o", "a.exr", "--set", "maxdepth=3", "scene.pbrt", "-o", "b.exr"});
    EXPECT_EQ(read("a.exr"), read("b.exr"));
}

TEST_F(Flags, SetIsLikeTheSceneItself) {
    const Image set = picture({"--set", "maxdepth=1", "--set", "pixelsamples=3", "--set", "xresolution=20"});
    EXPECT_EQ(set.width, 20);
    EXPECT_NE(set.pixels, picture({"--set", "pixelsamples=3", "--set", "xresolution=20"}).pixels);
    write("scene.pbrt", [this] {
        std::string text = read("scene.pbrt");
        for (const auto& [from, to] :
             {std::pair{"maxdepth\" 8", "maxdepth\" 1"}, {"samples\" 4", "samples\" 3"}, {"24", "20"}})
            text.replace(text.find(from), std::string(from).size(), to);
        return text;
    }());
    EXPECT_EQ(set.pixels, picture().pixels);
}

TEST_F(Flags, SetRefusesWhatIsWrong) {
    fail(render("x.exr", {"--set", "maxdept=1"}), 1,
         "--set:1:1: error: no integrator, film or sampler parameter is called \"maxdept\"\n"
         "    maxdept=1\n"
         "    ^^^^^^^\n"
         "    did you mean \"maxdepth\"?");
    fail(render("x.exr", {"--set", "maxdepth=deep"}), 1,
         "--set:1:10: error: \"integer maxdepth\": expected an integer, got \"deep\"\n"
         "    maxdepth=deep\n"
         "             ^^^^");
    fail(render("x.exr", {"--set", "maxdepth=-1"}), 1,
         "--set:1:10: error: \"maxdepth\" must not be negative\n"
         "    maxdepth=-1\n"
         "             ^^");
    EXPECT_EQ(run(render("x.exr", {"--set", "maxdepth"})).exitCode, 1);
    EXPECT_FALSE(exists("x.exr"));
}

TEST_F(Flags, IntegratorReplacesTheTypeAndNamesWhatItDrops) {
    EXPECT_EQ(picture({"--integrator", "volpath"}).pixels, picture().pixels);
    writeScene("Integrator \"sppm\" \"integer maxdepth\" 8 \"float radius\" .1\n");
    const ProgramResult result = run(render("dropped.exr", {"--integrator", "path"}));
    EXPECT_EQ(result.exitCode, 0) << result.describe();
    EXPECT_EQ(result.err, "scene.pbrt:6:40: warning: integrator \"path\" has no parameter \"radius\": dropped\n"
                          "    Integrator \"sppm\" \"integer maxdepth\" 8 \"float radius\" .1\n"
                          "                                           ^^^^^^^^^^^^^^\n");
    EXPECT_EQ(readImage(path("dropped.exr")).pixels, (writeScene(), picture()).pixels);
    fail(render("x.exr", {"--integrator", "pth"}), 1, "error: unknown integrator \"pth\"\n    did you mean \"path\"?");
    fail(render("x.exr", {"--integrator", "bdpt"}), 1, "error: integrator \"bdpt\" is not yet supported");
    // A parameter of the command line must be one of the chosen integrator's.
    EXPECT_EQ(run(render("x.exr", {"--integrator", "path", "--set", "radius=1"})).exitCode, 1);
    succeed(render("sppm.exr", {"--integrator", "sppm", "--set", "radius=1"}));
}

TEST_F(Flags, SeedChangesThePictureButNotItsMean) {
    const Image zero = picture({"--seed", "0", "--spp", "64"}), one = picture({"--seed", "1", "--spp", "64"});
    EXPECT_EQ(zero.pixels, picture({"--spp", "64"}).pixels);
    EXPECT_NE(zero.pixels, one.pixels);
    EXPECT_NEAR(mean(zero) / mean(one), 1, 0.02);
    EXPECT_EQ(picture({"--seed", "18446744073709551615"}).width, 24) << "64 bits";
}

TEST_F(Flags, CropIsTheSamePartOfThePicture) {
    const Image whole = picture();
    struct Case {
        Arguments flags;
        int x0, x1, y0, y1;
    };
    for (const auto& [flags, x0, x1, y0, y1] :
         {Case{{"--pixelbounds", "3,17,2,9"}, 3, 17, 2, 9}, Case{{"--cropwindow", "0.25,0.75,0.5,1"}, 6, 18, 8, 16},
          Case{{"--cropwindow", "0,.1,0,.1"}, 0, 3, 0, 2}, Case{{"--pixelbounds", "20,99,-5,99"}, 20, 24, 0, 16}}) {
        succeed(render("crop.exr", flags));
        ImageMetadata metadata;
        const Image crop = readImage(path("crop.exr"), &metadata);
        ASSERT_EQ(crop.width, x1 - x0) << flags[1];
        ASSERT_EQ(crop.height, y1 - y0) << flags[1];
        EXPECT_EQ(metadata.offset, V2i(x0, y0));
        EXPECT_EQ(metadata.fullResolution, V2i(24, 16));
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x)
                for (int c = 0; c < 3; ++c)
                    ASSERT_EQ(crop.pixels[std::size_t(((y - y0) * crop.width + x - x0) * 3 + c)],
                              whole.pixels[std::size_t((y * 24 + x) * 3 + c)])
                        << flags[1] << " at " << x << "," << y;
    }
}

TEST_F(Flags, ResolutionAndQuick) {
    const Image small = picture({"--resolution", "10x7"});
    EXPECT_EQ(small.width, 10);
    EXPECT_EQ(small.height, 7);
    const Json quick = stats({"--quick"});
    EXPECT_EQ(quick.at("width"), 6);
    EXPECT_EQ(quick.at("height"), 4);
    EXPECT_EQ(quick.at("passes"), 1);
    EXPECT_EQ(stats({"--quick", "--spp", "3"}).at("passes"), 3);
}

TEST_F(Flags, PassesAndSppAreTheSame) {
    EXPECT_EQ(picture({"--spp", "5"}).pixels, picture({"--passes", "5"}).pixels);
    EXPECT_EQ(picture({"--spp", "5"}).pixels, picture({"--passes", "0:5"}).pixels);
    EXPECT_EQ(stats({"--passes", "2:5"}).at("passes"), 3);
}

TEST_F(Flags, StatsOfPhotons) {
    const Json photons =
        stats({"--integrator", "sppm", "--spp", "3", "--set", "photonsperiteration=500"}).at("photons");
    EXPECT_EQ(photons.at("paths"), 3 * 500);
    EXPECT_GT(photons.at("pathsPerSecond"), 0);
    EXPECT_GT(photons.at("landedShare"), 0);
    EXPECT_LE(photons.at("landedShare"), 1);
    EXPECT_GT(photons.at("gatherPoints"), 0);
    EXPECT_GE(photons.at("foundPerPoint"), 0);
    EXPECT_GT(photons.at("bytes"), 0);
    EXPECT_GT(photons.at("smallestRadius"), 0);
    EXPECT_LT(photons.at("smallestRadius"), photons.at("largestRadius"));
    EXPECT_EQ(stats({"--integrator", "lightpath", "--set", "photonsperiteration=500"}).at("photons").at("paths"),
              4 * 500);
    EXPECT_FALSE(stats({}).contains("photons"));
}

TEST_F(Flags, PhotonsThatNobodySeesAreTold) {
    // The lamp is in a closed box behind the camera.
    write("scene.pbrt", "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8\n"
                        "Integrator \"sppm\" \"integer photonsperiteration\" 1000\nWorldBegin\n"
                        "Shape \"plane\" \"normal n\" [ 0 0 1 ] \"float d\" 5\n"
                        "LightSource \"point\" \"point3 from\" [ 0 0 -11 ]\n"
                        "Shape \"box\" \"point3 pmin\" [ -1 -1 -12 ] \"point3 pmax\" [ 1 1 -10 ]\n");
    const ProgramResult result = run({"render", "scene.pbrt", "--spp", "2", "-o", "dark.exr"});
    EXPECT_EQ(result.exitCode, 0) << result.describe();
    EXPECT_EQ(result.err.find("vitrine: warning: photons never reach what the camera sees: of "), 0u) << result.err;
}

TEST_F(Flags, PhotonsAreNotMissedWhereAllLightIsDirect) {
    // A floor that the lamp sees all of; the few photons are those of a small ball far off.
    write("scene.pbrt", "LookAt 0 0 1  0 0 0  0 1 0\nCamera \"perspective\"\n"
                        "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8\n"
                        "Integrator \"sppm\" \"integer photonsperiteration\" 4000\nWorldBegin\n"
                        "LightSource \"point\" \"point3 from\" [ 0 0 2 ]\nShape \"disk\" \"float radius\" 10\n"
                        "Translate 9 0 .5\nShape \"sphere\" \"float radius\" .3\n");
    succeed({"render", "scene.pbrt", "--spp", "2", "-o", "lit.exr", "--progress", "none", "--stats", "stats.json"});
    const Json photons = Json::parse(read("stats.json")).at("photons");
    EXPECT_GT(photons.at("kept"), 0);
    EXPECT_EQ(photons.at("foundPerPoint"), 0);
}

TEST_F(Flags, PhotonIntegratorsSayWhatTheyNeed) {
    write("scene.pbrt", "Integrator \"sppm\"\nWorldBegin\nShape \"sphere\"\n");
    fail({"info", "scene.pbrt"}, 1,
         "scene.pbrt:1:12: error: photon mapping needs a light: this scene has none\n"
         "    Integrator \"sppm\"\n               ^^^^^^");
    fail({"render", "scene.pbrt", "--integrator", "ppm"}, 1,
         "error: --integrator ppm: photon mapping needs a light: this scene has none");
}

TEST_F(Flags, PhotonIntegratorsHaveASeedOfTheirOwn) {
    const Arguments sppm{"--integrator", "sppm", "--spp", "2"};
    const auto with = [&](const Arguments& more) {
        Arguments all = sppm;
        all.insert(all.end(), more.begin(), more.end());
        return picture(all).pixels;
    };
    const auto plain = with({});
    const auto seven = with({"--seed", "7"});
    EXPECT_NE(plain, seven);
    writeScene("Integrator \"sppm\" \"integer maxdepth\" 8 \"integer seed\" 7\n");
    EXPECT_EQ(with({}), seven);
    EXPECT_EQ(with({"--seed", "0"}), plain) << "the command line comes first";
}

TEST_F(Flags, StatsAreTrue) {
    const Json s = stats({"--spp", "6"});
    EXPECT_EQ(s.at("scene"), "scene.pbrt");
    EXPECT_EQ(s.at("integrator"), "path");
    EXPECT_EQ(s.at("width"), 24);
    EXPECT_EQ(s.at("height"), 16);
    EXPECT_EQ(s.at("passes"), 6);
    EXPECT_EQ(s.at("samples"), 6 * 24 * 16);
    EXPECT_EQ(s.at("badSamples"), 0);
    EXPECT_GT(s.at("seconds"), 0);
    EXPECT_NEAR(s.at("samplesPerSecond").get<double>() * s.at("seconds").get<double>(), 6 * 24 * 16, 1);
    EXPECT_GT(s.at("casterBytes"), 0);
    EXPECT_GT(s.at("peakMemoryBytes"), 1000000);
    EXPECT_GT(s.at("estimatedRelMSE"), 0);
}

TEST_F(Flags, TimeAndErrorStopTheRender) {
    const Json timed = stats({"--time", "0.3"});
    EXPECT_GE(timed.at("seconds"), 0.3);
    EXPECT_LT(timed.at("seconds"), 10);
    EXPECT_GT(timed.at("passes"), 4) << "more than the scene's own";
    EXPECT_EQ(stats({"--time", "1000", "--spp", "2"}).at("passes"), 2);

    const Json coarse = stats({"--error", "0.02"}), fine = stats({"--error", "0.001"});
    EXPECT_LE(coarse.at("estimatedRelMSE"), 0.02);
    EXPECT_LE(fine.at("estimatedRelMSE"), 0.001);
    EXPECT_LT(coarse.at("passes"), fine.at("passes"));
}

TEST_F(Flags, ProgressAsJson) {
    const ProgramResult result = run(render("x.exr", {"--progress", "json", "--spp", "3000", "--time", "1"}));
    EXPECT_EQ(result.exitCode, 0) << result.describe();
    std::istringstream lines(result.err);
    std::vector<Json> reports;
    for (std::string line; std::getline(lines, line);)
        reports.push_back(Json::parse(line));
    ASSERT_GE(reports.size(), 2u) << result.err;
    double before = 0;
    for (const Json& report : reports) {
        const double fraction = report.at("fraction");
        EXPECT_GE(fraction, before);
        before = fraction;
        if (&report != &reports.back()) {
            EXPECT_LT(fraction, 1);
        }
        EXPECT_GE(report.at("elapsed"), 0);
        EXPECT_GE(report.at("samples"), 0);
    }
    EXPECT_EQ(before, 1);
    EXPECT_EQ(reports.back().at("samples"), reports.back().at("passes").get<int>() * 24 * 16);
}

TEST_F(Flags, ProgressBar) {
    const ProgramResult result = run(render("x.exr", {"--progress", "bar"}));
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.err.find(" 100%"), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find(" 100%"), result.err.rfind(" 100%")) << "only at the end";
    EXPECT_EQ(result.err.back(), '\n');
    for (const char* style : {"auto", "none"})
        succeed(render("x.exr", {"--progress", style}));
}

TEST_F(Flags, SeveralOutputsOfEveryFormat) {
    Arguments all = render("x.exr", {"--spp", "16"});
    for (const char* name : {"x.png", "x.ppm", "x.hdr", "x.jpg", "x.pfm"})
        all.insert(all.end(), {"--outfile", name});
    succeed(all);
    const Image exr = readImage(path("x.exr"));
    ASSERT_EQ(exr.width, 24);
    EXPECT_EQ(readImage(path("x.pfm")).pixels, exr.pixels);
    const auto worst = [&](const std::string& name, auto&& limit) {
        const Image other = readImage(path(name));
        ASSERT_EQ(other.pixels.size(), exr.pixels.size()) << name;
        for (std::size_t i = 0; i < exr.pixels.size(); ++i) {
            const double wanted = double(exr.pixels[i]);
            EXPECT_NEAR(double(other.pixels[i]), std::min(wanted, name == "x.hdr" ? 1e9 : 1.), limit(wanted)) << name;
        }
    };
    // 8 bits after the sRGB curve, whose slope in linear values is at most 2.4 near white.
    worst("x.png", [](double) { return 2.4 / 255; });
    worst("x.ppm", [](double) { return 2.4 / 255; });
    // 8 bits below the largest channel.
    worst("x.hdr", [](double) { return 1. / 100; });
    worst("x.jpg", [](double) { return .15; });
}

TEST_F(Flags, ThatAreNotYetSupportedAreRefusedByName) {
    fail(render("x.exr", {"--denoise"}), 1, "vitrine: --denoise is not yet supported");
    fail(render("x.exr", {"--aov", "albedo"}), 1, "vitrine: --aov is not yet supported");
    fail(render("x.exr", {"--display-server", "localhost:14158"}), 1, "vitrine: --display-server is not yet supported");
    EXPECT_FALSE(exists("x.exr"));
}

TEST_F(Flags, ThatAreWrong) {
    const auto refused = [&](const Arguments& flags, const std::string& message) {
        SCOPED_TRACE(fmt::format("{} {}", flags[0], flags.size() > 1 ? flags[1] : ""));
        fail(render("x.exr", flags), 1, message);
    };
    const std::string help = "\nRun \"vitrine render --help\" for its arguments.";
    refused({"--spp", "0"}, "vitrine: --spp 0: an empty range, or past 4294967296");
    refused({"--spp", "-3"}, "vitrine: --spp takes a whole number, not \"-3\"");
    refused({"--spp", "3.5"}, "vitrine: --spp takes a whole number, not \"3.5\"");
    refused({"--spp", "99999999999999999999999"},
            "vitrine: --spp takes a whole number, not \"99999999999999999999999\"");
    refused({"--passes", "5:5"}, "vitrine: --passes 5:5: an empty range, or past 4294967296");
    refused({"--passes", "5:3"}, "vitrine: --passes 5:3: an empty range, or past 4294967296");
    refused({"--passes", "a:b"}, "vitrine: --passes takes a whole number, not \"a\"");
    refused({"--spp", "3", "--passes", "3"}, "vitrine: --spp and --passes are the same: give one");
    refused({"--seed", "x"}, "vitrine: --seed takes a whole number, not \"x\"");
    refused({"--resolution", "3"}, "vitrine: --resolution takes 2 numbers separated by 'x', not \"3\"");
    refused({"--resolution", "3x"}, "vitrine: --resolution takes 2 numbers separated by 'x', not \"3x\"");
    refused({"--pixelbounds", "1,2,3"}, "vitrine: --pixelbounds takes 4 numbers separated by ',', not \"1,2,3\"");
    refused({"--time", "-1"}, "vitrine: --time takes seconds");
    refused({"--time", "nan"}, "vitrine: --time takes seconds");
    refused({"--error", "-1"}, "vitrine: --error takes a relMSE");
    refused({"--nthreads", "-1"}, "vitrine: --nthreads takes a count of threads");
    refused({"--progress", "loud"}, "vitrine: --progress takes auto, bar, json or none");
    refused({"--sed", "3"}, "vitrine: unknown argument \"--sed\"\n    did you mean \"--seed\"?" + help);
    refused({"--resolutoin=3x4"},
            "vitrine: unknown argument \"--resolutoin=3x4\"\n    did you mean \"--resolution\"?" + help);
    refused({"more.pbrt"}, "vitrine: unknown argument \"more.pbrt\"" + help);
    fail({"render"}, 1, "vitrine: scene is required" + help);
    fail({"rendr", "scene.pbrt"}, 1,
         "vitrine: unknown command \"rendr\"\n    did you mean \"render\"?\nRun \"vitrine --help\" for the commands.");
    EXPECT_FALSE(exists("x.exr"));
}

TEST_F(Flags, PartialTakesNoOtherFiles) {
    fail({"render", "scene.pbrt", "--partial", "p", "-o", "x.exr"}, 1,
         "vitrine: --partial writes sums and no picture: leave --outfile out");
    fail({"render", "scene.pbrt", "--partial", "p", "--resume"}, 1,
         "vitrine: --partial is its own checkpoint: leave --checkpoint and --resume out");
}

} // namespace
} // namespace vitrine
