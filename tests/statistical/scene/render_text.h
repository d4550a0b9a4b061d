// Renders scene texts for tests of known radiance.
#pragma once

#include "scene/scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {

/// The beginning of a scene of side x side pixels. \param camera with all it needs  \param integrator type and parameters
inline std::string head(const std::string& camera, const std::string& integrator, int side = 4) {
    return fmt::format("{0}\nFilm \"rgb\" \"integer xresolution\" {1} \"integer yresolution\" {1}\n"
                       "Sampler \"zsobol\"\nPixelFilter \"box\"\nIntegrator {2}\nWorldBegin\n",
                       camera, side, integrator);
}

/// Mean of the whole picture per channel with its standard error, from independent seeds.
struct Measured {
    double mean[3], error[3];
};

/// \throws std::runtime_error if a sample was not finite
inline Image renderText(const std::string& text, std::uint64_t seed, std::uint64_t passes, RenderCounters& counters) {
    Overrides overrides;
    overrides.seed = seed;
    const Scene scene = loadSceneString(text, "<test>", overrides);
    Film film(scene.film);
    scene.integrator->addPasses(scene.world, {0, passes}, film, counters);
    if (film.badSamples() > 0) throw std::runtime_error("a sample was not finite");
    return film.image();
}

inline Measured measure(const std::string& text, std::uint64_t passes = 256, int runs = 8) {
    std::vector<std::array<double, 3>> means;
    for (int run = 0; run < runs; ++run) {
        RenderCounters counters;
        const Image image = renderText(text, std::uint64_t(1000 + run), passes, counters);
        std::array<double, 3> mean{};
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            mean[i % 3] += double(image.pixels[i]) * 3 / double(image.pixels.size());
        means.push_back(mean);
    }
    Measured m{};
    for (int c = 0; c < 3; ++c) {
        for (const auto& v : means)
            m.mean[c] += v[std::size_t(c)] / runs;
        for (const auto& v : means)
            m.error[c] += (v[std::size_t(c)] - m.mean[c]) * (v[std::size_t(c)] - m.mean[c]);
        m.error[c] = std::sqrt(m.error[c] / (double(runs) * (runs - 1)));
    }
    return m;
}

/// Expects `expected` in all channels, within 5 standard errors and a part of it for the bias of photons' disks.
/// \param noisiest the largest standard error, as a part of `expected`, with which this is a test
inline void expectRadiance(const std::string& text, double expected, std::uint64_t passes, double bias, double noisiest,
                           int runs = 8) {
    const Measured measured = measure(text, passes, runs);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(measured.mean[c], expected, 5 * measured.error[c] + bias * expected) << "channel " << c;
        EXPECT_LT(measured.error[c], noisiest * expected) << "too noisy for a test";
    }
}

/// Expects the means to agree within 4 standard errors and a bias, as a part of the path tracer's.
/// \param noisiest as expectRadiance's
inline void expectAgreement(const std::string& method, const Measured& ours, const Measured& path, double bias,
                            double noisiest) {
    for (int c = 0; c < 3; ++c) {
        const double error = std::hypot(path.error[c], ours.error[c]);
        EXPECT_NEAR(ours.mean[c], path.mean[c], 4 * error + bias * path.mean[c]) << method << " " << c;
        EXPECT_LT(error, noisiest * path.mean[c]) << method << ": too noisy for a test";
        testing::Test::RecordProperty(fmt::format("{}{}", method, c),
                                      fmt::format("{:.5f} +- {:.5f}, path {:.5f} +- {:.5f}", ours.mean[c],
                                                  ours.error[c], path.mean[c], path.error[c]));
    }
}

/// Expects grey radiance `expected`, within 5 standard errors and the rounding of RGB uplift (0.1 %).
#define EXPECT_RADIANCE(text, expected)                                                                                \
    do {                                                                                                               \
        const Measured measured = measure(text);                                                                       \
        for (int c = 0; c < 3; ++c)                                                                                    \
            EXPECT_NEAR(measured.mean[c], expected, 5 * measured.error[c] + 1e-3 * (expected)) << "channel " << c;     \
    } while (false)

} // namespace vitrine
