#include "cameras/aperture.h"

#include <stdexcept>

namespace vitrine {

namespace {

void checkRotation(double rotation) {
    if (!std::isfinite(rotation)) throw std::invalid_argument("the aperture's rotation must be finite");
}

double cross(const V2d& a, const V2d& b) {
    return a.x * b.y - a.y * b.x;
}

std::vector<float> brightness(const Image& image) {
    std::vector<float> mask;
    double sum = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            float value = 0;
            for (int c = 0; c < image.channels; ++c)
                value += image.at(x, y, c) / float(image.channels);
            if (!(value >= 0) || !std::isfinite(value))
                throw std::invalid_argument("the aperture's image has values that are negative or not finite");
            mask.push_back(value);
            sum += value;
        }
    if (!(sum > 0)) throw std::invalid_argument("the aperture's image is black: no light passes");
    return mask;
}

} // namespace

std::shared_ptr<PolygonAperture> PolygonAperture::polygon(int corners, double rotation) {
    if (corners < 3) throw std::invalid_argument("an aperture has 3 blades or more");
    return std::shared_ptr<PolygonAperture>(new PolygonAperture(corners, 0, rotation));
}

std::shared_ptr<PolygonAperture> PolygonAperture::star(int points, double rotation) {
    if (points < 5) throw std::invalid_argument("a star has 5 points or more");
    return std::shared_ptr<PolygonAperture>(
        new PolygonAperture(points, std::cos(2 * piD / points) / std::cos(piD / points), rotation));
}

/// \param innerRadius of the corners between two points of a star; 0: there are none
PolygonAperture::PolygonAperture(int corners, double innerRadius, double rotation) {
    checkRotation(rotation);
    const auto add = [&](double turn, double radius) {
        const double angle = radians(90 + std::fmod(rotation, 360)) + 2 * piD * turn / corners;
        corners_.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    };
    for (int i = 0; i < corners; ++i) {
        add(i, 1);
        if (innerRadius > 0) add(i + 0.5, innerRadius);
    }
    area_ = cross(corners_[0], corners_[1]) / 2 * double(corners_.size());
}

V2d PolygonAperture::sample(const V2f& u) const {
    const float at = u.x * float(corners_.size());
    const std::size_t i = std::min(std::size_t(at), corners_.size() - 1);
    const V2f b = sampleUniformTriangle(V2f(std::min(at - float(i), 1 - 0x1p-24f), u.y));
    return corners_[i] * double(b.x) + corners_[(i + 1) % corners_.size()] * double(b.y);
}

double PolygonAperture::inverseDensity(const V2d& p) const {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const V2d &a = corners_[i], &b = corners_[(i + 1) % corners_.size()];
        // In the wedge of this edge, on the centre's side of it.
        if (cross(a, p) >= 0 && cross(p, b) >= 0 && cross(b - a, p - a) >= 0) return area_;
    }
    return infinityD;
}

ImageAperture::ImageAperture(const Image& image, double rotation)
    : mask_(brightness(image), image.width, image.height), cosine_(std::cos(radians(rotation))),
      sine_(std::sin(radians(rotation))) {
    checkRotation(rotation);
}

V2d ImageAperture::sample(const V2f& u) const {
    const V2f at = mask_.sample(u).p;
    const V2d p(2 * double(at.x) - 1, 1 - 2 * double(at.y));
    return V2d(cosine_ * p.x - sine_ * p.y, sine_ * p.x + cosine_ * p.y);
}

double ImageAperture::inverseDensity(const V2d& p) const {
    const V2d own(cosine_ * p.x + sine_ * p.y, cosine_ * p.y - sine_ * p.x);
    if (!(std::abs(own.x) <= 1 && std::abs(own.y) <= 1)) return infinityD;
    // The square's area is 4.
    return 4 / double(mask_.pdf(V2f(float((own.x + 1) / 2), float((1 - own.y) / 2))));
}

} // namespace vitrine
