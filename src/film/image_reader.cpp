#include "film/image_input.h"
#include "film/srgb.h"

#include <array>

namespace vitrine {

namespace {

void linearise(Image& image, const OIIO::ImageSpec& spec) {
    if (isLinear(spec)) return;
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

Image readPixels(const std::string& path, OIIO::ImageInput& input, const OIIO::ImageSpec& spec) {
    const auto count = std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(spec.nchannels);
    try {
        // Not a vector, as that would touch all the memory before the file has shown that it holds so much.
        const std::unique_ptr<float[]> values(new float[count]);
        if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, values.get()))
            failToRead(path, input.geterror());
        return Image{spec.width, spec.height, spec.nchannels, std::vector<float>(values.get(), values.get() + count)};
    } catch (const std::bad_alloc&) {
        failToRead(path, "not enough memory for " + describeSize(spec));
    }
}

} // namespace

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

Image readImage(const std::string& path, ImageMetadata* metadata) {
    const auto input = openImage(path);
    const OIIO::ImageSpec spec = input->spec();
    Image image = readPixels(path, *input, spec);
    linearise(image, spec);
    if (metadata) readMetadata(spec, *metadata);
    return image;
}

Image colourChannels(const Image& image, const std::vector<std::string>& names) {
    const std::vector<int> chosen = colourChannelIndices(image.channels, names);
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
        failToRead(path, e.what());
    }
}

} // namespace vitrine
