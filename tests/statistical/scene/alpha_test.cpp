// Shapes with holes, as lamps and as what stands in the light: every way of finding light gives the same.
#include "render_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

std::string sceneOf(const std::string& integrator, const std::string& content, int side = 6) {
    return fmt::format("LookAt 0 0 4  0 0 0  0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-1 1 -1 1]\n"
                       "Film \"rgb\" \"integer xresolution\" {0} \"integer yresolution\" {0}\nPixelFilter \"box\"\n"
                       "Sampler \"zsobol\"\nIntegrator {1}\nWorldBegin\n"
                       "Texture \"checks\" \"float\" \"checkerboard\" \"float uscale\" 4 \"float vscale\" 4 "
                       "\"float tex1\" 1 \"float tex2\" 0\n"
                       "Texture \"partly\" \"float\" \"checkerboard\" \"float uscale\" 4 \"float vscale\" 4 "
                       "\"float tex1\" .9 \"float tex2\" .2\n",
                       side, integrator) +
           content;
}

const std::string floorOf = "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5]\nShape \"disk\" \"float radius\" 3\n";

void expectSame(const std::string& name, const Measured& a, const Measured& b, double bias = 0) {
    for (int c = 0; c < 3; ++c) {
        const double error = std::hypot(a.error[c], b.error[c]);
        EXPECT_NEAR(a.mean[c], b.mean[c], 4.5 * error + bias * b.mean[c]) << name << " channel " << c;
        EXPECT_LT(error, 0.03 * b.mean[c]) << name << ": too noisy for a test";
    }
}

class AlphaLamp : public testing::TestWithParam<std::pair<const char*, const char*>> {};

/// The lamp hangs over the floor, behind the camera; light leaves it, passes its own holes, and is met through them.
TEST_P(AlphaLamp, ShinesAlikeHoweverItIsFound) {
    const std::string content =
        floorOf + "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [3 2 4] \"bool twosided\" true\n" +
        std::string("Translate .3 0 5.5\n") + GetParam().second + "\nAttributeEnd\n";
    const auto render = [&](const std::string& integrator, std::uint64_t passes) {
        return measure(sceneOf(integrator + " \"integer maxdepth\" 3", content), passes, 12);
    };
    const std::string photons = " \"integer photonsperiteration\" 8192 ";
    const Measured asked = render("\"path\"", 256), met = render("\"path\" \"bool nee\" false", 1024);
    expectSame("nee", asked, met);
    expectSame("lightpath", render("\"lightpath\"" + photons, 12), asked);
    // Over disks this large light that comes from six units away changes by a few thousandths.
    expectSame("sppm", render("\"sppm\" \"float radius\" .3 \"bool directbyphotons\" true" + photons, 16), asked, 4e-3);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, AlphaLamp,
    testing::Values(
        std::pair("sphere", "Shape \"sphere\" \"float radius\" 1.2 \"texture alpha\" \"partly\""),
        std::pair("partOfASphere", "Shape \"sphere\" \"float radius\" 1.2 \"float zmax\" .5 \"float phimax\" 200 "
                                   "\"texture alpha\" \"partly\""),
        std::pair("disk", "Shape \"disk\" \"float radius\" 1.5 \"float innerradius\" .3 \"texture alpha\" \"partly\""),
        std::pair("cylinder", "Rotate 90 1 0 0\nShape \"cylinder\" \"float radius\" .8 \"texture alpha\" \"partly\""),
        std::pair(
            "box",
            "Shape \"box\" \"point3 pmin\" [-.8 -.8 -.8] \"point3 pmax\" [.8 .8 .8] \"texture alpha\" \"partly\""),
        std::pair("quad", "Shape \"bilinearmesh\" \"point3 P\" [-1.5 -1.5 0  1.5 -1.5 0  -1.5 1.5 0  1.5 1.5 0] "
                          "\"texture alpha\" \"partly\""),
        std::pair("bentPatch", "Shape \"bilinearmesh\" \"point3 P\" [-1.5 -1.5 0  1.5 -1.5 1  -1.5 1.5 1  1.5 1.5 0] "
                               "\"texture alpha\" \"partly\""),
        std::pair("triangles",
                  "Shape \"trianglemesh\" \"point3 P\" [-1.5 -1.5 0  1.5 -1.5 0  -1.5 1.5 0  1.5 1.5 .5] "
                  "\"point2 uv\" [0 0  1 0  0 1  1 1] \"integer indices\" [0 1 2 1 3 2] \"texture alpha\" \"partly\""),
        std::pair(
            "revolution",
            "Rotate 90 1 0 0\nShape \"revolution\" \"point2 P\" [0 -1 1.5 -1 .3 .5 1 1] \"texture alpha\" \"partly\""),
        std::pair("evenSphere", "Shape \"sphere\" \"float radius\" 1.2 \"float alpha\" .4")),
    [](const auto& which) { return which.param.first; });

/// Constant 0 hides the shape and not its light, as from a lamp that nothing can meet.
TEST(Alpha, OfZeroHidesALampButNotItsLight) {
    const auto lamp = [](const std::string& alpha) {
        return floorOf +
               "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [3 2 4]\nTranslate .3 0 5.5\n"
               "Shape \"sphere\" \"float radius\" 1 " +
               alpha + "\nAttributeEnd\n";
    };
    const std::string path = "\"path\" \"integer maxdepth\" 1";
    const Measured seen = measure(sceneOf(path, lamp("")), 256),
                   hidden = measure(sceneOf(path, lamp("\"float alpha\" 0")), 256);
    expectSame("path", hidden, seen);
    expectSame("lightpath",
               measure(sceneOf("\"lightpath\" \"integer maxdepth\" 1 \"integer photonsperiteration\" 8192",
                               lamp("\"float alpha\" 0")),
                       32),
               seen);
    const Measured none =
        measure(sceneOf("\"path\" \"integer maxdepth\" 1 \"bool nee\" false", lamp("\"float alpha\" 0")), 16, 2);
    EXPECT_EQ(none.mean[0], 0);
}

