#include "core/random.h"
#include "film/film.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace vitrine {
namespace {

FilmSettings small(int width = 5, int height = 4) {
    FilmSettings s;
    s.resolution = s.cropMax = V2i(width, height);
    return s;
}

struct DrawnSample {
    V2i pixel;
    SampledSpectrum radiance;
    SampledWavelengths lambda;
    float weight;
    unsigned half;
};

std::vector<DrawnSample> drawSamples(const V2i& size, int count, std::uint64_t seed) {
    RandomStream random(seed);
    std::vector<DrawnSample> samples;
    for (int i = 0; i < count; ++i) {
        DrawnSample s;
        s.pixel = V2i(int(random.uniform(0, size.x)), int(random.uniform(0, size.y)));
        const float scale = std::exp(6 * random.uniform() - 3);
        for (int j = 0; j < spectrumSamples; ++j)
            s.radiance.set(j, scale * random.uniform());
        s.lambda = SampledWavelengths::visible(random.uniform());
        s.weight = random.uniform() < 0.2f ? -0.3f : 1.1f;
        s.half = random.bits() & 1;
        samples.push_back(s);
    }
    return samples;
}

void addAll(Film& film, std::span<const DrawnSample> samples) {
    for (const auto& s : samples)
        film.add(s.pixel, s.radiance, s.lambda, s.weight, s.half);
}

bool sameSums(const Film& a, const Film& b) {
    return std::ranges::equal(a.sums(), b.sums());
}

TEST(Film, OrderAndGroupingOfSamplesDoNotMatter) {
    const FilmSettings settings = small();
    std::vector<DrawnSample> samples = drawSamples(settings.resolution, 3000, 1);
    Film forward(settings), backward(settings), merged(settings);
    addAll(forward, samples);

    // Three films merged in another order.
    std::vector<Film> parts(3, Film(settings));
    for (std::size_t i = 0; i < samples.size(); ++i)
        addAll(parts[i * i % 3], std::span(samples).subspan(i, 1));
    for (std::size_t i = parts.size(); i-- > 0;)
        merged.merge(parts[i]);

    std::reverse(samples.begin(), samples.end());
    addAll(backward, samples);

    EXPECT_TRUE(sameSums(forward, backward));
    EXPECT_TRUE(sameSums(forward, merged));
    EXPECT_EQ(forward.image().pixels, merged.image().pixels);
    EXPECT_EQ(forward.estimatedRelMse(), merged.estimatedRelMse());
    EXPECT_EQ(forward.badSamples(), 0u);
}

TEST(Film, ImageIsTheWeightedMeanOfSensorValues) {
    FilmSettings settings = small(1, 1);
    settings.imagingRatio = 2;
    Film film(settings);
    const auto samples = drawSamples(settings.resolution, 50, 2);
    V3d sum(0);
    double weights = 0;
    for (const auto& s : samples) {
        const Rgb rgb = RgbColorSpace::srgb().fromXyz(sensorXyz(s.radiance, s.lambda)) * 2;
        sum += toDouble(rgb) * double(s.weight);
        weights += double(s.weight);
    }
    addAll(film, samples);
    const Image image = film.image();
    ASSERT_EQ(image.channels, 3);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(double(image.at(0, 0, c)), sum[c] / weights, 1e-5 * std::abs(sum[c] / weights) + 1e-7);
}

TEST(Film, PixelsWithoutSamplesAreBlack) {
    Film film(small());
    for (float v : film.image().pixels)
        EXPECT_EQ(v, 0);
    EXPECT_EQ(film.image().pixels.size(), 5u * 4 * 3);
}

TEST(Film, CropWindowHoldsItsOwnPixels) {
    FilmSettings settings = small(10, 8);
    settings.cropMin = V2i(3, 2);
    settings.cropMax = V2i(7, 4);
    Film film(settings);
    const SampledWavelengths lambda = SampledWavelengths::visible(0.3f);
    film.add(V2i(6, 3), SampledSpectrum(1), lambda, 1, 0);
    const Image image = film.image();
    ASSERT_EQ(V2i(image.width, image.height), V2i(4, 2));
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_EQ(image.at(x, y, 1) != 0, x == 3 && y == 1);
}

TEST(Film, LargeSensorValuesAreScaledToTheLimit) {
    FilmSettings settings = small(1, 1);
    settings.maxComponentValue = 0.5f;
    const SampledWavelengths lambda = SampledWavelengths::visible(0.5f);
    const SampledSpectrum bright(40, 30, 20, 10);
    Film film(settings);
    film.add(V2i(0, 0), bright, lambda, 1, 0);
    const Xyz xyz = sensorXyz(bright, lambda);
    const float largest = std::max({xyz.x, xyz.y, xyz.z});
    ASSERT_GT(largest, 0.5f);
    const Rgb expected = RgbColorSpace::srgb().fromXyz(xyz * (0.5f / largest));
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(film.image().at(0, 0, c), expected[c], 1e-6f);

    Film dim(settings);
    const SampledSpectrum little(0.001f);
    ASSERT_LT(sensorXyz(little, lambda).y, 0.5f);
    dim.add(V2i(0, 0), little, lambda, 1, 0);
    EXPECT_NEAR(dim.image().at(0, 0, 1), RgbColorSpace::srgb().fromXyz(sensorXyz(little, lambda)).y, 1e-8f);
}

TEST(Film, SamplesThatAreNotFiniteAreCountedAndDropped) {
    Film film(small());
    const SampledWavelengths lambda = SampledWavelengths::visible(0.4f);
    film.add(V2i(1, 1), SampledSpectrum(1), lambda, 1, 0);
    const Image before = film.image();
    film.add(V2i(1, 1), SampledSpectrum(std::nanf("")), lambda, 1, 0);
    film.add(V2i(1, 1), SampledSpectrum(infinity), lambda, 1, 1);
    film.add(V2i(1, 1), SampledSpectrum(1, 1, -infinity, 1), lambda, 1, 1);
    film.add(V2i(1, 1), SampledSpectrum(1), lambda, std::nanf(""), 1);
    film.add(V2i(1, 1), SampledSpectrum(0), lambda, infinity, 0);
    EXPECT_EQ(film.badSamples(), 5u);
    EXPECT_EQ(film.image().pixels, before.pixels);

    Film other(small());
    other.add(V2i(0, 0), SampledSpectrum(std::nanf("")), lambda, 1, 0);
    film.merge(other);
    EXPECT_EQ(film.badSamples(), 6u);
}

TEST(Film, HoldsTheSunAndStarlight) {
    const SampledWavelengths lambda = SampledWavelengths::visible(0.4f);
    // The sun has 1.6e9 nit; a spectrum of 1 has cieYIntegral.
    for (const float radiance : {1.6e9f / cieYIntegral, 1e-11f}) {
        Film film(small(1, 1));
        constexpr int samples = 20000;
        for (unsigned i = 0; i < samples; ++i)
            film.add(V2i(0, 0), SampledSpectrum(radiance), lambda, 1, i % 2);
        const Rgb expected = RgbColorSpace::srgb().fromXyz(sensorXyz(SampledSpectrum(radiance), lambda));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(film.image().at(0, 0, c) / expected[c], 1, 1e-3) << radiance;
        EXPECT_EQ(film.badSamples(), 0u);
    }
}

TEST(Film, SaturationIsReported) {
    Film film(small());
    film.add(V2i(0, 0), SampledSpectrum(1e30f), SampledWavelengths::visible(0.4f), 1, 0);
    EXPECT_EQ(film.badSamples(), 1u);
}

TEST(Film, FilmsOfOtherSizesAreNotMerged) {
    Film film(small());
    EXPECT_THROW(film.merge(Film(small(4, 5))), std::invalid_argument);
    FilmSettings cropped = small();
    cropped.cropMin = V2i(1, 0);
    EXPECT_THROW(film.merge(Film(cropped)), std::invalid_argument);
}

TEST(Film, EstimatedErrorOfKnownSums) {
    // Two pixels' worth of arithmetic by hand: halves of means 1 and 3 with weights 1 and 1, so m = 2, error 1.
    FilmSettings settings = small(1, 1);
    Film film(settings);
    EXPECT_EQ(film.estimatedRelMse(), infinityD);
    const auto put = [&](unsigned half, double value, double weight) {
        for (std::size_t c = 0; c < 3; ++c)
            film.sums()[half * 4 + c].add(value * weight);
        film.sums()[half * 4 + 3].add(weight);
    };
    put(0, 1, 1);
    EXPECT_EQ(film.estimatedRelMse(), infinityD);
    put(1, 3, 1);
    EXPECT_NEAR(film.estimatedRelMse(), 1 / (4 + 0.01), 1e-9);
    // Two samples more of mean 3 in the second half: m = 2.5, (3 - 1)^2 x 3 / 16 = 0.75.
    put(1, 3, 2);
    EXPECT_NEAR(film.estimatedRelMse(), 0.75 / (2.5 * 2.5 + 0.01), 1e-9);
}

TEST(Film, EstimatedErrorDropsTheLargestThousandth) {
    FilmSettings settings = small(100, 20);
    Film film(settings);
    for (std::size_t i = 0; i < 2000; ++i)
        for (unsigned half = 0; half < 2; ++half) {
            const double value = i < 2 ? 1000. * half : 1; // two pixels are all noise
            for (std::size_t c = 0; c < 3; ++c)
                film.sums()[i * 8 + half * 4 + c].add(value);
            film.sums()[i * 8 + half * 4 + 3].add(1);
        }
    EXPECT_EQ(film.estimatedRelMse(), 0);
    film.sums()[3 * 8].add(1.); // a third one stays in: red halves of 2 and 1, mean 1.5
    EXPECT_NEAR(film.estimatedRelMse(), 0.25 / (1.5 * 1.5 + 0.01) / 3 / 1998, 1e-12);
}

TEST(Film, ImpossibleSettingsAreRefused) {
    const auto refused = [](auto change) {
        FilmSettings s = small(100, 80);
        change(s);
        EXPECT_THROW(Film{s}, std::invalid_argument);
    };
    refused([](auto& s) { s.resolution = s.cropMax = V2i(0, 0); });
    refused([](auto& s) { s.resolution = s.cropMax = V2i(1000000, 1000000); });
    refused([](auto& s) { s.resolution = s.cropMax = V2i(-5, 3); });
    refused([](auto& s) { s.cropMin = s.cropMax; });
    refused([](auto& s) { s.cropMin.x = 90, s.cropMax.x = 20; });
    refused([](auto& s) { s.cropMin.y = -1; });
    refused([](auto& s) { s.cropMax.x = 101; });
    refused([](auto& s) { s.maxComponentValue = 0; });
    refused([](auto& s) { s.maxComponentValue = std::nanf(""); });
    refused([](auto& s) { s.imagingRatio = 0; });
    refused([](auto& s) { s.imagingRatio = infinity; });
    refused([](auto& s) { s.filter.radius.x = 0; });
}

} // namespace
} // namespace vitrine
