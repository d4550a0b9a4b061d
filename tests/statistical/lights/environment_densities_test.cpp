// Environment images of the hard kind: samples against densities, and light by samples against light by all directions.
#include "core/equal_area.h"
#include "lights/image_infinite_light.h"
#include "support/chi_squared.h"
#include "support/estimate.h"

namespace vitrine {
namespace {

using Mapping = EnvironmentMapping;
using Lookup = EnvironmentLookup;

const SampledWavelengths lambda = SampledWavelengths::visible(0.5f);

Image grey(int width, int height, float value) {
    return {width, height, 3, std::vector<float>(std::size_t(width * height) * 3, value)};
}

void set(Image& image, int x, int y, float value) {
    for (int c = 0; c < 3; ++c)
        image.pixels[std::size_t((y * image.width + x) * 3 + c)] = value;
}

struct EnvironmentCase {
    std::string name;
    Image image;
    Mapping mapping;
    Lookup lookup;
};

/// One bright texel in the black and over a dim sky, a lit corner (a pole), a black half, noise.
std::vector<EnvironmentCase> environmentCases() {
    std::vector<EnvironmentCase> cases;
    for (const auto& [mapping, width, height, mappingName] :
         {std::tuple{Mapping::EqualArea, 12, 12, "equal area"}, std::tuple{Mapping::LatLong, 16, 8, "lat-long"}}) {
        Image texel = grey(width, height, 0), sun = grey(width, height, 0.01f), corner = texel, half = texel,
              noise = texel;
        set(texel, width / 2 + 1, 2, 1000);
        set(sun, width / 2 + 1, 2, 1000);
        set(corner, 0, 0, 1);
        RandomStream random(31);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                if (y >= height / 2) set(half, x, y, 1 + float(x % 3));
                set(noise, x, y, float(std::exp(random.uniform(-3, 3))));
            }
        for (Lookup lookup : {Lookup::Nearest, Lookup::Bilinear}) {
            const std::string suffix =
                std::string(", ") + mappingName + (lookup == Lookup::Nearest ? ", nearest" : ", bilinear");
            cases.push_back({"one texel" + suffix, texel, mapping, lookup});
            cases.push_back({"sun and sky" + suffix, sun, mapping, lookup});
            cases.push_back({"corner" + suffix, corner, mapping, lookup});
            cases.push_back({"black half" + suffix, half, mapping, lookup});
            cases.push_back({"noise" + suffix, noise, mapping, lookup});
        }
    }
    return cases;
}

ImageInfiniteLight lightOf(const EnvironmentCase& c, const Transform& worldFromLight = Transform()) {
    return ImageInfiniteLight(worldFromLight, EnvironmentImage(c.image, RgbColorSpace::srgb(), c.mapping, c.lookup), 1);
}

/// A point of the unit square as direction, with the solid angle per area there.
std::pair<V3f, double> directionOfSquare(Mapping mapping, const V2f& s) {
    if (mapping == Mapping::EqualArea) return {toFloat(equalAreaSquareToSphere(V2d(s.x, s.y))), 4 * piD};
    const double phi = 2 * piD * s.x, theta = piD * s.y;
    const V3d d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    return {toFloat(d), 2 * piD * piD * std::sin(theta)};
}

/// In the picture's own square, where the edges of texels and of their halves are the cells' edges.
TEST(EnvironmentDensities, SamplesFollowTheDensity) {
    const auto cases = environmentCases();
    const double threshold = test::sidakThreshold(0.01, int(cases.size()));
    for (const EnvironmentCase& c : cases) {
        const ImageInfiniteLight light = lightOf(c);
        const EnvironmentGrid grid(c.mapping, c.image.width, c.image.height);
        test::ChiSquaredSettings settings;
        settings.rows = 2 * c.image.height;
        settings.columns = 2 * c.image.width;
        const auto result = test::chiSquaredSquare(
            [&](RandomStream& random) -> std::optional<V2f> {
                const auto sample = light.sample(V3d(0), V2f(random.uniform(), random.uniform()), lambda);
                if (!sample) return {};
                return grid.squareFromDirection(sample->wi);
            },
            [&](const V2f& s) {
                const auto [d, solidAngle] = directionOfSquare(c.mapping, s);
                // Bilinear lookups leave parts of drawn texels black: from there sample() gives nothing.
                return light.escaped(d, lambda).isBlack() ? 0 : light.pdf(d) * solidAngle;
            },
            settings);
        EXPECT_GT(result.pValue, threshold) << c.name << ": " << result.report;
        if (c.lookup == Lookup::Nearest) {
            EXPECT_NEAR(result.mass, 1, 1e-3) << c.name;
        }
        EXPECT_GT(result.mass, 0.5) << c.name;
    }
}

/// A turned and mirrored smooth sky, over the sphere of the world.
TEST(EnvironmentDensities, TurnedSky) {
    EnvironmentCase c{"", grey(32, 32, 0), Mapping::EqualArea, Lookup::Bilinear};
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const V3f d = equalAreaSquareToSphere(V2f((float(x) + 0.5f) / 32, (float(y) + 0.5f) / 32));
            set(c.image, x, y, std::exp(2 * d.dot(V3f(0.6f, 0, 0.8f))));
        }
    const Transform turn(M44d(0.8, 0.6, 0, 0, -0.36, 0.48, 0.8, 0, -0.48, 0.64, -0.6, 0, 3, -2, 1, 1));
    ASSERT_TRUE(turn.swapsHandedness());
    const ImageInfiniteLight light = lightOf(c, turn);
    const auto result = test::chiSquaredSphere(
        [&](RandomStream& random) {
            return std::optional(light.sample(V3d(0), V2f(random.uniform(), random.uniform()), lambda)->wi);
        },
        [&](const V3f& w) { return double(light.pdf(w)); });
    EXPECT_GT(result.pValue, 0.01) << result.report;
    EXPECT_NEAR(result.mass, 1, 2e-3);
    // Where it is brightest in the world.
    const V3f bright = toFloat(turn.vector(V3d(0.6, 0, 0.8)));
    EXPECT_GT(light.pdf(bright), 30 * light.pdf(-bright));
}

