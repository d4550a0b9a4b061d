// Every scene of the folder scenes/, rendered small: found by itself, so that a new one is tested from its first day.
#include "program_test.h"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

using namespace test;

/// scenes/NAME/NAME.pbrt, by name.
std::vector<std::string> shippedScenes() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(VITRINE_SOURCE_DIR "/scenes"))
        if (entry.is_directory()) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

class ShippedScene : public ProgramTest, public testing::WithParamInterface<std::string> {
  protected:
    const std::string file_ = VITRINE_SOURCE_DIR "/scenes/" + GetParam() + "/" + GetParam() + ".pbrt";
};

TEST_P(ShippedScene, RendersWithoutAWarning) {
    // Open profiles, solids that touch and exits that were lost are told on standard error.
    succeed({"render", file_, "--quick", "--progress", "none", "-o", "small.exr"});
    const Image picture = readImage(path("small.exr"));
    std::size_t lit = 0;
    for (const float value : picture.pixels) {
        ASSERT_TRUE(std::isfinite(value));
        lit += value > 0;
    }
    EXPECT_GT(lit, picture.pixels.size() / 2);
}

TEST_P(ShippedScene, SaysFirstWhatItShows) {
    std::ifstream in(file_);
    std::string line;
    ASSERT_TRUE(std::getline(in, line)) << file_;
    EXPECT_EQ(line.substr(0, 2), "# ");
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedScene, testing::ValuesIn(shippedScenes()),
                         [](const auto& scene) { return scene.param; });

} // namespace
} // namespace vitrine
