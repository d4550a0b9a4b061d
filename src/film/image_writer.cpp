#include "core/errors.h"
#include "core/replace_file.h"
#include "film/imageio.h"
#include "film/primaries.h"
#include "film/srgb.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <cstring>

namespace vitrine {

namespace {

using Bytes = std::vector<unsigned char>;

/// What encoding needs; `path` for the messages and the choice of OpenImageIO's writer.
struct Picture {
    const std::string& path;
    const Image& image;
    const ImageMetadata& metadata;
};

/// Encodes in memory: OpenImageIO does not report every failed write to a disk.
Bytes encode(const Picture& picture, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* pixels) {
    Bytes bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(picture.path);
    if (!output) throw FileError(picture.path, "cannot be encoded: " + OIIO::geterror());
    if (!output->set_ioproxy(&memory) || !output->open(picture.path, spec) || !output->write_image(type, pixels) ||
        !output->close())
        throw FileError(picture.path, "cannot be encoded: " + output->geterror());
    return bytes;
}

OIIO::ImageSpec specOf(const Image& image, OIIO::TypeDesc type) {
    return OIIO::ImageSpec(image.width, image.height, image.channels, type);
}

void addMetadata(OIIO::ImageSpec& spec, const ImageMetadata& metadata) {
    for (const auto& [name, value] : metadata.numbers) {
        if (value == std::rint(value) && std::abs(value) < 2147483648.)
            spec.attribute(name, int(value));
        else
            spec.attribute(name, float(value));
    }
    for (const auto& [name, value] : metadata.strings)
        spec.attribute(name, value);
    for (const auto& [name, matrix] : metadata.matrices) {
        float m[16];
        for (int i = 0; i < 16; ++i)
            m[i] = float(matrix[i / 4][i % 4]);
        spec.attribute(name, OIIO::TypeMatrix, m);
    }
    if (std::any_of(std::begin(metadata.chromaticities), std::end(metadata.chromaticities),
                    [](float c) { return c != 0; }))
        spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), metadata.chromaticities);
}

Bytes encodeExr(const Picture& picture) {
    const Image& image = picture.image;
    OIIO::ImageSpec spec = specOf(image, OIIO::TypeFloat);
    static const std::vector<std::string> names[] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    if (!picture.metadata.channelNames.empty())
        spec.channelnames = picture.metadata.channelNames;
    else if (image.channels <= 4)
        spec.channelnames = names[image.channels - 1];
    else
        spec.channelnames.clear();
    if (int(spec.channelnames.size()) != image.channels)
        throw FileError(picture.path,
                        fmt::format("{} channels, but {} names of channels", image.channels, spec.channelnames.size()));

    spec.x = picture.metadata.offset.x;
    spec.y = picture.metadata.offset.y;
    if (picture.metadata.fullResolution != V2i(0, 0)) {
        spec.full_width = picture.metadata.fullResolution.x;
        spec.full_height = picture.metadata.fullResolution.y;
    }
    addMetadata(spec, picture.metadata);
    spec.attribute("compression", "zip");
    // OpenImageIO writes the present time unless there is a date; one of the wrong type is left out (and spoken of, in
    // builds that print debugging messages).
    OIIO::attribute("debug", 0);
    spec.attribute("DateTime", 0);
    return encode(picture, spec, OIIO::TypeFloat, image.pixels.data());
}

