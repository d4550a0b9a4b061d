// The image files of a scene's textures, each read once however many textures show it.
#pragma once

#include "nodes/nodes.h"
#include "spectrum/colorspace.h"
#include "textures/image_cache.h"

namespace vitrine {

/// How whole numbers in a file stand for light.
struct ImageEncoding {
    enum class Kind {
        Default, ///< sRGB, unless the file says that it is linear
        Srgb,
        Gamma
    };
    Kind kind = Kind::Default;
    double gamma = 1; ///< the exponent that makes light of values in [0, 1]; 1 is linear

    bool isLinear() const { return kind == Kind::Gamma && gamma == 1; }
    auto operator<=>(const ImageEncoding&) const = default;
};

/// An image, ready to be looked up.
struct TextureImage {
    std::shared_ptr<const CachedImage> image;
    const RgbColorSpace* colorSpace = nullptr; ///< of its three channels
    int channel = 0;                           ///< for numbers: the one that counts
    std::vector<std::string> warnings;
};

class TextureImages {
  public:
    static constexpr int mostMegabytes = 1 << 20;

    /// \param nodes for Option "texturecachemb"
    explicit TextureImages(const SceneNodes& nodes) : nodes_(nodes) {}

    /// Three channels, or one for grey. \throws FileError; SceneError for the option
    const TextureImage& colours(const std::string& path, const ImageEncoding& encoding);
    /// Numbers: the mean of red, green and blue, or alpha where there is one that is not 1 everywhere (pbrt-v4).
    /// \throws as colours()
    const TextureImage& numbers(const std::string& path, const ImageEncoding& encoding);

  private:
    const TextureImage& find(const std::string& path, const ImageEncoding& encoding, bool asNumbers);
    ImageTextureCache& cache();

    const SceneNodes& nodes_;
    std::shared_ptr<ImageTextureCache> cache_;
    std::map<std::tuple<std::string, ImageEncoding, bool>, TextureImage> images_;
};

} // namespace vitrine
