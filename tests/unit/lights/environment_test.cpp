// Environment grids and images, and the light they make.
#include "core/random.h"
#include "lights/image_infinite_light.h"
#include "support/look_at.h"

#include <stdexcept>

namespace vitrine {
namespace {

using Mapping = EnvironmentMapping;
using Lookup = EnvironmentLookup;

const SampledWavelengths lambda = SampledWavelengths::visible(0.3f);

Image filled(int width, int height, const Rgb& rgb) {
    Image image{width, height, 3, {}};
    for (int i = 0; i < width * height; ++i)
        image.pixels.insert(image.pixels.end(), {rgb.x, rgb.y, rgb.z});
    return image;
}

void setPixel(Image& image, int x, int y, const Rgb& rgb) {
    for (int c = 0; c < 3; ++c)
        image.pixels[std::size_t((y * image.width + x) * 3 + c)] = rgb[c];
}

Image randomImage(int width, int height, std::uint64_t seed) {
    Image image = filled(width, height, Rgb(0, 0, 0));
    RandomStream random(seed);
    for (float& value : image.pixels)
        value = random.uniform();
    return image;
}

TEST(EnvironmentGrid, TexelsFillTheSphere) {
    for (const auto& grid : {EnvironmentGrid(Mapping::EqualArea, 7, 7), EnvironmentGrid(Mapping::LatLong, 12, 6)}) {
        double sum = 0;
        for (int y = 0; y < grid.height(); ++y)
            sum += grid.solidAngle(y) * grid.width();
        EXPECT_NEAR(sum, 4 * piD, 1e-12);
    }
}

TEST(EnvironmentGrid, UniformDirectionsStayInTheirTexel) {
    RandomStream random(4);
    for (const auto& grid : {EnvironmentGrid(Mapping::EqualArea, 9, 9), EnvironmentGrid(Mapping::LatLong, 64, 32)})
        for (int i = 0; i < 2000; ++i) {
            const int x = int(random.uniform() * float(grid.width())), y = int(random.uniform() * float(grid.height()));
            const V2f p((float(x) + random.uniform() * 0.98f + 0.01f) / float(grid.width()),
                        (float(y) + random.uniform() * 0.98f + 0.01f) / float(grid.height()));
            const V3f d = grid.uniformDirection(p);
            EXPECT_NEAR(d.length(), 1, 1e-6);
            const V2f square = grid.squareFromDirection(d);
            EXPECT_EQ(grid.column(square.x), x) << p;
            EXPECT_EQ(grid.row(square.y), y) << p;
        }
}

TEST(EnvironmentGrid, LatLongRunsFromXOverYAndDownFromZ) {
    const EnvironmentGrid grid(Mapping::LatLong, 8, 4);
    const auto expectSquare = [&](const V3f& d, const V2f& p) {
        EXPECT_TRUE(grid.squareFromDirection(d).equalWithAbsError(p, 1e-6f)) << d << grid.squareFromDirection(d);
    };
    expectSquare(V3f(1, 0, 0), V2f(0, 0.5f));
    expectSquare(V3f(0, 1, 0), V2f(0.25f, 0.5f));
    expectSquare(V3f(-1, 0, 0), V2f(0.5f, 0.5f));
    expectSquare(V3f(0, -1, 0), V2f(0.75f, 0.5f));
    EXPECT_NEAR(grid.squareFromDirection(V3f(0, 0, 1)).y, 0, 1e-6);
    EXPECT_NEAR(grid.squareFromDirection(V3f(0, 0, -1)).y, 1, 1e-6);
}

TEST(EnvironmentGrid, NeighboursOverTheEdgesTouch) {
    for (const auto& grid : {EnvironmentGrid(Mapping::EqualArea, 16, 16), EnvironmentGrid(Mapping::LatLong, 32, 16)}) {
        const auto centre = [&](std::size_t texel) {
            const int x = int(texel) % grid.width(), y = int(texel) / grid.width();
            return grid.uniformDirection(
                V2f((float(x) + 0.5f) / float(grid.width()), (float(y) + 0.5f) / float(grid.height())));
        };
        // No further apart than two texels' diagonals near the middle of the picture.
        const float far = 4 * std::sqrt(4 * pi / float(grid.width() * grid.height()));
        for (int i = 0; i < grid.width(); ++i) {
            EXPECT_LT((centre(grid.texel(i, -1)) - centre(grid.texel(i, 0))).length(), far) << i;
            EXPECT_LT((centre(grid.texel(i, grid.height())) - centre(grid.texel(i, grid.height() - 1))).length(), far);
        }
        for (int i = 0; i < grid.height(); ++i) {
            EXPECT_LT((centre(grid.texel(-1, i)) - centre(grid.texel(0, i))).length(), far) << i;
            EXPECT_LT((centre(grid.texel(grid.width(), i)) - centre(grid.texel(grid.width() - 1, i))).length(), far);
        }
        for (int y : {-1, grid.height()})
            for (int x : {-1, grid.width()})
                EXPECT_LT(grid.texel(x, y), std::size_t(grid.width() * grid.height())) << "corners stay inside";
    }
}

TEST(EnvironmentGrid, EdgesLeadToWhereTheSphereGoesOn) {
    const EnvironmentGrid square(Mapping::EqualArea, 4, 4);
    EXPECT_EQ(square.texel(-1, 1), 2u * 4 + 0) << "mirrored in the edge's middle";
    EXPECT_EQ(square.texel(4, 0), 3u * 4 + 3);
    EXPECT_EQ(square.texel(1, -1), 2u);
    EXPECT_EQ(square.texel(0, 4), 3u * 4 + 3);
    EXPECT_EQ(square.texel(-1, -1), 3u * 4 + 3) << "all corners are -z";
    const EnvironmentGrid latLong(Mapping::LatLong, 8, 4);
    EXPECT_EQ(latLong.texel(-1, 2), 2u * 8 + 7) << "round";
    EXPECT_EQ(latLong.texel(8, 2), 2u * 8 + 0);
    EXPECT_EQ(latLong.texel(1, -1), 5u) << "over the pole to the opposite meridian";
    EXPECT_EQ(latLong.texel(6, 4), 3u * 8 + 2);
}

TEST(EnvironmentImage, ConstantImageIsTheIlluminant) {
    RandomStream random(8);
    const auto& srgb = RgbColorSpace::srgb();
    const Rgb rgb(0.5f, 2, 0.25f);
    const SampledSpectrum expected = RgbIlluminantSpectrum(srgb, rgb).sample(lambda);
    for (Lookup lookup : {Lookup::Nearest, Lookup::Bilinear})
        for (const auto& image : {EnvironmentImage(filled(5, 5, rgb), srgb, Mapping::EqualArea, lookup),
                                  EnvironmentImage(filled(8, 4, rgb), srgb, Mapping::LatLong, lookup)}) {
            for (int i = 0; i < 100; ++i) {
                const auto l = image.radiance(V2f(random.uniform(), random.uniform()), lambda);
                for (int k = 0; k < spectrumSamples; ++k)
                    EXPECT_NEAR(l[k], expected[k], 1e-4 * expected[k]);
            }
            for (float mean : image.texelMeans())
                EXPECT_NEAR(mean, 2.75 / 3, 1e-6);
            for (int k = 0; k < spectrumSamples; ++k)
                EXPECT_NEAR(image.mean().sample(lambda)[k], expected[k], 1e-3 * expected[k]);
        }
}

TEST(EnvironmentImage, BilinearMeetsTexelsAtCentresAndNeverJumps) {
    const auto& srgb = RgbColorSpace::srgb();
    for (const auto& [mapping, width, height] :
         {std::tuple{Mapping::EqualArea, 6, 6}, std::tuple{Mapping::LatLong, 12, 6}}) {
        const Image pixels = randomImage(width, height, 3);
        const EnvironmentImage nearest(pixels, srgb, mapping, Lookup::Nearest);
        const EnvironmentImage bilinear(pixels, srgb, mapping, Lookup::Bilinear);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const V2f centre((float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height));
                EXPECT_NEAR(bilinear.radiance(centre, lambda)[0], nearest.radiance(centre, lambda)[0], 1e-3);
            }
        // Walk round great circles, over edges and poles.
        RandomStream random(5);
        const int steps = 20000;
        const float largest = RgbIlluminantSpectrum(srgb, Rgb(1, 1, 1)).sample(lambda)[0];
        for (int circle = 0; circle < 5; ++circle) {
            const V3d a = V3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
            const V3d b = a.cross(V3d(0.3, 0.4, 0.5)).normalized();
            float before = -1;
            for (int i = 0; i <= steps; ++i) {
                const double t = 2 * piD * i / steps;
                const V3f d = toFloat(a * std::cos(t) + b * std::sin(t));
                const float l = bilinear.radiance(bilinear.grid().squareFromDirection(d), lambda)[0];
                // Near poles of LatLong a step crosses several texels: circles that pass so near are rare and excused.
                const bool excused = mapping == Mapping::LatLong && std::hypot(d.x, d.y) < 0.02f;
                if (before >= 0 && !excused) {
                    EXPECT_LT(std::abs(l - before), 0.03f * largest) << d;
                }
                before = l;
            }
        }
    }
}

TEST(EnvironmentImage, TexelMeansAreTheMeansOfTheLookups) {
    const auto& srgb = RgbColorSpace::srgb();
    for (Lookup lookup : {Lookup::Nearest, Lookup::Bilinear}) {
        Image pixels = filled(4, 4, Rgb(0, 0, 0));
        setPixel(pixels, 1, 2, Rgb(3, 3, 3));
        setPixel(pixels, 0, 0, Rgb(1, 1, 1));
        const EnvironmentImage image(pixels, srgb, Mapping::EqualArea, lookup);
        const float white = RgbIlluminantSpectrum(srgb, Rgb(1, 1, 1)).sample(lambda)[0];
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) {
                double sum = 0;
                const int n = 64; // even: no cell straddles the creases at the texel's middle
                for (int j = 0; j < n; ++j)
                    for (int i = 0; i < n; ++i)
                        sum += image.radiance(
                                   V2f((float(x) + (float(i) + 0.5f) / n) / 4, (float(y) + (float(j) + 0.5f) / n) / 4),
                                   lambda)[0] /
                               white / (n * n);
                EXPECT_NEAR(image.texelMeans()[std::size_t(y * 4 + x)], sum, 1e-3) << x << " " << y;
            }
    }
}

