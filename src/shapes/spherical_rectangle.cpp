#include "shapes/spherical_rectangle.h"

namespace vitrine {

namespace {

/// The angle between two edge planes whose unit normals' z are a and b, and whose x or y part is `za` and `zb` of the
/// unit length: acos(-a b) without its loss of digits near 0 and pi. sin^2 = 1 - a^2 b^2 = za^2 + a^2 zb^2.
double planeAngle(double a, double za, double b, double zb) {
    return std::atan2(std::sqrt(sqr(za) + sqr(a) * sqr(zb)), -a * b);
}

} // namespace

SphericalRectangle::SphericalRectangle(const V3d& from, const V3d& corner, const V3d& ex, const V3d& ey) {
    const double width = ex.length(), height = ey.length();
    const V3d x = ex / width, y = ey / height, d = corner - from;
    x0_ = d.dot(x);
    y0_ = d.dot(y);
    z0_ = -std::abs(d.dot(x.cross(y)));
    x1_ = x0_ + width;
    y1_ = y0_ + height;
    // Normals of the planes through the edges y = y0, x = x1, y = y1, x = x0 (the paper's n0 to n3): their z, and the
    // rest of their unit length.
    const double edge[4] = {-y0_, x1_, y1_, -x0_};
    double nz[4], nxy[4];
    for (int i = 0; i < 4; ++i) {
        const double length = std::sqrt(sqr(edge[i]) + sqr(z0_));
        nz[i] = length > 0 ? edge[i] / length : 0;
        nxy[i] = length > 0 ? z0_ / length : 0;
    }
    double g[4];
    for (int i = 0; i < 4; ++i)
        g[i] = planeAngle(nz[i], nxy[i], nz[(i + 1) % 4], nxy[(i + 1) % 4]);
    b0_ = nz[0];
    b1_ = nz[2];
    angleSum_ = g[2] + g[3];
    const double excess = g[0] + g[1] + g[2] + g[3] - 2 * piD;
    solidAngle_ = z0_ < 0 && excess > 0 ? excess : 0;
}

V2d SphericalRectangle::sample(const V2f& u) const {
    // Section 3.2: first the x that halves the solid angle as u.x says ...
    const double au = u.x * solidAngle_ - angleSum_;
    const double fu = (std::cos(au) * b0_ - b1_) / std::sin(au);
    const double cu = std::copysign(1 / std::sqrt(sqr(fu) + sqr(b0_)), fu);
    // ... (cu is NaN or beyond 1 by rounding only where x is an edge)
    const double su = std::sqrt(std::max(0., 1 - sqr(cu)));
    const double xu = std::clamp(su > 0 ? -(cu * z0_) / su : std::copysign(infinityD, cu), x0_, x1_);
    // ... then y on that line, on which solid angle goes as the sine of elevation.
    const double distance2 = sqr(xu) + sqr(z0_);
    const double h0 = y0_ / std::sqrt(distance2 + sqr(y0_)), h1 = y1_ / std::sqrt(distance2 + sqr(y1_));
    const double h = h0 + u.y * (h1 - h0);
    const double cosine2 = 1 - sqr(h);
    const double yu = cosine2 > 0 ? std::clamp(h * std::sqrt(distance2 / cosine2), y0_, y1_) : y1_;
    return V2d((xu - x0_) / (x1_ - x0_), (yu - y0_) / (y1_ - y0_));
}

} // namespace vitrine
