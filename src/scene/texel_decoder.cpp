#include "scene/texel_decoder.h"

#include "film/image_input.h"
#include "film/srgb.h"

namespace vitrine {

TexelDecoder::TexelDecoder(const ImageEncoding& encoding, const OIIO::ImageSpec& spec) {
    using Kind = ImageEncoding::Kind;
    if (spec.format.is_floating_point() || (encoding.kind == Kind::Default && isLinear(spec)) || encoding.isLinear())
        return;
    // Formats of 32 bits are rare: 16 bits of them are told apart.
    codes_.resize(spec.format == OIIO::TypeUInt8 ? 1 << 8 : 1 << 16);
    for (std::size_t i = 0; i < codes_.size(); ++i) {
        const double value = double(i) / double(codes_.size() - 1);
        codes_[i] = float(encoding.kind == Kind::Gamma ? std::pow(value, encoding.gamma) : linearFromSrgb(value));
    }
}

} // namespace vitrine
