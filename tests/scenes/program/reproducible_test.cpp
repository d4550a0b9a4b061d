// The same picture, bit for bit, however it comes about: any number of threads, in parts, after a kill.
#include "program_test.h"

#include <fmt/format.h>

#include <csignal>
#include <thread>

namespace vitrine {
namespace {

using namespace test;
using namespace std::chrono_literals;

const std::string source = VITRINE_SOURCE_DIR;
const std::string caustic = source + "/tests/images/references/caustic.pbrt";

struct SceneCase {
    std::string name, file, resolution, spp;
    std::vector<std::string> flags{};
};

SceneCase photons(const std::string& name, const std::vector<std::string>& flags) {
    return {name, caustic, "40x33", "3", flags};
}

void PrintTo(const SceneCase& c, std::ostream* out) {
    *out << c.name;
}

class Threads : public ProgramTest, public testing::WithParamInterface<SceneCase> {};

TEST_P(Threads, GiveTheSameBytes) {
    const SceneCase& scene = GetParam();
    const auto render = [&](const char* flag, const std::string& value, const std::string& output) {
        Arguments all{"render", scene.file, "--resolution", scene.resolution, "--spp", scene.spp, "-o",
                      output,   flag,       value};
        all.insert(all.end(), scene.flags.begin(), scene.flags.end());
        succeed(all);
    };
    for (const char* threads : {"1", "2", "3", "7"})
        render("--nthreads", threads, fmt::format("{}.exr", threads));
    const std::string one = read("1.exr");
    EXPECT_GT(one.size(), 1000u);
    for (const char* threads : {"2", "3", "7"})
        EXPECT_EQ(read(fmt::format("{}.exr", threads)), one) << threads;
    // The comparison would notice a difference.
    render("--seed", "1", "seed.exr");
    EXPECT_NE(read("seed.exr"), one);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Threads,
                         testing::Values(SceneCase{"vase", source + "/scenes/vase/vase.pbrt", "94x60", "4"},
                                         SceneCase{"goblet", source + "/scenes/goblet/goblet.pbrt", "64x64", "4"},
                                         SceneCase{"caustic", caustic, "64x64", "8"}),
                         [](const auto& scene) { return scene.param.name; });

INSTANTIATE_TEST_SUITE_P(Photons, Threads,
                         testing::Values(photons("sppm", {"--integrator", "sppm"}),
                                         photons("perpoint", {"--integrator", "sppm", "--set", "radiusrule=perpoint"}),
                                         photons("ppm", {"--integrator", "ppm"}),
                                         photons("kdtree", {"--integrator", "ppm", "--set", "lookup=kdtree", "--set",
                                                            "radiusrule=perpoint"}),
                                         photons("lightpath", {"--integrator", "lightpath"})),
                         [](const auto& scene) { return scene.param.name; });

class Parts : public ProgramTest {
  protected:
    const Arguments render{"render", caustic, "--resolution", "48x40"};

