// The reference pictures (tests/images/references/README.md), and the same scenes rendered by Vitrine.
#pragma once

#include "scene/scene.h"
#include "support/npy.h"

#include <fmt/format.h>

namespace vitrine {

inline std::string referenceFile(const std::string& name, const std::string& ending) {
    return fmt::format("{}/tests/images/references/{}{}", VITRINE_SOURCE_DIR, name, ending);
}

/// Picture and the variance of its pixels.
struct ReferencePicture {
    int width = 0, height = 0;
    std::vector<double> means, variances;

    std::size_t index(int x, int y, int c) const {
        return (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 3 + std::size_t(c);
    }
    double mean(int x, int y, int c) const { return means[index(x, y, c)]; }
    double variance(int x, int y, int c) const { return variances[index(x, y, c)]; }
};

inline ReferencePicture readReference(const std::string& name) {
    const auto arrays = test::readNpz(referenceFile(name, ".npz"));
    const test::NpyArray &mean = arrays.at("mean"), &variance = arrays.at("var");
    return {int(mean.shape[1]), int(mean.shape[0]), std::vector<double>(mean.values.begin(), mean.values.end()),
            std::vector<double>(variance.values.begin(), variance.values.end())};
}

/// Mean of a rectangle of one channel.
template <class At>
double meanOf(int x0, int y0, int x1, int y1, At&& at) {
    double sum = 0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            sum += at(x, y);
    return sum / (double(x1 - x0) * (y1 - y0));
}

/// The reference scene after each of the numbers of passes (rising). \throws std::runtime_error for samples that are not
/// finite
inline std::vector<Image> renderReference(const std::string& name, const Overrides& overrides,
                                          const std::vector<std::uint64_t>& passes) {
    const Scene scene = loadScene(referenceFile(name, ".pbrt"), overrides);
    Film film(scene.film);
    RenderCounters counters;
    std::vector<Image> images;
    std::uint64_t done = 0;
    for (const std::uint64_t count : passes) {
        scene.integrator->addPasses(scene.world, {done, count}, film, counters);
        done = count;
        images.push_back(film.image());
    }
    if (film.badSamples() > 0) throw std::runtime_error("a sample was not finite");
    return images;
}

} // namespace vitrine
