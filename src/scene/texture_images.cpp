#include "scene/texture_images.h"

#include "core/errors.h"
#include "film/image_input.h"
#include "film/primaries.h"
#include "scene/texel_decoder.h"

#include <fmt/format.h>

namespace vitrine {

namespace {

/// Reads a file a few rows at a time into a pyramid.
class Reader {
  public:
    Reader(const std::string& path, const ImageEncoding& encoding, bool asNumbers)
        : path_(path), input_(openImage(path)), spec_(input_->spec()), decode_(encoding, spec_), asNumbers_(asNumbers),
          colours_(chooseColours()), hasAlpha_(asNumbers && colours_.size() == 3 && spec_.alpha_channel >= 0) {
        if (encoding.kind != ImageEncoding::Kind::Default && !encoding.isLinear() && spec_.format.is_floating_point())
            image_.warnings.push_back(path + " holds floats: \"encoding\" does not matter");
        chooseColorSpace();
    }

    TextureImage read(ImageTextureCache& cache) {
        const int channels = asNumbers_ ? 1 + hasAlpha_ : int(colours_.size());
        const bool isNarrow = (spec_.format == OIIO::TypeUInt8 || spec_.format == OIIO::TypeHalf) && !otherPrimaries_;
        PyramidWriter writer(cache.file(), spec_.width, spec_.height, channels,
                             isNarrow ? TexelFormat::Half : TexelFormat::Float);
        for (int y = 0; y < spec_.height; y += rowsAtOnce())
            addRows(writer, y, std::min(y + rowsAtOnce(), spec_.height));
        if (notFinite_ > 0)
            image_.warnings.push_back(
                fmt::format("{} has {} values that are infinite or not a number; they count as 0", path_, notFinite_));
        image_.image = cache.add(writer.pyramid(), path_);
        image_.channel = hasAlpha_ && !alphaIsOne_ ? 1 : 0;
        return std::move(image_);
    }

  private:
    std::vector<int> chooseColours() const {
        try {
            return colourChannelIndices(spec_.nchannels, spec_.channelnames);
        } catch (const std::invalid_argument& e) {
            failToRead(path_, e.what());
        }
    }

    void chooseColorSpace() {
        ImageMetadata metadata;
        readMetadata(spec_, metadata);
        image_.colorSpace = RgbColorSpace::withChromaticities(metadata.chromaticities);
        if (image_.colorSpace) return;
        image_.colorSpace = &RgbColorSpace::srgb();
        std::copy_n(metadata.chromaticities, 8, otherPrimaries_.emplace().begin());
    }

    int rowsAtOnce() const { return std::max(16, spec_.tile_height); }

    /// \throws FileError
    void addRows(PyramidWriter& writer, int begin, int end) {
        const auto rowSize = std::size_t(spec_.width) * std::size_t(spec_.nchannels);
        stored_.resize(rowSize * std::size_t(end - begin));
        const int top = spec_.y + begin, bottom = spec_.y + end;
        const bool ok =
            spec_.tile_width > 0
                ? input_->read_tiles(0, 0, spec_.x, spec_.x + spec_.width, top, bottom, 0, 1, 0, spec_.nchannels,
                                     OIIO::TypeFloat, stored_.data())
                : input_->read_scanlines(0, 0, top, bottom, 0, 0, spec_.nchannels, OIIO::TypeFloat, stored_.data());
        if (!ok) failToRead(path_, input_->geterror());
        for (int y = 0; y < end - begin; ++y)
            writer.addRow(decoded(stored_.data() + std::size_t(y) * rowSize));
    }

    /// A row of the file as one of the pyramid.
    const float* decoded(const float* stored) {
        row_ = {spec_.width, 1, int(colours_.size()), std::move(row_.pixels)};
        row_.pixels.clear();
        for (int x = 0; x < spec_.width; ++x)
            for (const int c : colours_)
                row_.pixels.push_back(decode_(finite(stored[x * spec_.nchannels + c])));
        if (asNumbers_) return numbers(stored);
        if (otherPrimaries_) row_ = inRec709(row_, *otherPrimaries_);
        return row_.pixels.data();
    }

    /// The mean of the colours, and alpha.
    const float* numbers(const float* stored) {
        numbers_.clear();
        for (int x = 0; x < spec_.width; ++x) {
            const float* const pixel = row_.pixels.data() + std::size_t(x) * colours_.size();
            numbers_.push_back(colours_.size() == 3 ? (pixel[0] + pixel[1] + pixel[2]) / 3 : pixel[0]);
            if (!hasAlpha_) continue;
            numbers_.push_back(finite(stored[x * spec_.nchannels + spec_.alpha_channel]));
            alphaIsOne_ &= numbers_.back() == 1;
        }
        return numbers_.data();
    }

    float finite(float value) {
        if (std::isfinite(value)) return value;
        ++notFinite_;
        return 0;
    }

    std::string path_;
    std::unique_ptr<OIIO::ImageInput> input_;
    OIIO::ImageSpec spec_;
    TexelDecoder decode_;
    bool asNumbers_;
    std::vector<int> colours_; ///< indices of the channels
    bool hasAlpha_, alphaIsOne_ = true;
    std::optional<std::array<float, 8>> otherPrimaries_; ///< of no colour space that is known
    TextureImage image_;
    std::vector<float> stored_, numbers_;
    Image row_;
    std::uint64_t notFinite_ = 0;
};

constexpr int defaultMegabytes = 1024;

} // namespace

ImageTextureCache& TextureImages::cache() {
    if (!cache_) {
        int megabytes = defaultMegabytes;
        if (const auto option = nodes_.options.find("texturecachemb"); option != nodes_.options.end()) {
            megabytes = std::get<int>(option->second.value);
            if (megabytes < 1 || megabytes > mostMegabytes)
                throw SceneError(option->second.place,
                                 fmt::format("option \"texturecachemb\" must lie in [1, {}]", mostMegabytes));
        }
        cache_ = std::make_shared<ImageTextureCache>(megabytes);
    }
    return *cache_;
}

const TextureImage& TextureImages::find(const std::string& path, const ImageEncoding& encoding, bool asNumbers) {
    const std::tuple key(path, encoding, asNumbers);
    const auto known = images_.find(key);
    if (known != images_.end()) return known->second;
    Reader reader(path, encoding, asNumbers);
    return images_[key] = reader.read(cache());
}

const TextureImage& TextureImages::colours(const std::string& path, const ImageEncoding& encoding) {
    return find(path, encoding, false);
}

const TextureImage& TextureImages::numbers(const std::string& path, const ImageEncoding& encoding) {
    return find(path, encoding, true);
}

} // namespace vitrine
