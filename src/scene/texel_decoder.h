// From the values of an image file to light.
#pragma once

#include "scene/texture_images.h"

#include <OpenImageIO/imageio.h>

namespace vitrine {

class TexelDecoder {
  public:
    /// For the values of a file, 0 to 1, that an integer format stores.
    TexelDecoder(const ImageEncoding& encoding, const OIIO::ImageSpec& spec);
    float operator()(float value) const {
        return codes_.empty() ? value : codes_[std::size_t(value * float(codes_.size() - 1) + 0.5f)];
    }

  private:
    std::vector<float> codes_; ///< the light of each code, as powers are slow; empty: the value itself
};

} // namespace vitrine
