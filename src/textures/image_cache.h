// The images of a scene's textures: on disk, and of them as much in memory as is allowed.
#pragma once

#include "core/vec.h"
#include "textures/image_pyramid.h"

#include <array>
#include <memory>

namespace vitrine {

/// What lies beyond the image's edges.
enum class ImageWrap { Repeat, Black, Clamp };

/// Between the centres of texels.
enum class TexelInterpolation { Nearest, Bilinear };

/// Values of the first channels; those that the image does not have are 0.
using Texel = std::array<float, 4>;

class CachedImage;

/// OpenImageIO's texture system over pyramids in a file of our own. It finds and evicts tiles and interpolates; which
/// tiles it holds changes no value. The levels of a pyramid are subimages to it, as the choice among the levels of a
/// MIP-map goes wrong in it for images that are not about square (it measures footprints by the shorter side).
class ImageTextureCache : public std::enable_shared_from_this<ImageTextureCache> {
  public:
    /// \param megabytes of tiles in memory, at least
    /// \throws FileError when no temporary file can be made
    explicit ImageTextureCache(int megabytes);
    ~ImageTextureCache();

    /// Where to write pyramids.
    TexelFile& file() { return file_; }
    /// \param name for messages: the image's file
    std::shared_ptr<const CachedImage> add(const ImagePyramid& pyramid, const std::string& name);

    /// Bytes of tiles in memory now.
    std::size_t memory() const;

  private:
    friend class CachedImage;
    struct System;

    TexelFile file_;
    std::unique_ptr<System> system_;
};

/// One image of it. It keeps the cache alive.
class CachedImage {
  public:
    CachedImage(std::shared_ptr<ImageTextureCache> cache, const ImagePyramid& pyramid, std::string name, void* handle)
        : cache_(std::move(cache)), pyramid_(pyramid), name_(std::move(name)), handle_(handle) {}

    int levels() const { return int(pyramid_.levels.size()); }
    /// Texels along s and t.
    V2i size(int level) const {
        const auto& l = pyramid_.levels[std::size_t(level)];
        return {l.width, l.height};
    }
    int channels() const { return pyramid_.channels; }
    const std::string& name() const { return name_; }

    /// At (s, t), which goes over the image in [0, 1]^2 from its upper left corner. From any number of threads at once.
    /// \throws FileError should the temporary file have become unreadable
    Texel look(int level, const V2d& st, ImageWrap wrap, TexelInterpolation interpolation) const;

  private:
    friend class ImageTextureCache;

    std::shared_ptr<ImageTextureCache> cache_;
    ImagePyramid pyramid_;
    std::string name_;
    void* handle_; ///< OpenImageIO's TextureHandle
};

} // namespace vitrine
