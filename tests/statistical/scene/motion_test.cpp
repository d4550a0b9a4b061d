// What moves, through the whole program: closed forms, static pictures averaged, integrators against each other.
#include "core/random.h"
#include "render_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace vitrine {
namespace {

/// Directives after which everything is moved as `move` says, at the end of the shutter's time.
std::string moved(const std::string& move) {
    return "ActiveTransform EndTime\n" + move + "\nActiveTransform All\n";
}

/// Parallel rays along -z through [-1, 1]^2.
std::string window(const std::string& shutter = "") {
    return "LookAt 0 0 5 0 0 0 0 1 0\nCamera \"orthographic\" " + shutter + "\n";
}
const std::string path = "\"path\" \"integer maxdepth\" 1";
const std::string shines = "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] \"bool twosided\" true\n";
const std::string square = "Shape \"bilinearmesh\" \"point3 P\" [-.5 -.5 0  .5 -.5 0  -.5 .5 0  .5 .5 0]\n";

/// A shape of area A that crosses the window, 2 x 2, from side to side over a way of 6: each of its points is in the
/// window for 2 / 6 of the time.
TEST(Motion, CoverageOfWhatCrossesThePicture) {
    const std::string across = "Translate -3 0 0\n" + moved("Translate 6 0 0");
    EXPECT_RADIANCE(head(window(), path) + across + shines + square, 1. / 12);
    EXPECT_RADIANCE(head(window(), path) + across + shines + "Shape \"sphere\" \"float radius\" .5\n", M_PI / 48);
    // It has turned by half a turn at the end: about its middle that changes nothing.
    EXPECT_RADIANCE(head(window(), path) + "Translate -3 0 0\n" + moved("Translate 6 0 0\nRotate 170 0 0 1") + shines +
                        "Shape \"disk\" \"float radius\" .5\n",
                    M_PI / 48);
    // Half of the time, in which it goes from -1.5 to 1.5; exposed for half a second.
    EXPECT_RADIANCE(
        head(window("\"float shutteropen\" .25 \"float shutterclose\" .75"), path) + across + shines + square, .5 / 6);
    // It moves between 1 and 3 s and stands before and after: at -3 it is not seen, at 0 it fills a quarter.
    EXPECT_RADIANCE(head("TransformTimes 1 3\n" + window("\"float shutteropen\" 0 \"float shutterclose\" 4"), path) +
                        "Translate -3 0 0\n" + moved("Translate 3 0 0") + shines + square,
                    1. / 4 + 2 * (1. / 3) / 4);
}

TEST(Motion, GrowingDisk) {
    // The radius goes from 1/4 to 1/2: the mean of its square is 7/48.
    EXPECT_RADIANCE(head(window(), path) + "Scale .25 .25 1\n" + moved("Scale 2 2 1") + shines + "Shape \"disk\"\n",
                    M_PI / 4 * 7 / 48);
}

TEST(Motion, InstancesAndMovesInMoves) {
    const std::string object = "ObjectBegin \"o\"\n" + moved("Translate 2 0 0") +
                               "Material \"diffuse\" \"spectrum reflectance\" [300 1 900 1]\n" + square + "ObjectEnd\n";
    const std::string sky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";
    // White under a white sky is not seen; black against it is what is missing.
    const std::string black = "ObjectBegin \"b\"\n" + moved("Translate 2 0 0") +
                              "Material \"diffuse\" \"spectrum reflectance\" [300 0 900 0]\n" + square + "ObjectEnd\n";
    EXPECT_RADIANCE(head(window(), path) + sky + object + "Translate -3 0 0\n" + moved("Translate 4 0 0") +
                        "ObjectInstance \"o\"\n",
                    1.);
    EXPECT_RADIANCE(head(window(), path) + sky + black + "Translate -3 0 0\n" + moved("Translate 4 0 0") +
                        "ObjectInstance \"b\"\n",
                    1 - 1. / 12);
    // The instance stands, what is in it moves: by 6 where it is stretched.
    EXPECT_RADIANCE(head(window(), path) + sky + black + "Translate -3 0 0\nScale 3 1 1\nObjectInstance \"b\"\n",
                    1 - 3. / 12);
}

/// The floor z = 0 round the origin, seen along -z, of reflectance 1/2: radiance is irradiance / 2 pi.
std::string floorUnder(const std::string& integrator, const std::string& lamp, double half = .01) {
    return head(fmt::format(
                    "LookAt 0 0 1 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-{0} {0} -{0} {0}]\n",
                    half),
                integrator) +
           lamp +
           fmt::format("Material \"diffuse\" \"spectrum reflectance\" [300 .5 900 .5]\n"
                       "Shape \"disk\" \"float radius\" {}\n",
                       2 * half);
}
std::string apart(const std::string& text) {
    return "AttributeBegin\n" + text + "AttributeEnd\n";
}

/// A lamp that passes 2 above from x = -2 to 2: the mean of 2 / (x^2 + 4)^(3/2) is 1 / (2 sqrt 8).
TEST(Motion, IrradianceOfLampsThatPass) {
    const double mean = 1 / (2 * std::sqrt(8.)) / (2 * M_PI);
    const std::string pass = "Translate -2 0 2\n" + moved("Translate 4 0 0");
    const std::string point = apart(pass + "LightSource \"point\" \"rgb I\" [1 1 1]\n");
    // As if all light of a ball came from its middle: pi L r^2.
    const std::string ball =
        apart(pass + "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\nShape \"sphere\" \"float radius\" .5\n");
    const std::string direct = "\"integer maxdepth\" 1 ";
    const std::string beside = "LightSource \"point\" \"rgb I\" [1 1 1] \"point3 from\" [0 3 2]\n";
    EXPECT_RADIANCE(floorUnder("\"path\" " + direct, point), mean);
    EXPECT_RADIANCE(floorUnder("\"path\" " + direct, ball), mean * M_PI / 4);
    EXPECT_RADIANCE(floorUnder("\"path\" \"bool nee\" false " + direct, ball), mean * M_PI / 4);
    EXPECT_RADIANCE(floorUnder("\"path\" \"string lightsampler\" \"bvh\" " + direct, ball + beside),
                    mean * M_PI / 4 + 2 / std::pow(13, 1.5) / (2 * M_PI));
    // A spot that shines straight down, wide enough, and one that turns away: its rim passes the origin half way.
    EXPECT_RADIANCE(
        floorUnder(
            "\"path\" " + direct,
            apart(pass + "LightSource \"spot\" \"rgb I\" [1 1 1] \"point3 to\" [0 0 -1] \"float coneangle\" 80\n")),
        mean);
    EXPECT_RADIANCE(
        floorUnder("\"path\" " + direct,
                   apart("Translate 0 0 2\n" + moved("Rotate 60 1 0 0") +
                         "LightSource \"spot\" \"rgb I\" [1 1 1] \"point3 to\" [0 0 -1] \"float coneangle\" 30 "
                         "\"float conedeltaangle\" 0\n")),
        .5 / 4 / (2 * M_PI));
    // A sun that sets by 60 degrees: the mean of its cosine.
    EXPECT_RADIANCE(
        floorUnder("\"path\" " + direct,
                   apart(moved("Rotate 60 1 0 0") + "LightSource \"distant\" \"rgb L\" [1 1 1] \"point3 from\" [0 0 1] "
                                                    "\"point3 to\" [0 0 0]\n")),
        std::sin(M_PI / 3) / (M_PI / 3) / (2 * M_PI));
}

/// A stretched lamp that turns and grows, by all that sample lights or run into them.
TEST(Motion, LampThatTurnsAndGrowsByAllIntegrators) {
    const std::string lamp = "Translate 0 0 2\nScale .5 .3 .2\n" +
                             moved("Translate 1 .5 0\nRotate 70 0 1 1\nScale 1.5 .8 2") +
                             "AreaLightSource \"diffuse\" \"rgb L\" [4 4 4] \"bool twosided\" true\n";
    constexpr double half = .5;
    const std::string emissions[] = {"Shape \"sphere\"\n", "Shape \"disk\"\n", square};
    for (const std::string& shape : emissions) {
        const Measured oracle =
            measure(floorUnder("\"path\" \"integer maxdepth\" 2 \"bool nee\" false", apart(lamp + shape), half), 512);
        for (const std::string integrator :
             {"\"path\" \"integer maxdepth\" 2", "\"path\" \"integer maxdepth\" 2 \"string lightsampler\" \"bvh\"",
              "\"sppm\" \"integer maxdepth\" 2",
              "\"lightpath\" \"integer maxdepth\" 2 \"integer photonsperiteration\" 4096"}) {
            const Measured ours = measure(floorUnder(integrator, apart(lamp + shape), half), 64);
            for (int c = 0; c < 3; ++c) {
                const double error = std::hypot(ours.error[c], oracle.error[c]);
                EXPECT_NEAR(ours.mean[c], oracle.mean[c], 4.5 * error) << integrator << shape << c;
                EXPECT_LT(error, 0.06 * oracle.mean[c]) << integrator << shape << ": too noisy for a test";
            }
        }
    }
}

/// Means of blocks of a picture over independent renderings.
struct Blocks {
    static constexpr int across = 3;
    std::vector<std::array<double, across * across>> runs;

