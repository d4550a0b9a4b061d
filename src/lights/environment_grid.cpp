#include "lights/environment_grid.h"

#include "core/equal_area.h"

#include <stdexcept>

namespace vitrine {

EnvironmentGrid::EnvironmentGrid(EnvironmentMapping mapping, int width, int height)
    : mapping_(mapping), width_(width), height_(height) {
    if (width <= 0 || height <= 0) throw std::invalid_argument("the image of an infinite light is empty");
    if (mapping == EnvironmentMapping::EqualArea && width != height)
        throw std::invalid_argument("an equal-area environment image must be square");
    if (mapping == EnvironmentMapping::LatLong && width != 2 * height)
        throw std::invalid_argument("a latitude-longitude environment image must be twice as wide as high");
}

V2f EnvironmentGrid::squareFromDirection(const V3f& d) const {
    if (mapping_ == EnvironmentMapping::EqualArea) return equalAreaSphereToSquare(d);
    const float u = std::atan2(d.y, d.x) / (2 * pi);
    return V2f(u < 0 ? u + 1 : u, std::atan2(std::hypot(d.x, d.y), d.z) / pi);
}

V3f EnvironmentGrid::uniformDirection(const V2f& p) const {
    if (mapping_ == EnvironmentMapping::EqualArea) return equalAreaSquareToSphere(p);
    // Uniform in the cosine between the row's upper and lower latitude.
    const int y = row(p.y);
    const double top = piD * y / height_, bottom = piD * (y + 1) / height_;
    const double within = std::clamp(double(p.y) * height_ - y, 0., 1.);
    const double cosine = lerp(within, std::cos(top), std::cos(bottom)), sine = safeSqrt(1 - cosine * cosine);
    const double phi = 2 * piD * p.x;
    return V3f(float(sine * std::cos(phi)), float(sine * std::sin(phi)), float(cosine));
}

double EnvironmentGrid::solidAngle(int row) const {
    if (mapping_ == EnvironmentMapping::EqualArea) return 4 * piD / (double(width_) * height_);
    return 2 * piD / width_ * (std::cos(piD * row / height_) - std::cos(piD * (row + 1) / height_));
}

std::size_t EnvironmentGrid::texel(int x, int y) const {
    if (mapping_ == EnvironmentMapping::EqualArea) {
        // As wrapEqualAreaSquare.
        if (x < 0 || x >= width_) {
            x = x < 0 ? 0 : width_ - 1;
            y = height_ - 1 - y;
        }
        if (y < 0 || y >= height_) {
            x = width_ - 1 - x;
            y = y < 0 ? 0 : height_ - 1;
        }
    } else {
        // Over a pole lies the opposite meridian.
        if (y < 0 || y >= height_) {
            y = std::clamp(y, 0, height_ - 1);
            x += width_ / 2;
        }
        x = (x + width_) % width_;
    }
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
}

} // namespace vitrine
