#include "film/film.h"

#include "film/error_measure.h"

#include <fmt/format.h>

#include <stdexcept>

namespace vitrine {

namespace {

constexpr std::size_t sumsPerHalf = Film::sumsPerPixel / 2, weightSum = 3;
constexpr std::size_t whiteSums = 4;

FilmSettings checked(FilmSettings s) {
    const V2i size = s.cropSize();
    if (s.resolution.x <= 0 || s.resolution.y <= 0 || s.cropMin.x >= s.cropMax.x || s.cropMin.y >= s.cropMax.y)
        throw std::invalid_argument(
            fmt::format("a picture of {} x {} pixels, cropped to x {} to {} and y {} to {}, is empty", s.resolution.x,
                        s.resolution.y, s.cropMin.x, s.cropMax.x, s.cropMin.y, s.cropMax.y));
    if (s.cropMin.x < 0 || s.cropMin.y < 0 || s.cropMax.x > s.resolution.x || s.cropMax.y > s.resolution.y)
        throw std::invalid_argument("the crop window reaches out of the picture");
    if (std::int64_t(size.x) * size.y > std::int64_t(1) << 31)
        throw std::invalid_argument(
            fmt::format("a picture of {} x {} pixels is too large: 2^31 is the most", size.x, size.y));
    if (!(s.maxComponentValue > 0)) throw std::invalid_argument("the largest component value must be positive");
    if (!(s.imagingRatio > 0) || !std::isfinite(s.imagingRatio))
        throw std::invalid_argument("the imaging ratio (exposure time x ISO / 100) must be positive and finite");
    if (!s.colorSpace) s.colorSpace = &RgbColorSpace::srgb();
    return s;
}

} // namespace

Film::Film(const FilmSettings& settings) : settings_(checked(settings)), filter_(settings.filter) {
    const std::size_t pixels = std::size_t(settings_.cropSize().x) * std::size_t(settings_.cropSize().y);
    sums_.resize(pixels * sumsPerPixel + whiteSums);
    bad_.resize(pixels);
}

void Film::add(const V2i& pixel, const SampledSpectrum& radiance, const SampledWavelengths& lambda, float weight,
               unsigned half) {
    Xyz xyz = sensorXyz(radiance, lambda) * settings_.imagingRatio;
    const float largest = std::max(std::max(xyz.x, xyz.y), xyz.z);
    if (largest > settings_.maxComponentValue) xyz *= settings_.maxComponentValue / largest;
    const Rgb rgb = settings_.colorSpace->fromXyz(xyz) * weight;

    addToSums(index(pixel), rgb, weight, half);
}

void Film::addSplat(const V2i& pixel, const SampledSpectrum& value, const SampledWavelengths& lambda, unsigned half) {
    const Xyz xyz = sensorXyz(value, lambda) * settings_.imagingRatio;
    addToSums(index(pixel), settings_.colorSpace->fromXyz(xyz), 0, half);
}

void Film::addToSums(std::size_t at, const Rgb& rgb, float weight, unsigned half) {
    if (!std::isfinite(rgb.x) || !std::isfinite(rgb.y) || !std::isfinite(rgb.z) || !std::isfinite(weight)) {
        ++bad_[at];
        return;
    }
    FixedSum* sums = &sums_[at * sumsPerPixel + half * sumsPerHalf];
    bool sound = true;
    for (std::size_t c = 0; c < 3; ++c)
        sound &= sums[c].add(double(rgb[int(c)]));
    sound &= sums[weightSum].add(double(weight));
    bad_[at] += !sound;
}

void Film::addPassWavelengths(const SampledWavelengths& lambda) {
    const Rgb white =
        settings_.colorSpace->fromXyz(sensorXyz(settings_.colorSpace->illuminant().sample(lambda), lambda));
    FixedSum* sums = &sums_[pixelCount() * sumsPerPixel];
    for (std::size_t c = 0; c < 3; ++c)
        sums[c].add(double(white[int(c)]));
    sums[weightSum].add(1);
}

V3d Film::whiteScale() const {
    const FixedSum* sums = &sums_[pixelCount() * sumsPerPixel];
    const double count = sums[weightSum].value();
    if (!(count > 0)) return V3d(1);
    // By the wavelengths' own steps of a nanometre.
    V3d exact(0);
    for (int k = 0; k < int(lambdaMax - lambdaMin); ++k) {
        const float lambda = lambdaMin + float(k) + 0.5f;
        const Xyz xyz(cieX()(lambda), cieY()(lambda), cieZ()(lambda));
        exact += toDouble(settings_.colorSpace->fromXyz(xyz)) * double(settings_.colorSpace->illuminant()(lambda));
    }
    V3d scale;
    for (int c = 0; c < 3; ++c) {
        scale[c] = exact[c] * count / sums[std::size_t(c)].value();
        // A pass or two may miss a channel's part of the spectrum.
        constexpr double most = 4;
        if (!(scale[c] > 1 / most && scale[c] < most)) return V3d(1);
    }
    return scale;
}

void Film::merge(const Film& other) {
    if (other.settings_.cropMin != settings_.cropMin || other.settings_.cropMax != settings_.cropMax ||
        other.settings_.resolution != settings_.resolution)
        throw std::invalid_argument("films of different size or crop window cannot be merged");
    for (std::size_t i = 0; i < bad_.size(); ++i) {
        bool sound = true;
        for (std::size_t j = i * sumsPerPixel; j < (i + 1) * sumsPerPixel; ++j)
            sound &= sums_[j].add(other.sums_[j]);
        bad_[i] += other.bad_[i] + !sound;
    }
    for (std::size_t j = pixelCount() * sumsPerPixel; j < sums_.size(); ++j)
        sums_[j].add(other.sums_[j]);
}

Image Film::image() const {
    Image image{settings_.cropSize().x, settings_.cropSize().y, 3, {}};
    image.pixels.reserve(bad_.size() * 3);
    const V3d scale = whiteScale();
    for (std::size_t i = 0; i < bad_.size(); ++i) {
        FixedSum total[sumsPerHalf];
        for (std::size_t c = 0; c < sumsPerHalf; ++c) {
            total[c] = sums_[i * sumsPerPixel + c];
            total[c].add(sums_[i * sumsPerPixel + sumsPerHalf + c]);
        }
        const double weight = total[weightSum].value();
        for (std::size_t c = 0; c < 3; ++c)
            image.pixels.push_back(weight != 0 ? float(total[c].value() * scale[int(c)] / weight) : 0);
    }
    return image;
}

double Film::estimatedRelMse() const {
    std::vector<double> errors;
    errors.reserve(bad_.size());
    for (std::size_t i = 0; i < bad_.size(); ++i) {
        const FixedSum *a = &sums_[i * sumsPerPixel], *b = a + sumsPerHalf;
        const double wa = a[weightSum].value(), wb = b[weightSum].value();
        // Filters with negative lobes can leave sums of weights that tell nothing.
        if (!(wa > 0) || !(wb > 0)) {
            errors.push_back(infinityD);
            continue;
        }
        double error = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double difference = a[c].value() / wa - b[c].value() / wb;
            const double mean = (a[c].value() + b[c].value()) / (wa + wb);
            error += relativeSquare(sqr(difference) * wa * wb / sqr(wa + wb), mean) / 3;
        }
        errors.push_back(error);
    }
    const auto kept = withoutLargest(errors);
    double sum = 0;
    for (std::size_t i : kept)
        sum += errors[i];
    return sum / double(kept.size());
}

std::uint64_t Film::badSamples() const {
    std::uint64_t sum = 0;
    for (std::uint32_t n : bad_)
        sum += n;
    return sum;
}

std::optional<V2i> Film::firstBadPixel() const {
    const auto found = std::find_if(bad_.begin(), bad_.end(), [](std::uint32_t n) { return n > 0; });
    if (found == bad_.end()) return {};
    const int i = int(found - bad_.begin()), width = settings_.cropSize().x;
    return V2i(settings_.cropMin.x + i % width, settings_.cropMin.y + i / width);
}

ImageMetadata metadataOf(const FilmSettings& settings) {
    ImageMetadata metadata;
    metadata.fullResolution = settings.resolution;
    metadata.offset = settings.cropMin;
    // Linear sRGB has Rec.709's primaries, which is what files without chromaticities mean.
    if (!settings.colorSpace || settings.colorSpace == &RgbColorSpace::srgb()) return metadata;
    const auto& xy = settings.colorSpace->chromaticities();
    for (std::size_t i = 0; i < xy.size(); ++i) {
        metadata.chromaticities[2 * i] = xy[i].x;
        metadata.chromaticities[2 * i + 1] = xy[i].y;
    }
    return metadata;
}

} // namespace vitrine
