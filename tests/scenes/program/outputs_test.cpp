// What was rendered is never lost because something else cannot be written.
#include "program_test.h"

#include <nlohmann/json.hpp>

#include <csignal>
#include <sys/wait.h>
#include <thread>

namespace vitrine {
namespace {

using namespace test;
using namespace std::chrono_literals;

class Outputs : public ProgramTest {
  protected:
    void SetUp() override {
        writeScene();
        // Can be opened and is full.
        std::filesystem::create_symlink("/dev/full", path("full.exr"));
    }
    /// In the test's folder, "vitrine" being the program. Returns the exit code of the last command.
    int shell(const std::string& command) const {
        const int status =
            std::system(("cd '" + path("") + "' && vitrine() { '" VITRINE_PROGRAM "' \"$@\"; }; " + command).c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    Arguments render(const Arguments& more) const {
        Arguments all{"render", "scene.pbrt", "--spp", "2"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    const std::string full = "cannot be written: No space left on device";
};

TEST_F(Outputs, ProgressThatNobodyCanSeeStopsNothing) {
    for (const std::string style : {"json", "bar"}) {
        const std::string run = "vitrine render scene.pbrt --spp 2 --progress " + style + " -o ";
        EXPECT_EQ(shell(run + "full_" + style + ".exr 2> /dev/full"), 0) << style;
        EXPECT_EQ(shell(run + "shut_" + style + ".exr 2>&-"), 0) << style;
        // A reader that is gone before the first line.
        EXPECT_EQ(
            shell("{ sleep 0.2; " + run + "gone_" + style + ".exr; echo $? > code; } 2>&1 | true; exit $(cat code)"), 0)
            << style;
        for (const std::string how : {"full_", "shut_", "gone_"})
            EXPECT_EQ(readImage(path(how + style + ".exr")).width, 24) << how << style;
    }
}

TEST_F(Outputs, ACheckpointThatFailsCostsNoPicture) {
    fail(render({"-o", "a.exr", "--checkpoint", "/dev/full"}), 2, "vitrine: /dev/full: " + full);
    EXPECT_EQ(readImage(path("a.exr")).width, 24);
    const ProgramResult result = run(render({"-o", "b.exr", "--checkpoint", "/dev/full", "--checkpoint-every", "0"}));
    EXPECT_EQ(result.exitCode, 2) << result.describe();
    EXPECT_EQ(result.err, "vitrine: warning: /dev/full: " + full +
                              "; the render goes on and tries again\nvitrine: /dev/full: " + full + "\n")
        << "warned of once";
    EXPECT_EQ(read("b.exr"), read("a.exr"));
}

TEST_F(Outputs, OneThatFailsDoesNotTakeTheOthersAlong) {
    std::filesystem::create_symlink("/dev/full", path("full.png"));
    const ProgramResult result = run(
        render({"-o", "full.exr", "-o", "a.exr", "-o", "full.png", "--stats", "stats.json", "--checkpoint", "state"}));
    EXPECT_EQ(result.exitCode, 2) << result.describe();
    EXPECT_NE(result.err.find("vitrine: full.exr: " + full + "\n"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("vitrine: full.png: " + full + "\n"), std::string::npos) << result.err;
    EXPECT_EQ(readImage(path("a.exr")).width, 24);
    EXPECT_EQ(nlohmann::json::parse(read("stats.json")).at("passes"), 2);
    EXPECT_TRUE(exists("state"));
}

TEST_F(Outputs, CtrlCSavesTheStateThoughThePictureFails) {
    RunningProgram program({"render", "scene.pbrt", "--spp", "1000000", "-o", "full.exr"},
                           {.folder = path(""), .timeout = 60});
    while (!program.catches(SIGINT) && !program.ended())
        std::this_thread::sleep_for(1ms);
    program.send(SIGINT);
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.exitCode, 2) << result.describe();
    EXPECT_EQ(result.err.find("vitrine: full.exr: " + full + "\nvitrine: stopped after "), 0u) << result.err;
    EXPECT_TRUE(exists("full.exr.checkpoint"));
}

TEST_F(Outputs, AreCheckedBeforeRendering) {
    for (const std::string flag : {"--partial", "--stats", "--checkpoint"}) {
        const ProgramResult result = run({"render", "scene.pbrt", "--spp", "1000000000", flag, "no/file"}, 20);
        EXPECT_EQ(result.exitCode, 2) << result.describe();
        EXPECT_EQ(result.err, "vitrine: no/file: there is no folder " + path("no") + "\n");
        EXPECT_EQ(run({"render", "scene.pbrt", "--spp", "1000000000", flag, "/proc/file"}, 20).exitCode, 2) << flag;
    }
    EXPECT_FALSE(exists("scene.exr"));
}

TEST_F(Outputs, StandardOutputThatIsFullIsAnError) {
    succeed(render({"-o", "a.exr"}));
    for (const std::string command :
         {"info scene.pbrt", "info scene.pbrt --json", "diff a.exr a.exr", "--help", "render --help", "--version"}) {
        EXPECT_EQ(shell("vitrine " + command + " > /dev/full 2> err"), 2) << command;
        EXPECT_EQ(read("err"), "vitrine: standard output: " + full + "\n") << command;
        EXPECT_EQ(shell("vitrine " + command + " >&- 2> err"), 2) << command;
        EXPECT_EQ(shell("vitrine " + command + " > out 2> err"), 0) << command;
        EXPECT_EQ(read("err"), "");
    }
}

TEST_F(Outputs, ASceneFromStandardInputMakesVitrineExr) {
    EXPECT_EQ(shell("vitrine render - --spp 1 < scene.pbrt"), 0);
    EXPECT_EQ(readImage(path("vitrine.exr")).width, 24);
    EXPECT_FALSE(exists("<stdin>.exr"));
}

} // namespace
} // namespace vitrine
