#include "textures/image_filter.h"

namespace vitrine {

namespace {

void add(Texel& sum, const Texel& texel, float weight) {
    for (std::size_t c = 0; c < sum.size(); ++c)
        sum[c] += weight * texel[c];
}

/// The level whose texels are as large as `texels` of the finest, with a fraction; from 0 to the coarsest.
float levelOf(const CachedImage& image, double texels) {
    if (!(texels > 1)) return 0;
    return std::min(float(std::log2(texels)), float(image.levels() - 1));
}

/// Adds the value between levels.
void addTrilinear(Texel& sum, const CachedImage& image, ImageWrap wrap, float level, const V2d& st, float weight) {
    const int finer = int(level);
    const float t = level - float(finer);
    add(sum, image.look(finer, st, wrap, TexelInterpolation::Bilinear), weight * (1 - t));
    if (t > 0) add(sum, image.look(finer + 1, st, wrap, TexelInterpolation::Bilinear), weight * t);
}

/// The ellipse that a circle becomes under the footprint's matrix, in texels: semi-axes by its singular values.
struct Ellipse {
    double major = 0, minor = 0;
    V2d along{1, 0}; ///< unit, of the major axis
};

Ellipse ellipse(const V2d& dx, const V2d& dy) {
    const double a = sqr(dx.x) + sqr(dy.x), b = dx.x * dx.y + dy.x * dy.y, c = sqr(dx.y) + sqr(dy.y);
    Ellipse e;
    const double root = std::hypot((a - c) / 2, b), square = (a + c) / 2 + root;
    e.major = std::sqrt(square);
    if (e.major == 0) return e;
    e.minor = std::abs(dx.x * dy.y - dx.y * dy.x) / e.major;
    // Of the two rows of the matrix less the eigenvalue the longer.
    const V2d first(b, square - a), second(square - c, b);
    const V2d along = first.dot(first) > second.dot(second) ? first : second;
    const double length = along.length();
    if (length > 0) e.along = along / length;
    return e;
}

/// A Gaussian over the ellipse, its deviations half the semi-axes (Heckbert 1989's elliptical weighted average), put
/// together of trilinear lookups along the major axis (McCormack et al. 1999, "Feline"). A bilinear lookup in a level has a
/// deviation of about half a texel of that level, so each stands for the minor axis.
Texel elliptical(const CachedImage& image, const ImageSampling& sampling, const V2d& st, const V2d& dx, const V2d& dy) {
    const Ellipse e = ellipse(dx, dy);
    // No lookup is narrower than a texel.
    const double minor = std::max({e.minor, e.major / double(sampling.maxAnisotropy), 1.});
    const float level = levelOf(image, minor);
    Texel sum{};
    if (!(e.major > minor * 1.01)) {
        addTrilinear(sum, image, sampling.wrap, level, st, 1);
        return sum;
    }
    // (1 - x^2)^2 has a variance of 1/7. What it adds along must be (major^2 - minor^2) / 4.
    const double reach = std::sqrt(7 * (sqr(e.major) - sqr(minor))) / 2;
    const V2d size(image.size(0));
    const V2d axis(e.along.x * reach / size.x, e.along.y * reach / size.y);
    const int count = int(std::ceil(2 * e.major / minor));
    float weights = 0;
    for (int i = 0; i < count; ++i) {
        const double x = (2 * i + 1) / double(count) - 1;
        const float weight = float(sqr(1 - sqr(x)));
        weights += weight;
        addTrilinear(sum, image, sampling.wrap, level, st + axis * x, weight);
    }
    for (float& value : sum)
        value /= weights;
    return sum;
}

} // namespace

Texel filtered(const CachedImage& image, const ImageSampling& sampling, const V2d& st,
               const ImageFootprint& footprint) {
    const V2d size(image.size(0));
    const V2d dx = footprint.dx * size, dy = footprint.dy * size;
    if (sampling.filter == ImageFilter::Ewa) return elliptical(image, sampling, st, dx, dy);

    // pbrt-v4's width: twice the longest of the footprint's sides along s and t.
    const double side = std::max({std::abs(dx.x), std::abs(dx.y), std::abs(dy.x), std::abs(dy.y)});
    const float level = levelOf(image, 2 * side);
    switch (sampling.filter) {
    case ImageFilter::Point:
        return image.look(int(level), st, sampling.wrap, TexelInterpolation::Nearest);
    case ImageFilter::Bilinear:
        return image.look(int(level), st, sampling.wrap, TexelInterpolation::Bilinear);
    case ImageFilter::Trilinear:
    case ImageFilter::Ewa:
        break;
    }
    Texel sum{};
    addTrilinear(sum, image, sampling.wrap, level, st, 1);
    return sum;
}

} // namespace vitrine
