#include "film/image_input.h"

#include "core/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace vitrine {

namespace {

/// More than this is no picture but a damaged header (64 GB of floats).
constexpr std::int64_t maxValues = std::int64_t(1) << 34;

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

void checkHeader(const std::string& path, const OIIO::ImageInput& input, const OIIO::ImageSpec& spec) {
    if (spec.deep) failToRead(path, "deep images are not supported");
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.depth > 1)
        failToRead(path, "its header makes no sense");
    const auto row = std::int64_t(spec.width) * spec.nchannels;
    if (row > maxValues / spec.height) failToRead(path, "its header claims " + describeSize(spec));
    // Deflate's best is 1 : 1032; an interlaced PNG would be given all its memory before that shows.
    const auto fileSize = double(std::filesystem::file_size(path));
    if (std::string_view(input.format_name()) == "png" && double(spec.image_bytes(true)) > 1100 * fileSize)
        failToRead(path, "its header claims " + describeSize(spec) + ", more than the file can hold");
}

} // namespace

void failToRead(const std::string& path, const std::string& what) {
    throw FileError(path, "cannot be read: " +
                              (what.empty() ? std::string("damaged, or no image") : what.substr(0, what.find('\n'))));
}

std::string describeSize(const OIIO::ImageSpec& spec) {
    return fmt::format("{} x {} pixels of {} channels", spec.width, spec.height, spec.nchannels);
}

std::unique_ptr<OIIO::ImageInput> openImage(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) failToRead(path, "no such file");
    if (std::filesystem::is_directory(path, error)) failToRead(path, "is a directory");
    if (isCutJpeg(path)) failToRead(path, "the file is cut short");

    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    auto input = OIIO::ImageInput::open(path, &config);
    if (!input) failToRead(path, OIIO::geterror());
    checkHeader(path, *input, input->spec());
    return input;
}

bool isLinear(const OIIO::ImageSpec& spec) {
    return spec.format.is_floating_point() ||
           OIIO::Strutil::iequals(spec.get_string_attribute("oiio:ColorSpace"), "linear");
}

std::vector<int> colourChannelIndices(int channels, const std::vector<std::string>& names) {
    std::vector<int> chosen;
    for (const char* name : {"R", "G", "B"}) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found != names.end()) chosen.push_back(int(found - names.begin()));
    }
    if (chosen.size() == 3) return chosen;
    if (channels >= 3 && !names.empty())
        throw std::invalid_argument(fmt::format("there are no channels R, G and B, but {}", fmt::join(names, ", ")));
    return channels < 3 ? std::vector<int>{0} : std::vector<int>{0, 1, 2};
}

} // namespace vitrine
