#include "film/compare.h"

#include "film/error_measure.h"
#include "film/ssim.h"

#include <fmt/format.h>

#include <stdexcept>

namespace vitrine {

namespace {

void requireSameSize(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height || a.channels != b.channels)
        throw std::invalid_argument(
            fmt::format("the pictures differ in size: {} x {} pixels of {} channels against {} x {} of {}", a.width,
                        a.height, a.channels, b.width, b.height, b.channels));
    if (a.channels < 1 || a.pixels.empty()) throw std::invalid_argument("pictures without pixels cannot be compared");
}

std::span<const float> pixelOf(const Image& image, std::size_t pixel) {
    const auto channels = std::size_t(image.channels);
    return std::span(image.pixels).subspan(pixel * channels, channels);
}

bool isFinitePixel(const Image& image, std::size_t pixel) {
    const auto values = pixelOf(image, pixel);
    return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

/// The pixels that both pictures have a value for.
std::vector<std::size_t> comparablePixels(const Image& a, const Image& b, Comparison& result) {
    std::vector<std::size_t> pixels;
    const std::size_t count = std::size_t(a.width) * std::size_t(a.height);
    for (std::size_t i = 0; i < count; ++i) {
        const bool soundA = isFinitePixel(a, i), soundB = isFinitePixel(b, i);
        result.badPixelsA += !soundA;
        result.badPixelsB += !soundB;
        if (soundA && soundB) pixels.push_back(i);
    }
    return pixels;
}

double relMseOf(const Image& a, const Image& b, const Image* variance, const std::vector<std::size_t>& pixels) {
    std::vector<double> errors, noise;
    for (std::size_t i : pixels) {
        const auto pa = pixelOf(a, i), pb = pixelOf(b, i);
        double error = 0, own = 0;
        for (std::size_t c = 0; c < pa.size(); ++c) {
            error += relativeSquare(sqr(double(pa[c]) - double(pb[c])), double(pb[c]));
            if (variance) own += relativeSquare(double(pixelOf(*variance, i)[c]), double(pb[c]));
        }
        errors.push_back(error / double(pa.size()));
        noise.push_back(own / double(pa.size()));
    }
    double sum = 0;
    const auto kept = withoutLargest(errors);
    for (std::size_t i : kept)
        sum += errors[i] - noise[i];
    return sum / double(kept.size());
}

void addMeans(const Image& a, const Image& b, const std::vector<std::size_t>& pixels, Comparison& result) {
    const auto channels = std::size_t(a.channels);
    std::vector<double> sumA(channels), sumB(channels);
    double squares = 0;
    result.peak = 1;
    for (std::size_t i : pixels)
        for (std::size_t c = 0; c < channels; ++c) {
            const double va = pixelOf(a, i)[c], vb = pixelOf(b, i)[c];
            sumA[c] += va;
            sumB[c] += vb;
            squares += sqr(va - vb);
            result.peak = std::max(result.peak, vb);
        }
    for (std::size_t c = 0; c < channels; ++c)
        result.meanRatio.push_back(sumA[c] == sumB[c] ? 1 : sumA[c] / sumB[c]);
    result.mse = squares / double(pixels.size() * channels);
    result.psnr = 10 * std::log10(sqr(result.peak) / result.mse);
}

} // namespace

float luminance(const Image& image, std::size_t pixel) {
    const auto p = pixelOf(image, pixel);
    return p.size() < 3 ? p[0] : 0.2126f * p[0] + 0.7152f * p[1] + 0.0722f * p[2];
}

Comparison compareImages(const Image& a, const Image& b, const Image* variance) {
    requireSameSize(a, b);
    if (variance) requireSameSize(*variance, b);
    Comparison result;
    const auto pixels = comparablePixels(a, b, result);
    if (pixels.empty()) throw std::invalid_argument("no pixel is finite in both pictures");
    result.pixels = pixels.size();
    result.relMse = relMseOf(a, b, variance, pixels);
    addMeans(a, b, pixels, result);
    result.ssim = meanSsim(a, b, result.peak);
    return result;
}

Image heatMap(const Image& a, const Image& b, float range) {
    requireSameSize(a, b);
    Image map{a.width, a.height, 3, {}};
    const std::size_t count = std::size_t(a.width) * std::size_t(a.height);
    map.pixels.reserve(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        if (!isFinitePixel(a, i) || !isFinitePixel(b, i)) {
            map.pixels.insert(map.pixels.end(), {1, 1, 0});
            continue;
        }
        const float reference = luminance(b, i);
        const float difference = (luminance(a, i) - reference) / ((std::abs(reference) + 0.1f) * range);
        const float strength = std::min(std::abs(difference), 1.f);
        map.pixels.insert(map.pixels.end(), {difference > 0 ? strength : 0, 0, difference < 0 ? strength : 0});
    }
    return map;
}

} // namespace vitrine
