// The film's own estimate of its error against the error that it has.
#include "core/random.h"
#include "film/compare.h"
#include "film/film.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

/// Fills a film with noise about known means; an odd number of passes makes the halves uneven.
void addNoise(Film& film, const Image& truth, int passes, std::uint64_t seed) {
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x)
            for (int pass = 0; pass < passes; ++pass) {
                RandomStream random(seed, x, y, pass);
                const std::size_t pixel = std::size_t(y) * std::size_t(truth.width) + std::size_t(x);
                FixedSum* sums = &film.sums()[pixel * 8 + std::size_t(pass % 2) * 4];
                for (int c = 0; c < 3; ++c)
                    sums[c].add(double(truth.at(x, y, c)) * 2 * random.uniformDouble());
                sums[3].add(1);
            }
}

TEST(FilmStatistics, EstimatedErrorIsTheTrueOneForEvenAndUnevenHalves) {
    FilmSettings settings;
    settings.resolution = settings.cropMax = V2i(96, 96);
    Image truth{96, 96, 3, {}};
    RandomStream random(5);
    for (int i = 0; i < 96 * 96 * 3; ++i)
        truth.pixels.push_back(0.05f + random.uniform());
    for (int passes : {64, 65, 33}) {
        Film film(settings);
        addNoise(film, truth, passes, 17);
        const double estimate = film.estimatedRelMse(), error = compareImages(film.image(), truth).relMse;
        // Estimate and error are both sums of 27 000 squares of one normal variable: 0.9 % of deviation each, 1.2 % in
        // their ratio, a little more as bright channels count for more.
        EXPECT_NEAR(estimate / error, 1, 0.05) << passes;
    }
}

} // namespace
} // namespace vitrine
