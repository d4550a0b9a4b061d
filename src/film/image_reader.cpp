#include "core/errors.h"
#include "film/imageio.h"
#include "film/srgb.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace vitrine {

namespace {

/// More than this is no picture but a damaged header (64 GB of floats).
constexpr std::int64_t maxValues = std::int64_t(1) << 34;

std::string firstLine(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

[[noreturn]] void fail(const std::string& path, const std::string& what) {
    throw FileError(path, "cannot be read: " + (what.empty() ? std::string("damaged, or no image") : firstLine(what)));
}

void readMetadata(const OIIO::ImageSpec& spec, ImageMetadata& metadata) {
    metadata = {};
    metadata.channelNames = spec.channelnames;
    metadata.fullResolution = V2i(spec.full_width, spec.full_height);
    metadata.offset = V2i(spec.x - spec.full_x, spec.y - spec.full_y);
    for (const auto& attribute : spec.extra_attribs) {
        const std::string name = attribute.name().string();
        const OIIO::TypeDesc type = attribute.type();
        const auto* floats = static_cast<const float*>(attribute.data());
        if (type == OIIO::TypeInt || type == OIIO::TypeFloat) {
            metadata.numbers[name] = double(attribute.get_float());
            if (type == OIIO::TypeInt) metadata.numbers[name] = attribute.get_int();
        } else if (type == OIIO::TypeString) {
            metadata.strings[name] = attribute.get_string();
        } else if (type == OIIO::TypeMatrix) {
            M44d matrix;
            for (int i = 0; i < 16; ++i)
                matrix[i / 4][i % 4] = double(floats[i]);
            metadata.matrices[name] = matrix;
        } else if (name == "chromaticities" && type == OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8)) {
            std::copy_n(floats, 8, metadata.chromaticities);
        }
    }
}

/// Integer formats hold the sRGB curve unless the file says otherwise.
void linearise(Image& image, const OIIO::ImageSpec& spec) {
    if (spec.format.is_floating_point()) return;
    if (OIIO::Strutil::iequals(spec.get_string_attribute("oiio:ColorSpace"), "linear")) return;
    // Powers are slow: bytes go by a table.
    std::array<float, 256> ofByte;
    for (std::size_t i = 0; i < ofByte.size(); ++i)
        ofByte[i] = float(linearFromSrgb(double(i) / 255));
    const bool bytes = spec.format == OIIO::TypeUInt8;
    const std::size_t channels = std::size_t(image.channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (int(i % channels) == spec.alpha_channel) continue;
        float& value = image.pixels[i];
        value = bytes ? ofByte[std::size_t(std::lround(value * 255)) & 255] : float(linearFromSrgb(double(value)));
    }
}

/// The JPEG library fills what is missing with grey and says nothing: look for the end marker.
bool isCutJpeg(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (in.get() != 0xff || in.get() != 0xd8) return false;
    bool afterFf = false;
    for (std::istreambuf_iterator<char> i(in), end; i != end; ++i) {
        const auto byte = static_cast<unsigned char>(*i);
        if (afterFf && byte == 0xd9) return false;
        afterFf = byte == 0xff;
    }
    return true;
}

Image readPixels(const std::string& path, OIIO::ImageInput& input, const OIIO::ImageSpec& spec) {
    if (spec.deep) fail(path, "deep images are not supported");
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.depth > 1)
        fail(path, "its header makes no sense");
    const std::string size = fmt::format("{} x {} pixels of {} channels", spec.width, spec.height, spec.nchannels);
    const auto row = std::int64_t(spec.width) * spec.nchannels;
    if (row > maxValues / spec.height) fail(path, "its header claims " + size);
    // Deflate's best is 1 : 1032; an interlaced PNG would be given all its memory before that shows.
    const auto fileSize = double(std::filesystem::file_size(path));
    if (std::string_view(input.format_name()) == "png" && double(spec.image_bytes(true)) > 1100 * fileSize)
        fail(path, "its header claims " + size + ", more than the file can hold");

    const auto count = std::size_t(row * spec.height);
    try {
        // Not a vector, as that would touch all the memory before the file has shown that it holds so much.
        const std::unique_ptr<float[]> values(new float[count]);
        if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, values.get())) fail(path, input.geterror());
        return Image{spec.width, spec.height, spec.nchannels, std::vector<float>(values.get(), values.get() + count)};
    } catch (const std::bad_alloc&) {
        fail(path, "not enough memory for " + size);
    }
}

} // namespace

Image readImage(const std::string& path, ImageMetadata* metadata) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) fail(path, "no such file");
    if (std::filesystem::is_directory(path, error)) fail(path, "is a directory");
    if (isCutJpeg(path)) fail(path, "the file is cut short");

    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path, &config);
    if (!input) fail(path, OIIO::geterror());
    const OIIO::ImageSpec spec = input->spec();
    Image image = readPixels(path, *input, spec);
    linearise(image, spec);
    if (metadata) readMetadata(spec, *metadata);
    return image;
}

Image colourChannels(const Image& image, const std::vector<std::string>& names) {
    std::vector<int> chosen;
    for (const char* name : {"R", "G", "B"}) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found != names.end()) chosen.push_back(int(found - names.begin()));
    }
    if (chosen.size() != 3 && image.channels >= 3 && !names.empty())
        throw std::invalid_argument(fmt::format("there are no channels R, G and B, but {}", fmt::join(names, ", ")));
    if (chosen.size() != 3) chosen = image.channels < 3 ? std::vector<int>{0} : std::vector<int>{0, 1, 2};
    Image result{image.width, image.height, int(chosen.size()), {}};
    result.pixels.reserve(std::size_t(image.width) * std::size_t(image.height) * chosen.size());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c : chosen)
                result.pixels.push_back(image.at(x, y, c));
    return result;
}

Image readColours(const std::string& path, ImageMetadata& metadata) {
    const Image image = readImage(path, &metadata);
    try {
        return colourChannels(image, metadata.channelNames);
    } catch (const std::invalid_argument& e) {
        fail(path, e.what());
    }
}

} // namespace vitrine
