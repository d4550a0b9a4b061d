// Bump maps against surfaces that are really displaced, and integrators against each other on them.
#include "core/transform.h"
#include "render_text.h"
#include "textures/fbm.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

constexpr int side = 24;

std::string sceneOf(const std::string& integrator, const std::string& content) {
    return fmt::format("LookAt 0 0 4  0 0 0  0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.8 .8 -.8 .8]\n"
                       "Film \"rgb\" \"integer xresolution\" {0} \"integer yresolution\" {0}\nPixelFilter \"box\"\n"
                       "Sampler \"zsobol\"\nIntegrator {1}\nWorldBegin\n",
                       side, integrator) +
           content;
}

const std::string bumps = "Texture \"noise\" \"float\" \"fbm\" \"integer octaves\" 2\n"
                          "Texture \"bumps\" \"float\" \"scale\" \"texture tex\" \"noise\" \"float scale\" .2\n";

/// The heights of `bumps` over a square, as triangles a few of which a pixel shows.
std::string displaced() {
    constexpr int cells = 160;
    const FbmTexture noise(TextureSpace(), Octaves(2, 0.5f));
    std::string points, faces;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            TexturePoint at;
            at.p = V3d(-1 + 2. * i / cells, -1 + 2. * j / cells, 0);
            points += fmt::format("{} {} {} ", at.p.x, at.p.y, 0.2f * noise.evaluate(at));
            const int v = j * (cells + 1) + i;
            if (i < cells && j < cells)
                faces +=
                    fmt::format("{} {} {} {} {} {} ", v, v + 1, v + cells + 1, v + 1, v + cells + 2, v + cells + 1);
        }
    return "Shape \"trianglemesh\" \"point3 P\" [" + points + "] \"integer indices\" [" + faces + "]\n";
}

/// A distant light, high enough to reach everywhere, shades real relief and bumps alike, but for the difference between the
/// heights' slopes and those of triangles.
TEST(SurfaceDetail, BumpsAreShadedAsDisplacedTriangles) {
    const std::string path = "\"path\" \"integer maxdepth\" 1",
                      light =
                          "LightSource \"distant\" \"rgb L\" [3 3 3] \"point3 from\" [1 .5 2] \"point3 to\" [0 0 0]\n",
                      square = "Shape \"bilinearmesh\" \"point3 P\" [-1 -1 0  1 -1 0  -1 1 0  1 1 0]\n";
    RenderCounters counters;
    const auto render = [&](const std::string& content) {
        return renderText(sceneOf(path, light + bumps + content), 1, 256, counters);
    };
    const std::string matt = "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5]";
    const Image real = render(matt + "\n" + displaced()),
                bumped = render(matt + " \"texture displacement\" \"bumps\"\n" + square),
                flat = render(matt + "\n" + square);
    double difference = 0, relief = 0, mean[2] = {};
    for (std::size_t i = 0; i < real.pixels.size(); ++i) {
        const double r = double(real.pixels[i]), b = double(bumped.pixels[i]);
        difference += sqr(r - b);
        relief += sqr(r - double(flat.pixels[i]));
        mean[0] += r;
        mean[1] += b;
    }
    const double contrast = std::sqrt(relief / double(real.pixels.size())) / (mean[0] / double(real.pixels.size()));
    EXPECT_GT(contrast, 0.05) << "there is no relief to see";
    EXPECT_LT(std::sqrt(difference / relief), 0.02);
    EXPECT_NEAR(mean[1] / mean[0], 1, 1e-3);
}

void expectSame(const char* name, const Measured& a, const Measured& b, double bias) {
    for (int c = 0; c < 3; ++c) {
        const double error = std::hypot(a.error[c], b.error[c]);
        EXPECT_NEAR(a.mean[c], b.mean[c], 4.5 * error + bias * b.mean[c]) << name << " channel " << c;
        EXPECT_LT(error, 0.015 * b.mean[c]) << name << ": too noisy for a test";
    }
}

class Bumped : public testing::TestWithParam<std::pair<const char*, const char*>> {};

/// Steep bumps on a ball and on the floor, matt, rough and smooth: photons must see the normals that eye paths see, and
/// light paths weigh them as Veach says.
TEST_P(Bumped, LooksAlikeToEveryIntegrator) {
    const std::string content =
        std::string("Texture \"noise\" \"float\" \"fbm\" \"integer octaves\" 2\nTexture \"bumps\" \"float\" \"scale\" "
                    "\"texture tex\" \"noise\" \"float scale\" .2\n"
                    "Material \"diffuse\" \"rgb reflectance\" [.6 .5 .4] \"texture displacement\" \"bumps\"\n"
                    "Shape \"disk\" \"float radius\" 3\n") +
        "AttributeBegin\nTranslate .2 .1 .5\nMaterial " + GetParam().second +
        " \"texture displacement\" \"bumps\"\nShape \"sphere\" \"float radius\" .4\nAttributeEnd\n"
        "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [5 4 6]\nTranslate 1 .5 5.5\n"
        "Shape \"sphere\" \"float radius\" 1.2\nAttributeEnd\n";
    const auto render = [&](const std::string& integrator, std::uint64_t passes) {
        return measure(sceneOf(integrator + " \"integer maxdepth\" 4", content), passes, 8);
    };
    const std::string photons = " \"integer photonsperiteration\" 8192 ";
    const Measured path = render("\"path\"", 128);
    expectSame("nee", render("\"path\" \"bool nee\" false", 1024), path, 0);
    expectSame("sppm", render("\"sppm\" \"float radiuspixels\" .5" + photons, 48), path, 3e-3);
    // Light tracing cannot connect to what is seen in smooth surfaces.
    if (GetParam().first != std::string("glass"))
        expectSame("lightpath", render("\"lightpath\"" + photons, 48), path, 0);
}

INSTANTIATE_TEST_SUITE_P(Materials, Bumped,
                         testing::Values(std::pair("matt", "\"diffuse\" \"rgb reflectance\" [.3 .6 .8]"),
                                         std::pair("metal", "\"conductor\" \"float roughness\" .3"),
                                         std::pair("glass", "\"dielectric\" \"float eta\" 1.5")),
                         [](const auto& which) { return which.param.first; });

} // namespace
} // namespace vitrine