    Arguments with(const Arguments& more) const {
        Arguments all = render;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    void SetUp() override { succeed(with({"--spp", "8", "-o", "whole.exr"})); }
};

/// Photon mapping: passes are independent with one radius for all, and not with a radius a pixel.
class PhotonParts : public ProgramTest {
  protected:
    Arguments with(const Arguments& more, const char* rule) const {
        Arguments all{"render",       caustic, "--resolution", "40x33",
                      "--integrator", "sppm",  "--set",        std::string("radiusrule=") + rule};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};

TEST_F(PhotonParts, WithOneRadiusMergeInAnyOrder) {
    const auto render = [&](const Arguments& more) { succeed(with(more, "shared")); };
    render({"--passes", "8", "-o", "whole.exr"});
    render({"--passes", "0:1", "--partial", "a.part"});
    render({"--passes", "1:6", "--partial", "b.part"});
    render({"--passes", "6:8", "--partial", "c.part"});
    succeed({"merge", "a.part", "b.part", "c.part", "-o", "abc.exr"});
    succeed({"merge", "c.part", "a.part", "b.part", "-o", "cab.exr"});
    EXPECT_EQ(readImage(path("abc.exr")).pixels, readImage(path("whole.exr")).pixels);
    EXPECT_EQ(read("cab.exr"), read("abc.exr"));
}

TEST_F(PhotonParts, WithARadiusAPixelGoOnWhereTheyStopped) {
    const auto render = [&](const Arguments& more) { succeed(with(more, "perpoint")); };
    render({"--passes", "8", "-o", "whole.exr"});
    render({"--passes", "3", "-o", "early.exr", "--checkpoint", "state"});
    render({"--passes", "3:5", "-o", "later.exr", "--checkpoint", "state", "--resume"});
    render({"--passes", "8", "-o", "late.exr", "--checkpoint", "state", "--resume"});
    EXPECT_EQ(read("late.exr"), read("whole.exr"));
    EXPECT_NE(read("later.exr"), read("whole.exr"));
}

TEST_F(PhotonParts, WithARadiusAPixelCannotStandAlone) {
    const std::string begin =
        "vitrine: passes 4:8 cannot be rendered on their own: with these settings each pass builds "
        "on those before it, and ";
    fail(with({"--passes", "4:8", "-o", "x.exr"}, "perpoint"), 1, begin + "there are none");
    fail(with({"--passes", "0:4", "--partial", "x.part"}, "perpoint"), 1,
         "vitrine: --partial: with these settings each pass builds on those before it, so that parts cannot be merged: "
         "use --checkpoint");
    succeed(with({"--passes", "3", "-o", "early.exr", "--checkpoint", "state"}, "perpoint"));
    fail(with({"--passes", "4:8", "-o", "x.exr", "--checkpoint", "state", "--resume"}, "perpoint"), 1,
         begin + "the checkpoint holds 0:3");
    EXPECT_FALSE(exists("x.exr"));
    fail({"merge", "state", "state", "-o", "x.exr"}, 1,
         "vitrine: state cannot be merged: each of its passes builds on those before it. Go on with it by --resume "
         "--checkpoint");
    succeed({"merge", "state", "-o", "x.exr"}); // a picture of the passes so far
    EXPECT_EQ(readImage(path("x.exr")).pixels, readImage(path("early.exr")).pixels);
}

TEST_F(Parts, MergeToTheWhole) {
    succeed(with({"--passes", "0:3", "--partial", "a.part"}));
    succeed(with({"--passes", "3:8", "--partial", "b.part"}));
    EXPECT_FALSE(exists("caustic.exr")) << "with --partial no picture is written";
    succeed({"merge", "a.part", "b.part", "-o", "ab.exr"});
    succeed({"merge", "b.part", "a.part", "-o", "ba.exr"});
    EXPECT_EQ(read("ab.exr"), read("ba.exr"));
    EXPECT_EQ(readImage(path("ab.exr")).pixels, readImage(path("whole.exr")).pixels);
}

TEST_F(Parts, MergeByTrees) {
    for (int i = 0; i < 8; ++i)
        succeed(with({"--passes", fmt::format("{}:{}", i, i + 1), "--partial", fmt::format("{}.part", i)}));
    succeed({"merge", "7.part", "1.part", "4.part", "--partial", "x.part"});
    succeed({"merge", "5.part", "0.part", "x.part", "2.part", "6.part", "3.part", "-o", "tree.exr"});
    EXPECT_EQ(readImage(path("tree.exr")).pixels, readImage(path("whole.exr")).pixels);
}

TEST_F(Parts, ThatDoNotBelongTogetherAreRefused) {
    succeed(with({"--passes", "0:3", "--partial", "a.part"}));
    succeed(with({"--passes", "2:4", "--partial", "b.part"}));
    succeed(with({"--passes", "3:4", "--seed", "5", "--partial", "c.part"}));
    fail({"merge", "a.part", "b.part", "-o", "x.exr"}, 1, "vitrine: b.part: passes 2:4 overlap 0:3 that came before");
    fail({"merge", "a.part", "c.part", "-o", "x.exr"}, 1,
         "vitrine: a.part and c.part are of different scenes or settings");
    fail({"merge", "a.part"}, 1, "vitrine: merge: give --outfile or --partial");
    fail({"merge", "a.part", "no.part", "-o", "x.exr"}, 2, "vitrine: no.part: cannot be opened");
    const std::string whole = read("a.part");
    write("short.part", whole.substr(0, whole.size() - 100));
    fail({"merge", "short.part", "-o", "x.exr"}, 2, "vitrine: short.part: the file is cut short or damaged");
    std::string flipped = whole;
    flipped[whole.size() / 2] = char(flipped[whole.size() / 2] ^ 1);
    write("flipped.part", flipped);
    fail({"merge", "flipped.part", "-o", "x.exr"}, 2,
         "vitrine: flipped.part: the file is damaged (its checksum differs)");
    write("other.part", "not sums");
    fail({"merge", "other.part", "-o", "x.exr"}, 2, "vitrine: other.part: is not a file of partial sums");
    EXPECT_FALSE(exists("x.exr"));
}

TEST_F(Parts, ResumeToMoreSamples) {
    succeed(with({"--spp", "3", "-o", "early.exr", "--checkpoint", "state"}));
    succeed(with({"--spp", "8", "-o", "late.exr", "--checkpoint", "state", "--resume"}));
    EXPECT_EQ(read("late.exr"), read("whole.exr"));
    succeed(with({"--spp", "8", "-o", "again.exr", "--checkpoint", "state", "--resume"}));
    EXPECT_EQ(read("again.exr"), read("whole.exr"));
}

TEST_F(Parts, ResumeWithoutACheckpointStartsAfresh) {
    succeed(with({"--spp", "8", "-o", "fresh.exr", "--checkpoint", "none", "--resume"}));
    EXPECT_EQ(read("fresh.exr"), read("whole.exr"));
    EXPECT_TRUE(exists("none"));
}

TEST_F(Parts, ResumeOfAnotherSceneIsRefused) {
    succeed(with({"--spp", "2", "-o", "a.exr", "--checkpoint", "state"}));
    fail(with({"--spp", "4", "-o", "b.exr", "--checkpoint", "state", "--resume", "--seed", "3"}), 1,
         "vitrine: state is a checkpoint of another scene or of other settings");
    fail(with({"--spp", "4", "-o", "b.exr", "--checkpoint", "state", "--resume", "--set", "maxdepth=3"}), 1,
         "vitrine: state is a checkpoint of another scene or of other settings");
    write("state", "garbage, and more of it");
    fail(with({"--spp", "4", "-o", "b.exr", "--checkpoint", "state", "--resume"}), 2,
         "vitrine: state: is not a file of partial sums");
}

/// A render that takes some seconds and saves its state after every chunk of passes.
class Stopped : public ProgramTest {
  protected:
    const Arguments render{"render", caustic, "--resolution", "64x64", "--spp", "256", "--nthreads", "2"};

