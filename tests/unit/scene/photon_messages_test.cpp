// What photon integrators say of scenes that they cannot show whole.
#include "photons/photon.h"
#include "scene_text.h"

#include <fmt/format.h>

namespace vitrine {
namespace {

Lines warningsOf(const std::string& text, const Overrides& overrides = {}) {
    Lines lines;
    for (const Diagnostic& d : built(text, overrides).warnings) {
        const std::string full = d.toString();
        lines.push_back(full.substr(0, full.find('\n')));
    }
    return lines;
}

TEST(PhotonMessages, BlackLightsAreTold) {
    const std::string dark = "LightSource \"point\" \"rgb I\" [0 0 0]\n", floor = "Shape \"disk\"\n",
                      told = "scene.pbrt:2:1: warning: no light of this scene shines: they are black";
    for (const char* integrator : {"path", "sppm", "ppm", "lightpath"}) {
        const std::string begin = fmt::format("Integrator \"{}\" WorldBegin\n", integrator);
        EXPECT_EQ(warningsOf(begin + dark + dark + floor), Lines{told}) << integrator;
        EXPECT_EQ(warningsOf(begin + "AreaLightSource \"diffuse\" \"rgb L\" [0 0 0]\n" + floor), Lines{told});
        EXPECT_EQ(warningsOf(begin + dark + "LightSource \"point\" \"rgb I\" [0 0 1e-9]\n" + floor), Lines{});
    }
    EXPECT_EQ(warningsOf("WorldBegin\n" + floor), Lines{}) << "without lights nothing was meant to shine";
    EXPECT_EQ(warningsOf("WorldBegin\nAreaLightSource \"diffuse\" Shape \"plane\"\n"), Lines{}) << "rays run into it";
    EXPECT_EQ(warningsOf("Integrator \"path\" \"string lightsampler\" \"uniform\" WorldBegin\n" + dark + floor),
              Lines{told});
}

TEST(PhotonMessages, PolishedSurfacesAloneAreRefused) {
    const std::string world = " WorldBegin LightSource \"point\" Material \"dielectric\" Shape \"sphere\"\n";
    const std::string rest = "this scene has none. The path integrator renders it";
    EXPECT_EQ(
        errorsOf("Integrator \"lightpath\"" + world),
        Lines{"1:12: error: light tracing needs a surface that is not polished, to connect it to the camera: " + rest});
    for (const char* integrator : {"sppm", "ppm"})
        EXPECT_EQ(
            errorsOf(fmt::format("Integrator \"{}\"", integrator) + world),
            Lines{"1:12: error: photon mapping needs a surface that is not polished, for photons to land on: " + rest});
    const std::string frosted = " WorldBegin LightSource \"point\" Material \"dielectric\" \"float roughness\" .5 "
                                "Shape \"sphere\"\n";
    EXPECT_EQ(errorsOf("Integrator \"lightpath\"" + frosted), Lines{});
}

TEST(PhotonMessages, PathsOfPhotonsHaveAnEnd) {
    const std::string world = " WorldBegin LightSource \"point\" Shape \"disk\"\n";
    for (const char* integrator : {"sppm", "ppm"}) {
        const auto withDepth = [&](int depth) {
            return fmt::format("Integrator \"{}\" \"integer maxdepth\" {}", integrator, depth) + world;
        };
        EXPECT_EQ(warningsOf(withDepth(Photon::maxDepth + 1)), Lines{});
        const Lines told = warningsOf(withDepth(Photon::maxDepth + 2));
        ASSERT_EQ(told.size(), 1u);
        const std::size_t column = std::string("Integrator \"\" ").size() + std::string(integrator).size() + 1;
        EXPECT_EQ(told[0], fmt::format("scene.pbrt:1:{}: warning: paths of photons end after {} scattering events: "
                                       "light that needs more is missing",
                                       column, Photon::maxDepth + 1));
    }
    EXPECT_EQ(warningsOf("Integrator \"lightpath\" \"integer maxdepth\" 1000" + world), Lines{});
}

} // namespace
} // namespace vitrine
