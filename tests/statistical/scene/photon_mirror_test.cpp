// A caustic that is lit by a point and seen in a mirror: no path tracer finds it, as neither end of the path meets anything
// by chance. Lamps of equal power that shrink to the point lead there.
#include "render_text.h"
#include "support/estimate.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

constexpr int x0 = 10, x1 = 21, y0 = 13, y1 = 18; ///< part of the picture, with the caustic of a ball of glass

/// A lamp of radiant intensity 1 towards all sides. \param radius 0: a point
std::string lamp(double radius) {
    if (radius == 0) return "LightSource \"point\" \"rgb I\" [1 1 1] \"point3 from\" [.8 2.2 .9]\n";
    // A ball's intensity is its radiance times its outline's area.
    return fmt::format("AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [{0} {0} {0}]\nTranslate .8 2.2 .9\n"
                       "Material \"diffuse\" \"rgb reflectance\" [0 0 0]\nShape \"sphere\" \"float radius\" {1}\n"
                       "AttributeEnd\n",
                       1 / (double(piD) * radius * radius), radius);
}

/// The camera looks into a wall of silver and sees the floor behind itself.
std::string mirrored(const std::string& integrator, double lampRadius) {
    return fmt::format("LookAt 0 .9 -.3  -.235 0 -2.51  0 1 0\nCamera \"perspective\" \"float fov\" 25\n"
                       "Film \"rgb\" \"integer xresolution\" 32 \"integer yresolution\" 32 "
                       "\"integer pixelbounds\" [{} {} {} {}]\nSampler \"independent\"\nPixelFilter \"box\"\n"
                       "Integrator {}\nWorldBegin\n",
                       x0, x1, y0, y1, integrator) +
           "Material \"conductor\" \"spectrum eta\" \"metal-Ag-eta\" \"spectrum k\" \"metal-Ag-k\"\n"
           "Shape \"bilinearmesh\" \"point3 P\" [-2 -.001 -1  2 -.001 -1  -2 3 -1  2 3 -1]\n"
           "Material \"diffuse\" \"spectrum reflectance\" [300 .7 900 .7]\n"
           "Shape \"bilinearmesh\" \"point3 P\" [-2 0 2  2 0 2  -2 0 -1  2 0 -1]\n"
           "AttributeBegin\nMaterial \"dielectric\" \"float eta\" 1.5\nTranslate 0 .5 .6\n"
           "Shape \"sphere\" \"float radius\" .4\nAttributeEnd\n" +
           lamp(lampRadius);
}

/// Green of independent runs: the mean picture, and the mean over the picture with its error.
struct Runs {
    std::vector<double> picture = std::vector<double>(std::size_t((x1 - x0) * (y1 - y0)), 0.);
    test::Estimate mean;

    double error() const { return std::sqrt(mean.varianceOfMean()); }
};

Runs runsOf(const std::string& text, std::uint64_t passes) {
    constexpr int count = 4;
    Runs runs;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        RenderCounters counters;
        const Image image = renderText(text, seed, passes, counters);
        double sum = 0;
        for (std::size_t i = 0; i < runs.picture.size(); ++i) {
            sum += double(image.pixels[3 * i + 1]);
            runs.picture[i] += double(image.pixels[3 * i + 1]) / count;
        }
        runs.mean.add(sum / double(runs.picture.size()));
    }
    return runs;
}

/// Mean absolute difference as a part of b's mean.
double apart(const Runs& a, const Runs& b) {
    double difference = 0, sum = 0;
    for (std::size_t i = 0; i < a.picture.size(); ++i) {
        difference += std::abs(a.picture[i] - b.picture[i]);
        sum += b.picture[i];
    }
    return difference / sum;
}

TEST(Mirror, CausticOfAPointIsTheLimitOfThoseOfBalls) {
    const std::string sppm = "\"sppm\" \"integer maxdepth\" 12 \"integer photonsperiteration\" 16384 "
                             "\"float radiuspixels\" 1",
                      path = "\"path\" \"integer maxdepth\" 12";
    const Runs point = runsOf(mirrored(sppm, 0), 128);
    double before = infinityD;
    for (const double radius : {0.1, 0.05}) {
        const Runs ours = runsOf(mirrored(sppm, radius), 128), theirs = runsOf(mirrored(path, radius), 8192);
        // Disks of half a pixel move no light out of the picture, in whose middle the caustic lies, or into it, but what
        // differs on its rim: half a percent.
        const double mean = theirs.mean.mean();
        EXPECT_NEAR(ours.mean.mean(), mean, 4 * std::hypot(ours.error(), theirs.error()) + 0.005 * mean) << radius;
        EXPECT_LT(std::hypot(ours.error(), theirs.error()), 0.03 * mean) << "too noisy for a test";
        // Of the same power all bring as much light, but for the second order of (radius / distance) = 0.05.
        EXPECT_NEAR(ours.mean.mean(), point.mean.mean(),
                    4 * std::hypot(ours.error(), point.error()) + 0.005 * point.mean.mean())
            << radius;
        // The lamp's image blurs the caustic's rim as wide as the lamp: half the radius, half the difference, and the noise
        // that both have.
        const double now = apart(ours, point);
        EXPECT_LT(now, 0.75 * before);
        before = now;
        RecordProperty(fmt::format("radius{}", radius),
                       fmt::format("sppm {:.5f} +- {:.5f}, path {:.5f} +- {:.5f}, point {:.5f} +- {:.5f}, apart {:.4f}",
                                   ours.mean.mean(), ours.error(), mean, theirs.error(), point.mean.mean(),
                                   point.error(), now));
    }
    // What is left without the caustic is the shadow.
    const Runs shadow = runsOf(mirrored(path, 0), 64);
    EXPECT_GT(point.mean.mean(), 100 * shadow.mean.mean());
    RecordProperty("shadow", fmt::format("{:.6f}", shadow.mean.mean()));
}

} // namespace
} // namespace vitrine
