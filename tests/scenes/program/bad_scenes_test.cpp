// Whatever stands in a scene file: a clear error or a picture, soon.
#include "film/film.h"
#include "isolated.h"
#include "mutations.h"
#include "sample_scenes.h"
#include "scene/scene.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <fstream>

namespace vitrine {
namespace {

using namespace test;

constexpr double secondsPerScene = 10;
constexpr char built = 'b', refused = 'r', rendered = 'p', renderedWithHoles = 'h';

/// An error must say what is wrong and where; others than these two are faults of the program.
void checkClear(const SceneError& error) {
    if (error.diagnostics().empty()) throw std::logic_error("an error without a diagnostic");
    for (const Diagnostic& d : error.diagnostics()) {
        if (d.message.empty()) throw std::logic_error("an error without a message");
        if (!d.place) throw std::logic_error("an error without a place: " + d.message);
    }
}

/// False when samples were not finite or too large, so that they were left out and counted.
bool renderOnce(const Scene& scene) {
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    Film film(scene.film);
    RenderCounters counters;
    scene.integrator->addPasses(scene.world, {0, 2}, film, counters);
    for (const float value : film.image().pixels)
        if (!std::isfinite(value)) throw std::logic_error("a pixel is not finite");
    return film.badSamples() == 0;
}

/// What becomes of a text: refused, built, or (when `render`) a picture of a few pixels.
char fateOf(const std::string& text, const std::string& folder, bool render) {
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    Overrides overrides;
    if (render) overrides.resolution = V2i(3, 2);
    try {
        const Scene scene = loadSceneString(text, "scene.pbrt", overrides, folder);
        if (!render) return built;
        return renderOnce(scene) ? rendered : renderedWithHoles;
    } catch (const SceneError& error) {
        checkClear(error);
        return refused;
    } catch (const FileError&) {
        return refused;
    }
}

class BadScenes : public testing::Test {
  protected:
    void SetUp() override { writeSampleFiles(folder_.file("")); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_.file(name), std::ios::binary) << text;
        return folder_.file(name);
    }

    TemporaryFolder folder_;
};

TEST_F(BadScenes, TheSamplesThemselvesAreFine) {
    std::vector<SampleScene> scenes = sampleScenes();
    scenes.push_back({"whole", wholeSample()});
    for (unsigned n = 0; n < 60; ++n)
        scenes.push_back({fmt::format("header {}", n), sampleHeader(n)});
    const auto results = runIsolated(scenes.size(), secondsPerScene, [&](std::uint64_t i) {
        loadSceneString(scenes[i].text, scenes[i].name, {}, folder_.file(""));
        return built;
    });
    EXPECT_TRUE(results.failures.empty()) << results.describe();
}

TEST_F(BadScenes, EveryPrefix) {
    std::vector<SampleScene> scenes = sampleScenes();
    scenes.push_back({"whole", wholeSample()});
    for (const auto& [name, text] : scenes) {
        const auto results = runIsolated(text.size(), secondsPerScene, [&](std::uint64_t size) {
            const char fate = fateOf(text.substr(0, size), folder_.file(""), false);
            if (fate == built && size <= text.find("WorldBegin")) throw std::logic_error("a world without WorldBegin");
            return fate;
        });
        EXPECT_TRUE(results.failures.empty()) << name << ": " << results.describe();
        EXPECT_GT(results.outcomes.count(built), 0u) << name;
        EXPECT_GT(results.outcomes.count(refused), 0u) << name;
    }
}

TEST_F(BadScenes, AHundredThousandMutations) {
    std::vector<SampleScene> scenes = sampleScenes();
    constexpr std::uint64_t count = 100000;
    const auto results = runIsolated(count, secondsPerScene, [&](std::uint64_t number) {
        const std::string& text = scenes[number % scenes.size()].text;
        return fateOf(mutated(text, number), folder_.file(""), number / scenes.size() % 3 == 0);
    });
    EXPECT_TRUE(results.failures.empty()) << results.describe();
    // Neither all good nor all bad: both ways are tried.
    for (const char fate : {built, refused, rendered})
        EXPECT_GT(results.outcomes.contains(fate) ? results.outcomes.at(fate) : 0, count / 50) << results.describe();
}

TEST_F(BadScenes, MutationsOfTheWhole) {
    const std::string text = wholeSample();
    const auto results = runIsolated(2000, secondsPerScene, [&](std::uint64_t number) {
        return fateOf(mutated(text, 1000000 + number), folder_.file(""), true);
    });
    EXPECT_TRUE(results.failures.empty()) << results.describe();
}

/// Exit code 0, or 1 with a message that names the scene's place, or 2 with one that names a file.
void expectClear(const ProgramResult& result, const std::string& text) {
    if (result.exitCode == 0 && !result.timedOut) return;
    EXPECT_TRUE(result.exitCode == 1 || result.exitCode == 2) << result.describe() << text;
    EXPECT_NE(result.err.find(result.exitCode == 1 ? "scene.pbrt:" : "vitrine: "), std::string::npos)
        << result.describe() << text;
}

TEST_F(BadScenes, ThroughInfo) {
    const auto scenes = sampleScenes();
    for (std::uint64_t i = 0; i < 100; ++i) {
        const std::string& whole = scenes[i % scenes.size()].text;
        const std::string text = i % 4 == 0 ? whole.substr(0, i * whole.size() / 100) : mutated(whole, 2000000 + i);
        write("scene.pbrt", text);
        expectClear(runVitrine({"info", "scene.pbrt"}, {.folder = folder_.file(""), .timeout = secondsPerScene}), text);
    }
}

TEST_F(BadScenes, ThroughRender) {
    const auto scenes = sampleScenes();
    int pictures = 0;
    for (std::uint64_t i = 0; i < 50; ++i) {
        const std::string& whole = scenes[i % scenes.size()].text;
        const std::string text = i % 4 == 0 ? whole.substr(0, i * whole.size() / 50) : mutated(whole, 3000000 + i);
        write("scene.pbrt", text);
        const std::string picture = fmt::format("{}.exr", i);
        const auto result = runVitrine({"render", "scene.pbrt", "--resolution", "4x3", "--spp", "2", "-o", picture},
                                       {.folder = folder_.file(""), .timeout = secondsPerScene});
        expectClear(result, text);
        ASSERT_EQ(std::ifstream(folder_.file(picture)).good(), result.exitCode == 0) << result.describe() << text;
        if (result.exitCode != 0) continue;
        ++pictures;
        for (const float value : readImage(folder_.file(picture)).pixels)
            ASSERT_TRUE(std::isfinite(value)) << text;
    }
    EXPECT_GT(pictures, 5);
}

} // namespace
} // namespace vitrine
