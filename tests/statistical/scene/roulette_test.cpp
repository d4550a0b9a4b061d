// Russian roulette ends as many paths behind dispersive glass as behind any other: that a hero wavelength stands for all
// four says nothing of what the path is worth.
#include "scene/scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

/// Share of one-sample pixels that are not black: camera, pane, dark floor, and back to the sky.
double livingShare(const std::string& glass) {
    const Scene scene = loadSceneString(
        fmt::format("LookAt 0 0 5 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.1 .1 -.1 .1]\n"
                    "Film \"rgb\" \"integer xresolution\" 128 \"integer yresolution\" 128\nPixelFilter \"box\"\n"
                    "Sampler \"independent\"\nIntegrator \"path\" \"integer maxdepth\" 50 \"bool nee\" false\n"
                    "WorldBegin\nLightSource \"infinite\" \"rgb L\" [1 1 1]\n"
                    "AttributeBegin\nMaterial \"diffuse\" \"spectrum reflectance\" [300 .1 900 .1]\n"
                    "Shape \"plane\" \"normal n\" [0 0 1]\nAttributeEnd\n"
                    "Material \"thindielectric\" \"spectrum eta\" {}\n"
                    "Shape \"plane\" \"normal n\" [0 0 1] \"float d\" 1\n",
                    glass));
    Film film(scene.film);
    RenderCounters counters;
    scene.integrator->addPasses(scene.world, {0, 1}, film, counters);
    const Image image = film.image();
    int living = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3)
        living += image.pixels[i] != 0 || image.pixels[i + 1] != 0 || image.pixels[i + 2] != 0;
    return 3. * living / double(image.pixels.size());
}

TEST(Roulette, EndsAsManyPathsBehindDispersiveGlass) {
    // BK7's index is about 1.52; the pane reflects a few per cent more or less.
    const double plain = livingShare("[300 1.52 900 1.52]"), dispersive = livingShare("\"glass-BK7\"");
    const double sigma = std::sqrt(2 * plain * (1 - plain) / (128 * 128));
    EXPECT_NEAR(dispersive, plain, 5 * sigma);
    EXPECT_GT(plain, 0.1);
    EXPECT_LT(plain, 0.3);
}

} // namespace
} // namespace vitrine