    void add(const Image& image) {
        std::array<double, across * across> mean{};
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                for (int c = 0; c < 3; ++c)
                    mean[std::size_t(y * across / image.height * across + x * across / image.width)] +=
                        double(image.at(x, y, c)) * across * across / (3. * image.width * image.height);
        runs.push_back(mean);
    }
    double mean(std::size_t block) const {
        double sum = 0;
        for (const auto& run : runs)
            sum += run[block] / double(runs.size());
        return sum;
    }
    double error(std::size_t block) const {
        double sum = 0;
        for (const auto& run : runs)
            sum += (run[block] - mean(block)) * (run[block] - mean(block));
        return std::sqrt(sum / double(runs.size() * (runs.size() - 1)));
    }
};

Blocks rendered(const std::string& text, std::uint64_t passes, int runs = 12) {
    Blocks blocks;
    RenderCounters counters;
    for (int run = 0; run < runs; ++run)
        blocks.add(renderText(text, std::uint64_t(100 + run), passes, counters));
    return blocks;
}

/// \param bias at most, as a part of the picture's mean
void expectSame(const Blocks& a, const Blocks& b, double noise, double bias = 0) {
    double mean = 0;
    for (std::size_t i = 0; i < Blocks::across * Blocks::across; ++i)
        mean += b.mean(i) / (Blocks::across * Blocks::across);
    for (std::size_t i = 0; i < Blocks::across * Blocks::across; ++i) {
        const double error = std::hypot(a.error(i), b.error(i));
        EXPECT_NEAR(a.mean(i), b.mean(i), 5.5 * error + bias * mean) << "block " << i;
        EXPECT_LT(error, noise * mean) << "block " << i << ": too noisy for a test";
    }
}

/// A turning die of copper and glass against as many dice that stand, each at its own time of a stratum.
TEST(Motion, TurningShapeIsTheMeanOfShapesThatStand) {
    const std::string camera = "LookAt 0 1 4 0 0 0 0 1 0\nCamera \"perspective\" \"float fov\" 40\n";
    const std::string things =
        "LightSource \"infinite\" \"rgb L\" [.2 .2 .2]\n"
        "LightSource \"distant\" \"rgb L\" [2 2 2] \"point3 from\" [1 2 1] \"point3 to\" [0 0 0]\n"
        "Shape \"bilinearmesh\" \"point3 P\" [-3 -1 3  3 -1 3  -3 -1 -3  3 -1 -3]\n"
        "Material \"conductor\" \"float roughness\" .3\n";
    const std::string integrator = "\"path\" \"integer maxdepth\" 4";
    const std::string box = "Shape \"box\" \"point3 pmin\" [-.8 -.5 -.3] \"point3 pmax\" [.8 .5 .3]\n";
    const auto turned = [](double u) { return fmt::format("Translate {} 0 0\nRotate {} 1 2 1\n", u, 140 * u); };
    const Blocks moving = rendered(head(camera, integrator, 12) + things + moved(turned(1)) + box, 256);
    Blocks standing;
    for (int run = 0; run < 12; ++run) {
        Image sum;
        constexpr int strata = 64;
        for (int i = 0; i < strata; ++i) {
            const double u = (i + unitDouble(streamKey(run, i))) / strata;
            RenderCounters counters;
            const Image image = renderText(head(camera, integrator, 12) + things + turned(u) + box,
                                           std::uint64_t(run * strata + i), 4, counters);
            if (sum.pixels.empty())
                sum = Image{image.width, image.height, image.channels, std::vector<float>(image.pixels.size())};
            for (std::size_t k = 0; k < sum.pixels.size(); ++k)
                sum.pixels[k] += image.pixels[k] / strata;
        }
        standing.add(sum);
    }
    expectSame(moving, standing, 0.02);
}

/// Meshes with their corners in the world: what turns them turns them about the origin, where the camera stands.
TEST(Motion, MovingCameraSeesTheWorldMoveTheOtherWay) {
    const auto world = [](const std::string& move) {
        return "AttributeBegin\n" + move +
               "AreaLightSource \"diffuse\" \"rgb L\" [5 5 5] \"bool twosided\" true\n"
               "Shape \"bilinearmesh\" \"point3 P\" [-1 2 -3  1 2 -3  -1 2 -5  1 2 -5]\nAttributeEnd\n"
               "AttributeBegin\n" +
               move +
               "Shape \"bilinearmesh\" \"point3 P\" [-4 -1 -1  4 -1 -1  -4 -1 -8  4 -1 -8]\n"
               "Material \"dielectric\"\n"
               "Shape \"trianglemesh\" \"point3 P\" [-.7 -.5 -4  .9 -.6 -4.5  .2 .8 -4.2  0 -.3 -3.2] "
               "\"integer indices\" [0 2 1  0 1 3  1 2 3  2 0 3]\nAttributeEnd\n";
    };
    for (const std::string lens :
         {"", "\"float lensradius\" .05 \"float focaldistance\" 4 \"string aperture\" \"star\""})
        for (const std::string move : {"Rotate 25 0 1 .3\n", "Translate .5 .2 .4\n"}) {
            const std::string camera = "Camera \"perspective\" \"float fov\" 50 " + lens + "\n",
                              look = "LookAt 0 0 0 0 0 -1 0 1 0\n";
            for (const std::string integrator :
                 {"\"path\" \"integer maxdepth\" 6",
                  "\"lightpath\" \"integer maxdepth\" 6 \"integer photonsperiteration\" 1024"}) {
                const Blocks byCamera = rendered(head(look + moved(move) + camera, integrator, 12) + world(""), 128);
                const Blocks byWorld = rendered(head(look + camera, integrator, 12) + world(moved(move)), 128);
                expectSame(byCamera, byWorld, 0.06);
            }
        }
}

/// A lamp, a ball of glass and one of copper, each on a way of its own.
std::string glassScene(const std::string& integrator) {
    return head("LookAt .2 1.1 2.2  .2 .1 0  0 1 0\nCamera \"perspective\" \"float fov\" 35\n", integrator, 15) +
           "Material \"diffuse\" \"rgb reflectance\" [.6 .5 .4]\n"
           "Shape \"bilinearmesh\" \"point3 P\" [-1 0 1.5  1.5 0 1.5  -1 0 -1.5  1.5 0 -1.5]\n"
           "AttributeBegin\nTranslate .55 .25 0\n" +
           moved("Translate 0 .3 .2") +
           "Material \"conductor\" \"spectrum eta\" \"metal-Cu-eta\" \"spectrum k\" \"metal-Cu-k\" \"float roughness\" "
           ".3\n"
           "Shape \"sphere\" \"float radius\" .25\nAttributeEnd\n"
           "AttributeBegin\nTranslate -.2 1.4 0\n" +
           moved("Translate .5 0 .1\nRotate 60 0 0 1\nScale 1 .7 1") +
           "Material \"dielectric\" \"float eta\" 1.5 \"rgb absorption\" [.3 1 2] \"integer priority\" 1\n"
           "Shape \"sphere\" \"float radius\" .4\nAttributeEnd\n"
           "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [8 8 8]\nTranslate 0 3 0\n" +
           moved("Translate .6 0 0") + "Shape \"sphere\" \"float radius\" .6\nAttributeEnd\n";
}

TEST(Motion, PhotonIntegratorsAgreeWithThePathTracerOnMovingGlass) {
    const Blocks byPaths = rendered(glassScene("\"path\" \"integer maxdepth\" 10"), 384);
    const Blocks withoutLights = rendered(glassScene("\"path\" \"integer maxdepth\" 10 \"bool nee\" false"), 512);
    expectSame(withoutLights, byPaths, 0.05);
    const std::string common = "\"integer maxdepth\" 10 \"integer photonsperiteration\" 4096 ";
    expectSame(rendered(glassScene("\"lightpath\" " + common), 48), byPaths, 0.05);
    // Disks of half a pixel lose light at outlines, as in photon_agreement_test.
    for (const std::string kind : {"\"sppm\" ", "\"ppm\" ", "\"ppm\" \"string lookup\" \"kdtree\" "})
        expectSame(rendered(glassScene(kind + common + "\"float radiuspixels\" .5 "), 48), byPaths, 0.05, 0.01);
}

TEST(Motion, SamePictureForAnyNumberOfThreads) {
    for (const std::string integrator : {"\"path\"", "\"sppm\"", "\"lightpath\""}) {
        const auto pixels = [&](int threads) {
            Image image;
            const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
            tbb::task_arena arena(threads);
            arena.execute([&] {
                RenderCounters counters;
                image = renderText(glassScene(integrator), 7, 6, counters);
            });
            return image.pixels;
        };
        EXPECT_EQ(pixels(1), pixels(3)) << integrator;
    }
}

} // namespace
} // namespace vitrine