/// Radiant flux density through all directions with a weight that varies, by samples of the light and by a fine grid of
/// directions through escaped(): nothing that shines may be missed, and nothing weighed wrongly.
TEST(EnvironmentDensities, SampledLightIsAllTheLight) {
    const auto weight = [](const V3f& w) { return 1.2f + w.x * w.z + 0.5f * w.y; };
    const auto cases = environmentCases();
    const double threshold = test::sidakThreshold(0.01, int(cases.size()));
    std::uint64_t seed = 0;
    for (const EnvironmentCase& c : cases) {
        const ImageInfiniteLight light = lightOf(c);
        // The midpoint rule over cells that divide the texels and, for bilinear lookups, their halves.
        const int perTexel = 24, width = c.image.width * perTexel, height = c.image.height * perTexel;
        double exact = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const V2f s((float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height));
                const auto [d, solidAngle] = directionOfSquare(c.mapping, s);
                exact += double(light.escaped(d, lambda)[0] * weight(d)) * solidAngle / (double(width) * height);
            }
        RandomStream random(41, seed++);
        test::Estimate sampled;
        double largest = 0;
        for (int i = 0; i < 100000; ++i) {
            const auto sample = light.sample(V3d(0), V2f(random.uniform(), random.uniform()), lambda);
            const double value = sample ? sample->l[0] / sample->pdf * weight(sample->wi) : 0;
            sampled.add(value);
            largest = std::max(largest, value);
            if (!sample) continue;
            EXPECT_EQ(sample->pdf, light.pdf(sample->wi)) << "what MIS weighs is what was drawn";
            EXPECT_EQ(sample->l[0], light.escaped(sample->wi, lambda)[0]);
        }
        // The midpoint rule's own error beside the noise.
        const double z = (sampled.mean() - exact) / std::sqrt(sampled.varianceOfMean() + sqr(3e-4 * exact));
        EXPECT_GT(test::normalPValue(z), threshold) << c.name << ": " << sampled.mean() << " sampled, " << exact;
        // Bilinear lookups vary within a texel, at most from its mean to the peak of a lone bright texel's corner.
        EXPECT_LT(largest, 40 * exact) << c.name << ": a firefly";
    }
}

} // namespace
} // namespace vitrine
