#include "textures/image_cache.h"

#include "core/errors.h"
#include "textures/pyramid_input.h"

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/texture.h>
#include <fmt/format.h>

namespace vitrine {

namespace {

OIIO::TextureOpt::Wrap wrapMode(ImageWrap wrap) {
    switch (wrap) {
    case ImageWrap::Repeat:
        return OIIO::TextureOpt::WrapPeriodic;
    case ImageWrap::Black:
        return OIIO::TextureOpt::WrapBlack;
    case ImageWrap::Clamp:
        break;
    }
    return OIIO::TextureOpt::WrapClamp;
}

/// A coordinate that means the same and that texels can be counted from: far away all is alike but for repetition.
float reduced(double s, ImageWrap wrap) {
    if (wrap == ImageWrap::Repeat) return float(s - std::floor(s));
    return float(std::clamp(s, -2., 3.));
}

} // namespace

struct ImageTextureCache::System {
    OIIO::ImageCache* cache = OIIO::ImageCache::create(false);
    OIIO::TextureSystem* textures = OIIO::TextureSystem::create(false, cache);
    std::vector<std::unique_ptr<PyramidInput::Source>> sources;

    ~System() {
        OIIO::TextureSystem::destroy(textures);
        OIIO::ImageCache::destroy(cache);
    }
};

ImageTextureCache::ImageTextureCache(int megabytes) : system_(std::make_unique<System>()) {
    system_->cache->attribute("max_memory_MB", float(megabytes));
    // Inputs are light: they share one open file.
    system_->cache->attribute("max_open_files", 1 << 20);
}

ImageTextureCache::~ImageTextureCache() = default;

std::shared_ptr<const CachedImage> ImageTextureCache::add(const ImagePyramid& pyramid, const std::string& name) {
    auto& sources = system_->sources;
    sources.push_back(std::make_unique<PyramidInput::Source>(PyramidInput::Source{&file_, pyramid}));
    // Not the file's name: one image may be there in several readings, and names with "<u>" mean sets of images.
    const OIIO::ustring key = OIIO::ustring(fmt::format("pyramid{}", sources.size()));
    const OIIO::ImageSpec configuration = PyramidInput::configuration(*sources.back());
    system_->cache->add_file(key, &PyramidInput::create, &configuration);
    OIIO::TextureSystem::TextureHandle* const handle = system_->textures->get_texture_handle(key);
    if (!handle || !system_->textures->good(handle))
        throw FileError(name, "cannot be put into the texture cache: " + system_->textures->geterror());
    return std::make_shared<CachedImage>(shared_from_this(), pyramid, name, handle);
}

std::size_t ImageTextureCache::memory() const {
    long long bytes = 0;
    system_->cache->getattribute("stat:cache_memory_used", OIIO::TypeDesc::INT64, &bytes);
    return std::size_t(bytes);
}

Texel CachedImage::look(int level, const V2d& st, ImageWrap wrap, TexelInterpolation interpolation) const {
    OIIO::TextureOpt options;
    options.subimage = level;
    options.swrap = options.twrap = wrapMode(wrap);
    options.mipmode = OIIO::TextureOpt::MipModeNoMIP;
    options.interpmode = interpolation == TexelInterpolation::Nearest ? OIIO::TextureOpt::InterpClosest
                                                                      : OIIO::TextureOpt::InterpBilinear;
    alignas(16) Texel texel{};
    OIIO::TextureSystem& textures = *cache_->system_->textures;
    auto* const handle = static_cast<OIIO::TextureSystem::TextureHandle*>(handle_);
    if (!textures.texture(handle, nullptr, options, reduced(st.x, wrap), reduced(st.y, wrap), 0, 0, 0, 0, 4,
                          texel.data()))
        throw FileError(name_, "its texels could not be read again: " + textures.geterror());
    return texel;
}

} // namespace vitrine
