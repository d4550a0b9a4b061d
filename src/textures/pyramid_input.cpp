#include "textures/pyramid_input.h"

namespace vitrine {

namespace {

constexpr const char* sourceAttribute = "vitrine:pyramid";

} // namespace

OIIO::ImageSpec PyramidInput::configuration(const Source& source) {
    OIIO::ImageSpec spec;
    const void* const pointer = &source;
    spec.attribute(sourceAttribute, OIIO::TypeDesc::PTR, &pointer);
    return spec;
}

bool PyramidInput::open(const std::string&, OIIO::ImageSpec&) {
    errorfmt("no pyramid was named");
    return false;
}

bool PyramidInput::open(const std::string& name, OIIO::ImageSpec& spec, const OIIO::ImageSpec& configuration) {
    const OIIO::ParamValue* const given = configuration.find_attribute(sourceAttribute, OIIO::TypeDesc::PTR);
    if (!given) return open(name, spec);
    source_ = *static_cast<const Source* const*>(given->data());
    level_ = -1;
    if (!seek_subimage(0, 0)) return false;
    spec = m_spec;
    return true;
}

bool PyramidInput::close() {
    source_ = nullptr;
    return true;
}

bool PyramidInput::seek_subimage(int subimage, int mipLevel) {
    if (!source_ || mipLevel != 0 || subimage < 0 || std::size_t(subimage) >= source_->pyramid.levels.size())
        return false;
    if (subimage == level_) return true;
    const ImagePyramid& pyramid = source_->pyramid;
    const ImagePyramid::Level& level = pyramid.levels[std::size_t(subimage)];
    m_spec = OIIO::ImageSpec(level.width, level.height, pyramid.channels,
                             pyramid.format == TexelFormat::Half ? OIIO::TypeHalf : OIIO::TypeFloat);
    m_spec.tile_width = m_spec.tile_height = ImagePyramid::tileSize;
    m_spec.tile_depth = 1;
    level_ = subimage;
    return true;
}

bool PyramidInput::read_native_scanline(int, int, int, int, void*) {
    errorfmt("a pyramid is read by tiles");
    return false;
}

bool PyramidInput::read_native_tile(int subimage, int mipLevel, int x, int y, int, void* data) {
    if (mipLevel != 0 || !source_) return false;
    const ImagePyramid& pyramid = source_->pyramid;
    const ImagePyramid::Level& level = pyramid.levels[std::size_t(subimage)];
    const auto tile = std::uint64_t(y / ImagePyramid::tileSize) * std::uint64_t(level.tilesAcross()) +
                      std::uint64_t(x / ImagePyramid::tileSize);
    if (source_->file->read(level.offset + tile * pyramid.tileBytes(), data, pyramid.tileBytes())) return true;
    errorfmt("the temporary file of textures cannot be read");
    return false;
}

} // namespace vitrine
