// Photons and light paths from lamps that lie in solids, whole or in part.
#include "known_values.h"
#include "render_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

std::string head(const std::string& camera, const std::string& integrator) {
    return camera +
           "\nFilm \"rgb\" \"integer xresolution\" 4 \"integer yresolution\" 4\nSampler \"independent\"\n"
           "PixelFilter \"box\"\nIntegrator " +
           integrator + "\nWorldBegin\n";
}

class LampInGlass : public testing::TestWithParam<const char*> {};

/// A lamp in the middle of a ball of tinted glass over a floor: all light leaves the ball straight, and is weaker by what
/// the ball absorbs and reflects. Of what is reflected nothing comes back: paths are bounded to ball and floor.
TEST_P(LampInGlass, ShinesThroughIt) {
    constexpr double radius = .5, absorption = 3, lampRadius = .01;
    const std::string camera =
        "LookAt 0 0 1 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.2 .2 -.2 .2]\n";
    // Towards the edges of the view, r from its middle, the floor gets less as (1 + r^2 / 4)^-1.5.
    constexpr double mean = 1 - 1.5 * (2 * .2 * .2 / 3) / 4;
    const std::string point = "LightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [0 0 2]\n";
    const std::string ball = fmt::format("AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [{0} {0} {0}]\n"
                                         "Translate 0 0 2\nShape \"sphere\" \"float radius\" {1}\nAttributeEnd\n",
                                         3 / (M_PI * lampRadius * lampRadius), lampRadius);
    for (const char* priority : {"", "\"integer priority\" 1"})
        for (const std::string& lamp : {point, ball}) {
            // From a small ball light leaves its surface, at a cosine of 2/3 in the mean.
            const double depth = radius - (lamp == ball ? lampRadius * 2 / 3 : 0);
            const double expected = .5 / M_PI * 3 / 4 * mean * (1 - fresnel(1, 1.5)) * std::exp(-absorption * depth);
            const Measured measured = measure(
                head(camera, GetParam() + std::string(" \"integer maxdepth\" 2 \"integer photonsperiteration\" 5000")) +
                    lamp + "Material \"diffuse\" \"spectrum reflectance\" [300 .5 900 .5]\nShape \"disk\"\n" +
                    fmt::format("Material \"dielectric\" \"float eta\" 1.5 {} \"spectrum absorption\" [300 {} 900 {}]\n"
                                "Translate 0 0 2\nShape \"sphere\" \"float radius\" {}\n",
                                priority, absorption, absorption, radius),
                8);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(measured.mean[c], expected, 5 * measured.error[c] + 5e-3 * expected) << priority << lamp;
                EXPECT_LT(measured.error[c], 0.05 * expected) << "too noisy for a test";
            }
        }
}

/// A lamp of which one part in 1600 is in a ball of glass: rays that start there must know it, else they come out of a
/// solid that they were never in.
TEST_P(LampInGlass, RarePartsCount) {
    RenderCounters counters;
    renderText(head("LookAt 0 0 1 0 0 0 0 1 0\nCamera \"orthographic\"\n",
                    GetParam() + std::string(" \"integer maxdepth\" 2 \"integer photonsperiteration\" 40000")) +
                   "Material \"diffuse\"\nShape \"disk\" \"float radius\" 3\n"
                   "AttributeBegin\nAreaLightSource \"diffuse\"\nTranslate 0 0 2\nRotate 180 1 0 0\n"
                   "Shape \"disk\" \"float radius\" 2\nAttributeEnd\n"
                   "Material \"dielectric\" \"integer priority\" 1\nTranslate .7 .3 2\n"
                   "Shape \"sphere\" \"float radius\" .05\n",
               1, 4, counters);
    EXPECT_EQ(counters.photonPaths, 4 * 40000u);
    EXPECT_EQ(counters.lostExits, 0u);
}

INSTANTIATE_TEST_SUITE_P(Methods, LampInGlass,
                         testing::Values("\"sppm\" \"float radius\" .1",
                                         "\"sppm\" \"float radius\" .1 \"bool directbyphotons\" true",
                                         "\"lightpath\""));

/// Paths of light tracing are followed in parts, each of other paths.
TEST(LightTracing, PartsOfAPassDiffer) {
    const auto pictureOf = [](std::uint64_t paths, RenderCounters& counters) {
        return renderText(
            head("LookAt 0 0 1 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" "
                 "[-.1 .1 -.1 .1]\n",
                 fmt::format("\"lightpath\" \"integer maxdepth\" 1 \"integer photonsperiteration\" {}", paths)) +
                "LightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [0 0 2]\nShape \"disk\"\n",
            1, 1, counters);
    };
    RenderCounters one, two;
    const Image half = pictureOf(262144, one), whole = pictureOf(2 * 262144, two);
    EXPECT_EQ(one.photonPaths, 262144u);
    EXPECT_EQ(two.photonPaths, 2 * 262144u);
    double sumOfHalf = 0, sum = 0, difference = 0;
    for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
        sumOfHalf += double(half.pixels[i]);
        sum += double(whole.pixels[i]);
        difference += std::abs(double(whole.pixels[i]) - double(half.pixels[i]));
    }
    EXPECT_GT(difference, 0.01 * sum) << "the same paths twice";
    EXPECT_NEAR(sum / sumOfHalf, 1, 0.1);
}

} // namespace
} // namespace vitrine
