// Photons on surfaces that other surfaces all but touch, and scenes in which nothing that changes no light may change the
// picture.
#include "known_values.h"
#include "render_text.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

/// Straight down on (or up at) the middle of z = 0.
/// \param half side of what is seen
std::string above(const std::string& integrator, int side = 4, double half = 0.1) {
    return head(
        fmt::format("LookAt 0 0 3 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-{0} {0} -{0} {0}]\n",
                    half),
        integrator, side);
}
std::string below(const std::string& integrator) {
    return head("LookAt 0 0 -3 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.1 .1 -.1 .1]\n",
                integrator);
}

void expectGrey(const std::string& text, double expected, std::uint64_t passes) {
    expectRadiance(text, expected, passes, 5e-3, 0.02, 4);
}

const std::string mattFloor = "Material \"diffuse\" \"spectrum reflectance\" [300 .5 900 .5]\nShape \"disk\"\n";

/// A print behind a pane: the disk's radius is a thousand times the gap.
TEST(PhotonGaps, GlassThatAllButTouchesTheFloorHidesNothing) {
    const double r = fresnel(1, 1.5);
    for (const char* type : {"\"sppm\"", "\"ppm\""})
        expectGrey(
            above(type +
                  std::string(" \"integer maxdepth\" 5 \"integer photonsperiteration\" 6000 \"float radius\" .1")) +
                "LightSource \"distant\" \"rgb L\" [1 1 1] \"point3 from\" [0 0 1] \"point3 to\" [0 0 0]\n" +
                mattFloor +
                "Material \"dielectric\" \"float eta\" 1.5\n"
                "Shape \"box\" \"point3 pmin\" [-1 -1 .0001] \"point3 pmax\" [1 1 .2]\n",
            .5 / M_PI * std::pow(1 - r, 4), 32);
}

/// The underside is lit and seen from below; a wall stands on the upper side.
TEST(PhotonGaps, WallsOnTheOtherSideHideNothing) {
    expectGrey(below("\"sppm\" \"integer maxdepth\" 1 \"integer photonsperiteration\" 6000 \"float radius\" .1 "
                     "\"bool directbyphotons\" true") +
                   "LightSource \"distant\" \"rgb L\" [1 1 1] \"point3 from\" [0 0 -1] \"point3 to\" [0 0 0]\n" +
                   mattFloor + "Shape \"box\" \"point3 pmin\" [-.005 -1 0] \"point3 pmax\" [.005 1 1]\n",
               .5 / M_PI, 32);
}

/// A sheet without thickness between a lit room and a dark one. Photons on it are kept in single precision about cameras of
/// which the coordinates round, up or down.
TEST(PhotonGaps, SheetsLetNothingThrough) {
    const std::string rooms = "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [20 20 20]\nTranslate 1 .5 0\n"
                              "Shape \"sphere\" \"float radius\" .2\nAttributeEnd\n"
                              "Material \"diffuse\" \"rgb reflectance\" [.6 .5 .4]\n"
                              "ReverseOrientation\nShape \"box\" \"point3 pmin\" [-2 -1 -2] \"point3 pmax\" [2 1 2]\n"
                              "ReverseOrientation\n";
    const std::string patch = "Shape \"bilinearmesh\" \"point3 P\" [0 -1.5 -2.5  0 -1.5 2.5  0 1.5 -2.5  0 1.5 2.5]\n";
    const std::string triangles = "Shape \"trianglemesh\" \"integer indices\" [0 1 2 1 3 2] \"point3 P\" "
                                  "[0 -1.5 -2.5  0 -1.5 2.5  0 1.5 -2.5  0 1.5 2.5]\n";
    for (const double x : {-1.8, -1.7, -1.63})
        for (const std::string& sheet : {patch, triangles}) {
            const Measured dark = measure(
                head(fmt::format("LookAt {} .5 1.8  0 -.5 0  0 1 0\nCamera \"perspective\" \"float fov\" 60\n", x),
                     "\"sppm\" \"integer maxdepth\" 10 \"integer photonsperiteration\" 6000", 32) +
                    rooms + sheet,
                8, 2);
            for (int c = 0; c < 3; ++c)
                EXPECT_EQ(dark.mean[c], 0) << x << sheet;
        }
}

/// Photons of one face of a thin pane must not count on the other as if they came from inside.
TEST(PhotonGaps, FrostedPanesHaveTwoFaces) {
    const auto scene = [](const std::string& integrator) {
        return above(integrator, 4, 1) +
               "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [4 4 4]\nTranslate .5 0 -2\n"
               "Shape \"sphere\" \"float radius\" .7\nAttributeEnd\n"
               "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\nTranslate -2 1 3\n"
               "Shape \"sphere\" \"float radius\" .5\nAttributeEnd\n"
               "Material \"dielectric\" \"float eta\" 1.5 \"float roughness\" .4\n"
               "Shape \"box\" \"point3 pmin\" [-1.5 -1.5 -.002] \"point3 pmax\" [1.5 1.5 .002]\n";
    };
    const Measured path = measure(scene("\"path\" \"integer maxdepth\" 12"), 512, 4);
    const Measured photons = measure(scene("\"sppm\" \"integer maxdepth\" 12 \"integer photonsperiteration\" 10000 "
                                           "\"float radius\" .2 \"bool directbyphotons\" true"),
                                     64, 4);
    for (int c = 0; c < 3; ++c) {
        const double error = std::hypot(path.error[c], photons.error[c]);
        EXPECT_NEAR(photons.mean[c], path.mean[c], 5 * error + 0.01 * path.mean[c]) << "channel " << c;
        EXPECT_LT(error, 0.02 * path.mean[c]) << "too noisy for a test";
    }
}

/// Root mean square of the difference, as a part of the mean.
double difference(const std::string& one, const std::string& other) {
    RenderCounters counters;
    const Image a = renderText(one, 1, 8, counters), b = renderText(other, 1, 8, counters);
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        squares += std::pow(double(a.pixels[i]) - double(b.pixels[i]), 2);
        sum += double(a.pixels[i]);
    }
    return std::sqrt(squares * double(a.pixels.size())) / sum;
}

const std::string lamp = "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [9 9 9]\nTranslate 1 0 3\n"
                         "Shape \"sphere\" \"float radius\" .5\nAttributeEnd\n";
const std::string bySppm = "\"sppm\" \"integer maxdepth\" 4 \"bool directbyphotons\" true";

TEST(PhotonGaps, InterfacesBeforeAPointLeaveItsDiskAsLarge) {
    const std::string scene = above(bySppm, 16) + lamp + mattFloor;
    EXPECT_LT(difference(scene, scene + "Material \"interface\"\nShape \"box\" \"point3 pmin\" [-2 -2 .01] "
                                        "\"point3 pmax\" [2 2 2.9]\n"),
              1e-3);
}

TEST(PhotonGaps, ThingsFarAwayLeaveDisksAsSmall) {
    const std::string scene = above(bySppm, 16) + lamp + mattFloor;
    EXPECT_LT(difference(scene, scene + "Translate 0 0 1e6\nShape \"sphere\"\n"), 1e-3);
    EXPECT_GT(difference(scene, above(bySppm + " \"float radiuspixels\" 8", 16) + lamp + mattFloor), 1e-2)
        << "then the test says nothing";
}

} // namespace
} // namespace vitrine
