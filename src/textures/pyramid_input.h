// An image pyramid as OpenImageIO reads images.
#pragma once

#include "textures/image_pyramid.h"

#include <OpenImageIO/imageio.h>

namespace vitrine {

/// Its levels are subimages. Which pyramid to read comes with the configuration, as the texture system asks for that.
class PyramidInput final : public OIIO::ImageInput {
  public:
    struct Source {
        const TexelFile* file;
        ImagePyramid pyramid;
    };
    /// The configuration that chooses `source`, which must outlive the input.
    static OIIO::ImageSpec configuration(const Source& source);
    static OIIO::ImageInput* create() { return new PyramidInput; }

    const char* format_name() const override { return "vitrine pyramid"; }
    bool open(const std::string& name, OIIO::ImageSpec& spec) override;
    bool open(const std::string& name, OIIO::ImageSpec& spec, const OIIO::ImageSpec& configuration) override;
    bool close() override;
    int current_subimage() const override { return level_; }
    bool seek_subimage(int subimage, int mipLevel) override;
    bool read_native_scanline(int subimage, int mipLevel, int y, int z, void* data) override;
    bool read_native_tile(int subimage, int mipLevel, int x, int y, int z, void* data) override;

  private:
    const Source* source_ = nullptr;
    int level_ = 0;
};

} // namespace vitrine