TEST(EnvironmentImage, NegativeIsBlackAndNonsenseRefused) {
    const auto& srgb = RgbColorSpace::srgb();
    const EnvironmentImage black(filled(2, 2, Rgb(-1, -2, 0)), srgb, Mapping::EqualArea, Lookup::Bilinear);
    EXPECT_TRUE(black.radiance(V2f(0.3f, 0.6f), lambda).isBlack());
    const auto make = [&](const Image& image, Mapping mapping) {
        EnvironmentImage(image, srgb, mapping, Lookup::Nearest);
    };
    EXPECT_THROW(make(filled(4, 2, Rgb(1)), Mapping::EqualArea), std::invalid_argument);
    EXPECT_THROW(make(filled(4, 4, Rgb(1)), Mapping::LatLong), std::invalid_argument);
    EXPECT_THROW(make(Image(), Mapping::EqualArea), std::invalid_argument);
    EXPECT_THROW(make(Image{2, 2, 1, std::vector<float>(4, 1.f)}, Mapping::EqualArea), std::invalid_argument);
    for (float bad : {infinity, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_THROW(make(filled(2, 2, Rgb(1, bad, 1)), Mapping::EqualArea), std::invalid_argument);
}

TEST(ImageInfiniteLight, ScaleAndIlluminanceFollowPbrt) {
    const auto& srgb = RgbColorSpace::srgb();
    const double white = photometric(srgb.illuminant());
    const Image image = filled(32, 32, Rgb(1, 1, 1));
    ImageInfiniteLight::Parameters parameters;
    parameters.scale = 3;
    const V3f up(0, 0, 1);
    const double plain = ImageInfiniteLight::create(Transform(), image, parameters)->escaped(up, lambda)[0];
    const double expected = 3 / white * RgbIlluminantSpectrum(srgb, Rgb(1, 1, 1)).sample(lambda)[0];
    EXPECT_NEAR(plain, expected, 1e-4 * expected);
    // pbrt counts half of the upper half's illuminance, pi / 2 for a constant image of one nit.
    parameters.illuminance = 10;
    const double lit = ImageInfiniteLight::create(Transform(), image, parameters)->escaped(up, lambda)[0];
    // To the accuracy of its sum over texel centres.
    EXPECT_NEAR(lit / plain, 10 / (piD / 2), 0.05);
    EXPECT_THROW(ImageInfiniteLight::create(Transform(), filled(4, 4, Rgb(0, 0, 0)), parameters),
                 std::invalid_argument);
    parameters.mapping = Mapping::LatLong;
    const double latLong =
        ImageInfiniteLight::create(Transform(), filled(64, 32, Rgb(1, 1, 1)), parameters)->escaped(up, lambda)[0];
    EXPECT_NEAR(latLong / lit, 1, 0.01) << "both mappings alike";
}

TEST(ImageInfiniteLight, TurnsWithItsSpace) {
    Image pixels = filled(8, 8, Rgb(0, 0, 0));
    for (int y = 3; y <= 4; ++y)
        for (int x = 3; x <= 4; ++x)
            setPixel(pixels, x, y, Rgb(1, 1, 1)); // about +z
    const EnvironmentImage image(pixels, RgbColorSpace::srgb(), Mapping::EqualArea, Lookup::Nearest);
    const M44d zToX(0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 5, 6, 7, 1),
        mirrored(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1);
    const M44d doubled(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1);
    for (const auto& [matrix, lit] : {std::pair{M44d(), V3f(0, 0, 1)}, std::pair{zToX, V3f(1, 0, 0)},
                                      std::pair{mirrored, V3f(0, 0, -1)}, std::pair{doubled, V3f(0, 0, 1)}}) {
        const ImageInfiniteLight light(Transform(matrix), image, 1);
        EXPECT_FALSE(light.escaped(lit, lambda).isBlack());
        EXPECT_TRUE(light.escaped(-lit, lambda).isBlack());
        const auto sample = light.sample(V3d(3), V2f(0.4f, 0.7f), lambda);
        ASSERT_TRUE(sample);
        EXPECT_GT(sample->wi.dot(lit), 0.8f);
        EXPECT_NEAR(sample->wi.length(), 1, 1e-6);
    }
    const M44d squashed(1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1),
        sheared(1, 0, 0, 0, 0.3, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    for (const M44d& matrix : {squashed, sheared})
        EXPECT_THROW(ImageInfiniteLight(Transform(matrix), image, 1), std::invalid_argument);
}

TEST(ImageInfiniteLight, PowerIsThatOfTheMean) {
    Image pixels = filled(4, 4, Rgb(0, 0, 0));
    setPixel(pixels, 2, 1, Rgb(16, 16, 16));
    ImageInfiniteLight light(
        Transform(), EnvironmentImage(pixels, RgbColorSpace::srgb(), Mapping::EqualArea, Lookup::Nearest), 0.5f);
    light.preprocess(V3d(0), 3);
    const double mean = 0.5 * RgbIlluminantSpectrum(RgbColorSpace::srgb(), Rgb(1, 1, 1)).sample(lambda)[2];
    const double expected = 4 * piD * piD * 9 * mean;
    EXPECT_NEAR(light.power(lambda)[2], expected, 1e-4 * expected);
}

} // namespace
} // namespace vitrine
