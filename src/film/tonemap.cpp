#include "film/tonemap.h"

#include "core/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

namespace vitrine {

namespace {

V3f reinhard(const V3f& rgb) {
    const float luminance = 0.2126f * rgb.x + 0.7152f * rgb.y + 0.0722f * rgb.z;
    return rgb / (1 + std::max(0.f, luminance));
}

/// (x (a x + b) + c) / (x (d x + e) + f) per channel, between two changes of colour space: S. Hill's fit to the ACES
/// reference rendering transform and the Rec.709 output transform (2016). Grey reaches 1 at 25.7.
V3f filmic(const V3f& rgb) {
    // Rec.709 to the rendering primaries with the saturation of ACES's "RRT_SAT", and back with "ODT_SAT".
    constexpr float in[3][3] = {
        {0.59719f, 0.35458f, 0.04823f}, {0.07600f, 0.90834f, 0.01566f}, {0.02840f, 0.13383f, 0.83777f}};
    constexpr float out[3][3] = {
        {1.60475f, -0.53108f, -0.07367f}, {-0.10208f, 1.10813f, -0.00605f}, {-0.00327f, -0.07276f, 1.07602f}};
    const auto apply = [](const float(&m)[3][3], const V3f& v) {
        return V3f(m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
                   m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z);
    };
    V3f v = apply(in, V3f(std::max(0.f, rgb.x), std::max(0.f, rgb.y), std::max(0.f, rgb.z)));
    for (int i = 0; i < 3; ++i) {
        const float x = std::min(v[i], 1e6f); // the curve is flat there, and squares stay finite
        v[i] = (x * (x + 0.0245786f) - 0.000090537f) / (x * (0.983729f * x + 0.4329510f) + 0.238081f);
    }
    v = apply(out, v);
    return V3f(std::clamp(v.x, 0.f, 1.f), std::clamp(v.y, 0.f, 1.f), std::clamp(v.z, 0.f, 1.f));
}

} // namespace

const std::vector<std::string>& toneMapNames() {
    static const std::vector<std::string> names = {"none", "reinhard", "filmic"};
    return names;
}

ToneMap toneMapNamed(const std::string& name) {
    const auto& names = toneMapNames();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return ToneMap(found - names.begin());
    std::string hint = didYouMean(name, names);
    if (!hint.empty()) hint = "; " + hint;
    throw std::invalid_argument(
        fmt::format("there is no tone mapping \"{}\" (one of {}){}", name, fmt::join(names, ", "), hint));
}

Image toneMapped(const Image& image, float stops, ToneMap operation) {
    if (!std::isfinite(stops)) throw std::invalid_argument("the exposure must be a finite number of stops");
    Image result = image;
    const float exposure = std::exp2(stops);
    const auto channels = std::size_t(image.channels);
    const std::size_t colours = channels < 3 ? 1 : 3;
    for (std::size_t i = 0; i + channels <= result.pixels.size(); i += channels) {
        float* p = &result.pixels[i];
        V3f rgb = (colours == 1 ? V3f(p[0]) : V3f(p[0], p[1], p[2])) * exposure;
        if (operation == ToneMap::Reinhard) rgb = reinhard(rgb);
        if (operation == ToneMap::Filmic) rgb = filmic(rgb);
        for (std::size_t c = 0; c < colours; ++c)
            p[c] = rgb[int(c)];
    }
    return result;
}

} // namespace vitrine
