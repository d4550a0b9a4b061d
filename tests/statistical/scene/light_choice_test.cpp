// However lights are chosen, the picture is the same in the mean; with many local lights, a tree makes the least noise.
#include "core/random.h"
#include "render_text.h"

#include <fmt/format.h>

namespace vitrine {
namespace {

std::string scene(const std::string& integrator, const std::string& choice, const std::string& lights) {
    return fmt::format("Sampler \"independent\"\nFilm \"rgb\" \"integer xresolution\" 24 \"integer yresolution\" 24\n"
                       "LookAt 0 5 -9  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 60\n"
                       "Integrator \"{}\" \"integer maxdepth\" 3 \"string lightsampler\" \"{}\"\nWorldBegin\n"
                       "Material \"diffuse\" \"rgb reflectance\" [0.5 0.5 0.5]\n"
                       "Shape \"disk\" \"float radius\" 12 \"float height\" 0\n"
                       "AttributeBegin\nRotate -90 1 0 0\nShape \"disk\" \"float radius\" 12\nAttributeEnd\n{}",
                       integrator, choice, lights);
}

/// Small triangles over the floor, in one mesh.
std::string manyTriangles(int count, double above, const std::string& more) {
    RandomStream random(11);
    std::string points, indices;
    for (int i = 0; i < count; ++i) {
        const V3d p(random.uniform(-8, 8), random.uniform(above, 2 * above), random.uniform(-8, 8));
        points += fmt::format("{} {} {}  {} {} {}  {} {} {}\n", p.x, p.y, p.z, p.x + 0.1, p.y + 0.02, p.z, p.x, p.y,
                              p.z + 0.1);
        indices += fmt::format("{} {} {}\n", 3 * i, 3 * i + 1, 3 * i + 2);
    }
    return "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [20 20 20]" + more +
           "\nShape \"trianglemesh\" \"point3 P\" [" + points + "] \"integer indices\" [" + indices +
           "]\nAttributeEnd\n";
}

/// Lights of all kinds, one of them over the horizon of most points, one that no light comes from, a sky.
std::string mixedLights() {
    std::string lights = manyTriangles(150, 0.4, " \"bool twosided\" true");
    for (int i = 0; i < 8; ++i)
        lights +=
            fmt::format("LightSource \"spot\" \"point3 from\" [{0} 2 1] \"point3 to\" [{0} 0 1] \"rgb I\" [3 3 3]\n"
                        "LightSource \"point\" \"point3 from\" [{0} 0.5 -3] \"rgb I\" [0.5 0.5 0.5]\n",
                        2 * i - 7);
    return lights + "LightSource \"point\" \"rgb I\" [0 0 0]\n"
                    "LightSource \"infinite\" \"rgb L\" [0.2 0.2 0.2]\n"
                    "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [4 4 4]\nTranslate 0 1 2\n"
                    "Shape \"sphere\" \"float radius\" 0.5\nAttributeEnd\n"
                    "Material \"conductor\" \"float roughness\" 0.3\nTranslate 3 1 0\nShape \"sphere\"\n"
                    "Material \"dielectric\" \"float roughness\" 0.2\nTranslate -6 0 0\nShape \"sphere\"\n";
}

TEST(ChoiceOfLights, DoesNotChangeTheMean) {
    const std::string lights = mixedLights();
    for (const char* integrator : {"path", "sppm"}) {
        // Photon mapping's radius is a bias of its own, the same for all.
        const Measured uniform = measure(scene(integrator, "uniform", lights), 64);
        for (const char* choice : {"power", "bvh"}) {
            const Measured other = measure(scene(integrator, choice, lights), 64);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(other.mean[c], uniform.mean[c], 5 * std::hypot(other.error[c], uniform.error[c]))
                    << integrator << ' ' << choice;
        }
    }
}

/// Mean over pixels of the variance of a sample, from two pictures.
double variance(const std::string& text) {
    RenderCounters counters;
    const Image a = renderText(text, 1, 16, counters), b = renderText(text, 2, 16, counters);
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        sum += sqr(double(a.pixels[i]) - double(b.pixels[i])) / 2;
    return sum / double(a.pixels.size());
}

TEST(ChoiceOfLights, ATreeKnowsWhichLightsAreNear) {
    const std::string lights = manyTriangles(1000, 0.2, "");
    EXPECT_LT(variance(scene("path", "bvh", lights)), 0.3 * variance(scene("path", "power", lights)));
}

} // namespace
} // namespace vitrine