Bytes encodeBytes(const Picture& picture) {
    OIIO::ImageSpec spec = specOf(picture.image, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("Compression", "jpeg:95");
    spec.attribute("jpeg:subsampling", "4:4:4"); // coloured caustics are a pixel wide
    Bytes codes(picture.image.pixels.size());
    std::transform(picture.image.pixels.begin(), picture.image.pixels.end(), codes.begin(), srgbByte);
    return encode(picture, spec, OIIO::TypeUInt8, codes.data());
}

/// Rounds to what 8 bits each and a shared exponent hold, as OpenImageIO would cut the rest off.
V3f roundedToRgbe(const V3f& rgb) {
    V3f c;
    for (int i = 0; i < 3; ++i)
        c[i] = rgb[i] > 0 ? std::min(rgb[i], 0x1.fep126f) : 0;
    const float largest = std::max({c.x, c.y, c.z});
    if (!(largest > 0)) return V3f(0);
    int exponent;
    std::frexp(largest, &exponent);
    // The largest may round up to the next power of two: then there is one bit less for all.
    if (std::rint(std::ldexp(largest, 8 - exponent)) >= 256) ++exponent;
    for (int i = 0; i < 3; ++i)
        c[i] = std::ldexp(std::rint(std::ldexp(c[i], 8 - exponent)), exponent - 8);
    return c;
}

Bytes encodeHdr(const Picture& picture) {
    const Image& image = picture.image;
    OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeFloat); // the format has no grey
    std::vector<float> pixels;
    pixels.reserve(std::size_t(image.width) * std::size_t(image.height) * 3);
    const auto channels = std::size_t(image.channels);
    for (std::size_t i = 0; i < image.pixels.size(); i += channels) {
        const float* p = &image.pixels[i];
        const V3f c = roundedToRgbe(channels == 3 ? V3f(p[0], p[1], p[2]) : V3f(p[0]));
        pixels.insert(pixels.end(), {c.x, c.y, c.z});
    }
    return encode(picture, spec, OIIO::TypeFloat, pixels.data());
}

/// Portable float map, which OpenImageIO 2.4 reads but does not write: rows from the bottom up; -1: little-endian.
Bytes encodePfm(const Picture& picture) {
    const Image& image = picture.image;
    const std::string header =
        fmt::format("{}\n{} {}\n-1.0\n", image.channels == 1 ? "Pf" : "PF", image.width, image.height);
    Bytes bytes(header.begin(), header.end());
    const std::size_t row = std::size_t(image.width) * std::size_t(image.channels) * sizeof(float);
    bytes.resize(header.size() + row * std::size_t(image.height));
    for (int y = 0; y < image.height; ++y)
        std::memcpy(&bytes[header.size() + row * std::size_t(image.height - 1 - y)],
                    reinterpret_cast<const char*>(image.pixels.data()) + row * std::size_t(y), row);
    return bytes;
}

struct Format {
    const char* extension;
    bool anyChannels; ///< else one or three
    Bytes (*encode)(const Picture&);
};

constexpr Format formats[] = {{"exr", true, encodeExr},    {"hdr", false, encodeHdr}, {"jpeg", false, encodeBytes},
                              {"jpg", false, encodeBytes}, {"pfm", false, encodePfm}, {"png", false, encodeBytes},
                              {"ppm", false, encodeBytes}};

const Format& formatOf(const std::string& path) {
    const std::size_t slash = path.find_last_of('/'), dot = path.find_last_of('.');
    const bool hasExtension = dot != std::string::npos && (slash == std::string::npos || dot > slash);
    std::string extension = hasExtension ? path.substr(dot + 1) : std::string();
    for (char& c : extension)
        c = char(std::tolower(static_cast<unsigned char>(c)));
    std::vector<std::string> known;
    for (const Format& format : formats) {
        if (extension == format.extension) return format;
        known.push_back(format.extension);
    }
    std::string hint = didYouMean(extension, known);
    if (!hint.empty()) hint = "; " + hint;
    throw FileError(path, extension.empty() ? fmt::format("has no extension to tell the image format (one of {})",
                                                          fmt::join(known, ", "))
                                            : fmt::format("\".{}\" is no image format that can be written ({}){}",
                                                          extension, fmt::join(known, ", "), hint));
}

} // namespace

void checkImageName(const std::string& path) {
    formatOf(path);
}

void writeImage(const std::string& path, const Image& image, const ImageMetadata& metadata) {
    const Format& format = formatOf(path);
    if (image.width <= 0 || image.height <= 0 || image.channels <= 0)
        throw FileError(path, "an image without pixels cannot be written");
    if (!format.anyChannels && image.channels != 1 && image.channels != 3)
        throw FileError(path,
                        fmt::format("the format takes one channel or three, not {} (EXR takes any)", image.channels));
    const Bytes bytes =
        format.encode({path, format.anyChannels ? image : inRec709(image, metadata.chromaticities), metadata});
    replaceFile(path, {std::as_bytes(std::span(bytes))});
}

} // namespace vitrine