    Arguments with(const Arguments& more) const {
        Arguments all = render;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    std::unique_ptr<RunningProgram> start(const Arguments& more) const {
        return std::make_unique<RunningProgram>(with(more), RunSettings{.folder = path(""), .timeout = 60});
    }
    /// Until there is such a file, or the program ends.
    void waitFor(RunningProgram& program, const std::string& file) const {
        while (!exists(file) && !program.ended())
            std::this_thread::sleep_for(1ms);
    }
    /// Until the program notes SIGINT, which is before it reads the scene.
    void waitUntilCaught(RunningProgram& program) const {
        while (!program.catches(SIGINT) && !program.ended())
            std::this_thread::sleep_for(1ms);
    }
    std::string uninterrupted() const {
        succeed(with({"-o", "whole.exr"}));
        return read("whole.exr");
    }
};

TEST_F(Stopped, KilledAndResumedIsTheSame) {
    auto program = start({"-o", "killed.exr", "--checkpoint", "state", "--checkpoint-every", "0"});
    waitFor(*program, "state");
    program->send(SIGKILL);
    const ProgramResult killed = program->wait();
    ASSERT_EQ(killed.signal, SIGKILL) << killed.describe();
    EXPECT_FALSE(exists("killed.exr"));
    succeed(with({"-o", "killed.exr", "--checkpoint", "state", "--resume"}));
    EXPECT_EQ(read("killed.exr"), uninterrupted());
}

TEST_F(Stopped, PhotonsWithARadiusAPixelTooWhenKilled) {
    const Arguments perPoint{"-o",           "killed.exr", "--integrator", "sppm", "--set", "radiusrule=perpoint",
                             "--checkpoint", "state",      "--resume"};
    Arguments often = perPoint;
    often.insert(often.end(), {"--checkpoint-every", "0"});
    auto program = start(often);
    waitFor(*program, "state");
    program->send(SIGKILL);
    const ProgramResult killed = program->wait();
    ASSERT_EQ(killed.signal, SIGKILL) << killed.describe();
    succeed(with(perPoint));
    const std::string resumed = read("killed.exr");
    std::filesystem::remove(path("state"));
    succeed(with(perPoint));
    EXPECT_EQ(resumed, read("killed.exr"));
}

TEST_F(Stopped, CtrlCKeepsThePictureAndResumes) {
    auto program = start({"-o", "stopped.exr"});
    waitUntilCaught(*program);
    program->send(SIGINT);
    const ProgramResult stopped = program->wait();
    ASSERT_EQ(stopped.exitCode, 3) << stopped.describe();
    EXPECT_NE(stopped.err.find("passes; go on with --resume --checkpoint stopped.exr.checkpoint\n"), std::string::npos)
        << stopped.err;
    EXPECT_EQ(readImage(path("stopped.exr")).width, 64);
    ASSERT_TRUE(exists("stopped.exr.checkpoint"));
    const std::string whole = uninterrupted();
    EXPECT_NE(read("stopped.exr"), whole) << "the render was over before it was stopped: it must take longer";
    succeed(with({"-o", "stopped.exr", "--resume"}));
    EXPECT_EQ(read("stopped.exr"), whole);
}

TEST_F(Stopped, SigtermIsLikeCtrlC) {
    auto program = start({"-o", "stopped.exr", "--checkpoint", "state", "--checkpoint-every", "0"});
    waitFor(*program, "state");
    program->send(SIGTERM);
    EXPECT_EQ(program->wait().exitCode, 3);
    EXPECT_TRUE(exists("stopped.exr"));
    EXPECT_FALSE(exists("stopped.exr.checkpoint")) << "the state has its own file";
}

TEST_F(Stopped, KillsNeverLeaveABrokenCheckpoint) {
    // Large and with few samples, so that the program spends much of its time in writing checkpoints.
    const Arguments large{"render",
                          caustic,
                          "--resolution",
                          "300x300",
                          "--spp",
                          "12",
                          "--nthreads",
                          "2",
                          "-o",
                          "large.exr",
                          "--checkpoint",
                          "state",
                          "--checkpoint-every",
                          "0",
                          "--resume",
                          "--set",
                          "maxdepth=1"};
    int checked = 0;
    for (int i = 0; i < 8; ++i) {
        RunningProgram program(large, {.folder = path(""), .timeout = 60});
        waitUntilCaught(program);
        waitFor(program, "state");
        // Each time in another phase of computing and writing.
        std::this_thread::sleep_for(i * 17ms);
        program.send(SIGKILL);
        if (program.wait().signal != SIGKILL) break;
        succeed({"merge", "state", "-o", "merged.exr"});
        ++checked;
    }
    EXPECT_GT(checked, 3);
    succeed(large);
    const std::string resumed = read("large.exr");
    std::filesystem::remove(path("state"));
    succeed(large);
    EXPECT_EQ(resumed, read("large.exr"));
}

} // namespace
} // namespace vitrine
