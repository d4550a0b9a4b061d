// Photon mapping holds the photons of one pass: memory that grows from pass to pass would end long renders.
#include "program_test.h"

#include <fmt/format.h>

namespace vitrine::test {
namespace {

struct Photons {
    const char* name;
    std::vector<std::string> settings;
};

class PhotonMemory : public ProgramTest, public testing::WithParamInterface<Photons> {};

/// Bytes that this process holds.
std::uint64_t ownMemory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmRSS:")) return std::stoull(line.substr(6)) * 1024;
    return 0;
}

/// \param side of the picture, in pixels
std::string ballOfGlass(int side) {
    return fmt::format("LookAt 0 1 4  0 .6 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
                       "Film \"rgb\" \"integer xresolution\" {0} \"integer yresolution\" {0}\n"
                       "Integrator \"sppm\" \"integer maxdepth\" 6 \"integer photonsperiteration\" 256\n"
                       "WorldBegin\nLightSource \"point\" \"rgb I\" [ 9 9 9 ] \"point3 from\" [ 1 3 1 ]\n"
                       "Shape \"bilinearmesh\" \"point3 P\" [ -2 0 2  2 0 2  -2 0 -2  2 0 -2 ]\n"
                       "AttributeBegin\n  Translate 0 .6 0\n  Material \"dielectric\"\n"
                       "  Shape \"sphere\" \"float radius\" .6\nAttributeEnd\n",
                       side);
}

constexpr double atMost = 1e7;

TEST_P(PhotonMemory, DoesNotGrowWithPasses) {
    constexpr int side = 32, many = 6000;
    write("tiny.pbrt", ballOfGlass(side));
    const auto peakOf = [&](int passes) {
        Arguments arguments{"render",     "tiny.pbrt", "--passes", std::to_string(passes), "--nthreads", "2", "--stats",
                            "stats.json", "-o",        "tiny.exr", "--progress",           "none"};
        for (const std::string& setting : GetParam().settings)
            arguments.insert(arguments.end(), {"--set", setting});
        if (GetParam().name == std::string("ppm")) arguments.insert(arguments.end(), {"--integrator", "ppm"});
        const ProgramResult result = run(arguments, 300);
        EXPECT_EQ(result.exitCode, 0) << result.describe();
        // Photons did land, and points found them.
        EXPECT_EQ(read("stats.json").find("\"kept\": 0,"), std::string::npos);
        EXPECT_GT(result.peakMemory, ownMemory()) << "the figure would be this process's own";
        return double(result.peakMemory);
    };
    const double afterFew = peakOf(10), afterMany = peakOf(many);
    // A pass's 300 photons are 10 kB: kept, they would be 60 MB, and four bytes a pixel and pass 25 MB. The same run differs
    // by 0.5 MB from time to time, by where threads find their first pages, and by 2.2 MB while much else runs.
    static_assert(4. * side * side * many > 2 * atMost);
    EXPECT_LT(afterMany - afterFew, atMost);
    RecordProperty("megabytes", fmt::format("{:.1f} after 10, {:.1f} after {}", afterFew / 1e6, afterMany / 1e6, many));
}

using LightTracingMemory = ProgramTest;

/// Splats are kept for some 260,000 paths at a time: 150 bytes a path.
TEST_F(LightTracingMemory, DoesNotGrowWithPaths) {
    write("tiny.pbrt", ballOfGlass(16));
    const auto peakOf = [&](int paths) {
        const ProgramResult result =
            run({"render", "tiny.pbrt", "--passes", "1", "--nthreads", "2", "--integrator", "lightpath", "--set",
                 fmt::format("photonsperiteration={}", paths), "-o", "tiny.exr", "--progress", "none"},
                300);
        EXPECT_EQ(result.exitCode, 0) << result.describe();
        EXPECT_GT(result.peakMemory, ownMemory()) << "the figure would be this process's own";
        return double(result.peakMemory);
    };
    const double few = peakOf(1 << 19), many = peakOf(1 << 22);
    EXPECT_LT(many - few, atMost);
    RecordProperty("megabytes", fmt::format("{:.1f} for 2^19, {:.1f} for 2^22", few / 1e6, many / 1e6));
}

INSTANTIATE_TEST_SUITE_P(Methods, PhotonMemory,
                         testing::Values(Photons{"sppm", {}}, Photons{"sppmPerPoint", {"radiusrule=perpoint"}},
                                         Photons{"ppm",
                                                 {"radiusrule=perpoint", "hitpointsperpixel=1", "lookup=kdtree"}}),
                         [](const auto& photons) { return std::string(photons.param.name); });

} // namespace
} // namespace vitrine::test