/// Black disks stop their share of what a distant light sends, each by itself.
TEST(Alpha, OfDisksInTheLightMultiplies) {
    const std::string light =
        "LightSource \"distant\" \"rgb L\" [2 2 2] \"point3 from\" [0 0 1] \"point3 to\" [0 0 0]\n";
    const std::string disks = "Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n"
                              "Shape \"disk\" \"float radius\" 9 \"float height\" 5 \"float alpha\" .3\n"
                              "Shape \"disk\" \"float radius\" 9 \"float height\" 6 \"float alpha\" .6\n";
    const double expected = 2 * .5 / M_PI * .7 * .4;
    for (const char* integrator :
         {"\"path\"", "\"lightpath\" \"integer photonsperiteration\" 4096",
          "\"sppm\" \"float radius\" .1 \"integer photonsperiteration\" 1024",
          "\"ppm\" \"integer hitpointsperpixel\" 64 \"float radius\" .2 \"integer photonsperiteration\" 1024"}) {
        const Measured measured =
            measure(sceneOf(integrator + std::string(" \"integer maxdepth\" 4"), light + floorOf + disks), 64);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(measured.mean[c], expected, 5 * measured.error[c] + 1e-3 * expected) << integrator;
            EXPECT_LT(measured.error[c], 0.03 * expected) << integrator << ": too noisy for a test";
        }
    }
}

/// In a white world nothing that reflects all is to be seen, with holes or without.
TEST(Alpha, FurnaceOfAHalfThereBall) {
    for (const char* alpha : {"\"float alpha\" .5", "\"texture alpha\" \"checks\""})
        EXPECT_RADIANCE(sceneOf("\"path\" \"integer maxdepth\" 100",
                                std::string("LightSource \"infinite\" \"rgb L\" [1 1 1]\nMaterial \"diffuse\" "
                                            "\"rgb reflectance\" [1 1 1]\nShape \"sphere\" ") +
                                    alpha + "\n"),
                        1.);
}

/// A sheet with a chessboard of holes, and the sheet made of the squares that stay: as a lamp, and in the light.
TEST(Alpha, ChessboardIsItsSquares) {
    // Where the texture is 1: cells whose numbers add up to an even one.
    std::string squares;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            if ((i + j) % 2 == 0) {
                const double x = -1.5 + .75 * i, y = -1.5 + .75 * j;
                squares +=
                    fmt::format("Shape \"bilinearmesh\" \"point3 P\" [{0} {1} 0  {2} {1} 0  {0} {3} 0  {2} {3} 0]\n", x,
                                y, x + .75, y + .75);
            }
    const std::string sheet = "Shape \"bilinearmesh\" \"point3 P\" [-1.5 -1.5 0  1.5 -1.5 0  -1.5 1.5 0  1.5 1.5 0] "
                              "\"texture alpha\" \"checks\"\n";
    const std::string lamp = "AreaLightSource \"diffuse\" \"rgb L\" [3 2 4] \"bool twosided\" true\n";
    const std::string above =
        "AttributeBegin\n" + lamp + "Translate 0 0 6\nShape \"disk\" \"float radius\" .4\nAttributeEnd\n";
    struct Case {
        const char* name;
        std::string before;
    };
    for (const Case& where : {Case{"lamp", "AttributeBegin\n" + lamp + "Translate 0 0 2\n"},
                              Case{"shade", above + "AttributeBegin\nTranslate 0 0 1\n"}}) {
        // Side by side, pixel by pixel: a shade's holes lie where the squares have none.
        std::vector<double> mean[2], square[2];
        constexpr int runs = 16;
        for (int run = 0; run < runs; ++run)
            for (int k : {0, 1}) {
                RenderCounters counters;
                const Image image =
                    renderText(sceneOf("\"path\" \"integer maxdepth\" 3",
                                       floorOf + where.before + (k ? squares : sheet) + "AttributeEnd\n", 12),
                               std::uint64_t(1000 + run), 64, counters);
                mean[k].resize(image.pixels.size());
                square[k].resize(image.pixels.size());
                for (std::size_t i = 0; i < image.pixels.size(); ++i) {
                    mean[k][i] += double(image.pixels[i]) / runs;
                    square[k][i] += sqr(double(image.pixels[i])) / runs;
                }
            }
        double total[2] = {};
        int far = 0;
        for (std::size_t i = 0; i < mean[0].size(); ++i) {
            const auto variance = [&](int k) { return (square[k][i] - sqr(mean[k][i])) / (runs - 1); };
            const double error = std::sqrt(variance(0) + variance(1));
            // t with 30 degrees of freedom beyond 5: 2e-5, for one of 432 values 1 %.
            far += std::abs(mean[0][i] - mean[1][i]) > 5 * error + 1e-6;
            total[0] += mean[0][i];
            total[1] += mean[1][i];
        }
        EXPECT_EQ(far, 0) << where.name;
        EXPECT_NEAR(total[0] / total[1], 1, 0.01) << where.name;
    }
}

} // namespace
} // namespace vitrine
