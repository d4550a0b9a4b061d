// Wide pixel filters at the edges of pictures by light tracing: what falls beyond the edge belongs to the pixels within reach.
#include "scene/scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

struct View {
    const char* name;
    const char* camera;
};

class LightTracingEdges : public testing::TestWithParam<View> {};

/// Means of the pixels of one edge of a picture of 8 x 8.
std::array<double, 4> edges(const Image& image) {
    std::array<double, 4> sums{};
    for (int i = 0; i < 8; ++i) {
        const auto green = [&](int x, int y) { return double(image.pixels[std::size_t(3 * (8 * y + x) + 1)]) / 8; };
        sums[0] += green(i, 0);
        sums[1] += green(i, 7);
        sums[2] += green(0, i);
        sums[3] += green(7, i);
    }
    return sums;
}

/// In a ball lit from its middle all is equally bright: I a / (pi r^2).
TEST_P(LightTracingEdges, AreAsBrightAsTheRest) {
    constexpr int runs = 8;
    const double expected = 9 * .5 / (piD * 9);
    for (const char* filter : {"\"gaussian\" \"float sigma\" 1 \"float xradius\" 3", "\"mitchell\"", "\"box\""}) {
        std::vector<std::array<double, 4>> found;
        for (int run = 0; run < runs; ++run) {
            Overrides overrides;
            overrides.seed = std::uint64_t(run);
            const Scene scene = loadSceneString(
                fmt::format("{}\nFilm \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8\nPixelFilter {}\n"
                            "Integrator \"lightpath\" \"integer maxdepth\" 1 \"integer photonsperiteration\" 7000\n"
                            "WorldBegin\nLightSource \"point\" \"rgb I\" [9 9 9]\nReverseOrientation\n"
                            "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5]\n"
                            "Shape \"sphere\" \"float radius\" 3\n",
                            GetParam().camera, filter),
                "<test>", overrides);
            Film film(scene.film);
            RenderCounters counters;
            scene.integrator->addPasses(scene.world, {0, 8}, film, counters);
            found.push_back(edges(film.image()));
        }
        for (std::size_t edge = 0; edge < 4; ++edge) {
            double mean = 0, variance = 0;
            for (const auto& f : found)
                mean += f[edge] / runs;
            for (const auto& f : found)
                variance += (f[edge] - mean) * (f[edge] - mean) / (runs * (runs - 1));
            EXPECT_NEAR(mean, expected, 5 * std::sqrt(variance) + 2e-3 * expected) << filter << ", edge " << edge;
            EXPECT_LT(std::sqrt(variance), 0.05 * expected) << "too noisy for a test";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Cameras, LightTracingEdges,
    testing::Values(View{"pinhole", "LookAt 0 0 1 0 0 3 0 1 0\nCamera \"perspective\" \"float fov\" 80"},
                    View{"lens", "LookAt 0 0 1 0 0 3 0 1 0\nCamera \"perspective\" \"float fov\" 80 "
                                 "\"float lensradius\" .2 \"float focaldistance\" 1"},
                    View{"orthographic", "LookAt 0 0 1 0 0 3 0 1 0\nCamera \"orthographic\""},
                    View{"equalArea", "Camera \"spherical\""},
                    View{"equirectangular", "Camera \"spherical\" \"string mapping\" \"equirectangular\""}),
    [](const auto& c) { return std::string(c.param.name); });

} // namespace
} // namespace vitrine
