#include "textures/checkerboard.h"

namespace vitrine {

namespace {

/// The wave that is 1 on [0,1), -1 on [1,2) and so on, integrated twice, less the part linear in x: second differences do
/// not see that.
double secondIntegral(double x) {
    const double y = x / 2 - std::floor(x / 2) - 0.5;
    return y * (1 - 2 * std::abs(y));
}

/// That wave's mean around x under a triangle that reaches r to both sides.
double filteredWave(double x, double r) {
    constexpr double farther = 1e8; // the mean is within 1/r^2 of 0
    if (!(r < farther)) return 0;
    if (r >= 0.5) return (secondIntegral(x + r) - 2 * secondIntegral(x) + secondIntegral(x - r)) / sqr(r);
    // One edge at most is within reach; the differences would cancel.
    const double edge = std::round(x), e = x - edge;
    const bool isEven = edge / 2 == std::floor(edge / 2);
    const double right = isEven ? 1 : -1;
    if (std::abs(e) >= r) return e < 0 ? -right : right;
    return right * (e / r) * (2 - std::abs(e / r));
}

/// Half the width of the triangle; half as much again as the footprint reaches, as in pbrt-v4.
double reach(double dx, double dy) {
    return 1.5 * std::max(std::abs(dx), std::abs(dy));
}

} // namespace

float SquaresWeight::evaluate(const TexturePoint& at) const {
    const PlanePoint point = mapping_->map(at);
    double wave = 1;
    for (int i = 0; i < 2; ++i)
        wave *= filteredWave(point.st[i], reach(point.dstdx[i], point.dstdy[i]));
    return float((1 - wave) / 2);
}

float CubesWeight::evaluate(const TexturePoint& at) const {
    const SpacePoint point = space_.map(at);
    double wave = 1;
    for (int i = 0; i < 3; ++i)
        wave *= filteredWave(point.p[i], reach(point.dpdx[i], point.dpdy[i]));
    return float((1 - wave) / 2);
}

} // namespace vitrine
