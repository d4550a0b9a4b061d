// Wavelengths that a pass shares.
#include "film/film.h"
#include "paths/pass_wavelengths.h"

#include <array>

namespace vitrine {
namespace {

TEST(PassWavelengths, OfAPowerOfTwoLieEvenly) {
    for (const std::uint64_t seed : {0ull, 7ull})
        for (const std::uint64_t first : {0ull, 64ull}) {
            // 64 wavelengths of 16 passes: one in each 64th of the distribution, in the same place of all.
            std::vector<float> u;
            for (std::uint64_t pass = first; pass < first + 16; ++pass)
                for (int i = 0; i < 4; ++i) {
                    const float lambda = passWavelengths(pass, seed)[i];
                    // The distribution's value by bisection over its inverse.
                    float low = 0, high = 0.25f;
                    float best = 0;
                    for (int stratum = 0; stratum < 4; ++stratum) {
                        low = 0;
                        high = 0.25f;
                        for (int step = 0; step < 30; ++step) {
                            const float middle = (low + high) / 2;
                            (SampledWavelengths::picture(middle)[stratum] < lambda ? low : high) = middle;
                        }
                        if (std::abs(SampledWavelengths::picture(low)[stratum] - lambda) < 1e-2f)
                            best = low + 0.25f * float(stratum);
                    }
                    u.push_back(best);
                }
            std::sort(u.begin(), u.end());
            for (std::size_t k = 1; k < u.size(); ++k)
                EXPECT_NEAR(u[k] - u[k - 1], 1. / 64, 2e-4) << k;
        }
}

TEST(PassWavelengths, HeroesTakeTurns) {
    std::array<int, 4> count{};
    for (std::uint64_t path = 0; path < 400; ++path)
        ++count[std::size_t(heroOf(path, 3))];
    EXPECT_THAT(count, testing::Each(100));
    EXPECT_NE(heroOf(5, 0), heroOf(5, 1));
}

TEST(PassWavelengths, HeroesOfAPathLieEvenly) {
    for (const std::uint64_t passes : {4u, 16u, 64u, 256u})
        for (const std::uint64_t path : {0u, 1u, 6u, 77u}) {
            const std::uint64_t first = 3 * passes;
            for (int stratum = 0; stratum < 4; ++stratum) {
                std::vector<std::pair<float, bool>> all; // wavelength, whether the path's hero
                for (std::uint64_t pass = first; pass < first + passes; ++pass)
                    all.emplace_back(passWavelengths(pass, 5)[stratum], stratum == heroOf(path, pass));
                // From the first pass's on, which the seed has moved up the stratum, they come in fours that share a part.
                std::sort(all.begin(), all.end());
                const float start = passWavelengths(first, 5)[stratum];
                std::rotate(all.begin(), std::find_if(all.begin(), all.end(), [&](auto w) { return w.first == start; }),
                            all.end());
                for (std::size_t k = 0; k < all.size(); k += 4)
                    EXPECT_EQ(all[k].second + all[k + 1].second + all[k + 2].second + all[k + 3].second, 1)
                        << "path " << path << " of " << passes << " passes, stratum " << stratum << ", part " << k / 4;
            }
        }
}

TEST(PassWavelengths, RotationIsUndone) {
    const SampledWavelengths lambda = passWavelengths(3, 1);
    for (int by = 0; by < 4; ++by) {
        EXPECT_EQ(lambda.rotated(by).hero(), lambda[by]);
        EXPECT_EQ(lambda.rotated(by).pdf()[0], lambda.pdf()[by]);
        const SampledSpectrum back = rotatedBack(lambda.rotated(by).lambda(), by);
        for (int i = 0; i < 4; ++i)
            EXPECT_EQ(back[i], lambda[i]);
    }
}

/// A picture of one pixel that all passes show this spectrum.
Rgb shown(const Spectrum& spectrum, std::uint64_t passes) {
    FilmSettings settings;
    settings.resolution = settings.cropMax = V2i(1, 1);
    Film film(settings);
    for (std::uint64_t pass = 0; pass < passes; ++pass) {
        const SampledWavelengths lambda = passWavelengths(pass, 0);
        film.addPassWavelengths(lambda);
        film.add(V2i(0, 0), spectrum.sample(lambda), lambda, 1, unsigned(pass & 1));
    }
    const Image image = film.image();
    return Rgb(image.pixels[0], image.pixels[1], image.pixels[2]);
}

TEST(PassWavelengths, WhiteIsWhiteFromTheFirstPassOn) {
    const Spectrum& white = RgbColorSpace::srgb().illuminant();
    const Rgb truth = shown(white, 4096);
    for (const std::uint64_t passes : {1, 3, 16}) {
        const Rgb rgb = shown(white, passes);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(rgb[c] / truth[c], 1, 1e-4) << passes << " passes, channel " << c;
    }
    // Of equal energy at all wavelengths the illuminant is not: what is left over after scaling.
    const ConstantSpectrum equal(1.f);
    const Rgb all = shown(equal, 4096), few = shown(equal, 16);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(few[c] / all[c], 1, 5e-3) << "channel " << c;
}

} // namespace
} // namespace vitrine
