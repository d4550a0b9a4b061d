#include "shapes/bilinear.h"

namespace vitrine {

V2d invertBilinear(const V3d& p00, const V3d& p10, const V3d& p01, const V3d& p11, const V3d& normal, const V3d& p) {
    const V3d e = p10 - p00, f = p01 - p00, g = (p11 - p10) - f, q = p - p00;
    // In the plane, q = e u + f v + g u v. Crossed with f + g u: (g x e) u^2 + (q x g - e x f) u + q x f = 0, whose
    // slope at the solution is minus the patch's Jacobian, so that its sign is known.
    const double a = g.cross(e).dot(normal), b = (q.cross(g) - e.cross(f)).dot(normal), c = q.cross(f).dot(normal);
    const double root = std::sqrt(std::max(0., sqr(b) - 4 * a * c));
    const double u = b <= 0 ? 2 * c / (root - b) : -(b + root) / (2 * a);
    V2d result(std::isfinite(u) ? std::clamp(u, 0., 1.) : 0, 0);
    const V3d line = f + g * result.x;
    const double v = (q - e * result.x).dot(line) / line.length2();
    result.y = std::isfinite(v) ? std::clamp(v, 0., 1.) : 0;
    return result;
}

BilinearTexture::BilinearTexture(const V2f& st00, const V2f& st10, const V2f& st01, const V2f& st11, const V2d& at)
    : st_(bilinear(st00, st10, st01, st11, at)), dstdu_(bilinearDu(st00, st10, st01, st11, at)),
      dstdv_(bilinearDv(st00, st10, st01, st11, at)) {
    determinant_ = differenceOfProducts(dstdu_.x, dstdv_.y, dstdu_.y, dstdv_.x);
}

void BilinearTexture::derivatives(const V3d& du, const V3d& dv, V3f& ds, V3f& dt) const {
    if (!(std::abs(determinant_) > 1e-9 * dstdu_.length() * dstdv_.length())) {
        ds = toFloat(du);
        dt = toFloat(dv);
        return;
    }
    ds = toFloat((du * dstdv_.y - dv * dstdu_.y) / determinant_);
    dt = toFloat((dv * dstdu_.x - du * dstdv_.x) / determinant_);
}

void shadeBilinear(const V3f n[4], const V2d& at, const BilinearTexture* texture, SurfacePoint& point) {
    const V3f normal = bilinear(n[0], n[1], n[2], n[3], at);
    const float length = normal.length();
    if (!(length > 0)) return;
    point.ns = normal / length;
    // As in pbrt, given normals say which side is out.
    if (point.ng.dot(point.ns) < 0) point.ng = -point.ng;
    // The derivative of the normalised normal: without the part along it.
    const auto tangential = [&](const V3f& d) { return (d - point.ns * point.ns.dot(d)) / length; };
    point.dndu = tangential(bilinearDu(n[0], n[1], n[2], n[3], at));
    point.dndv = tangential(bilinearDv(n[0], n[1], n[2], n[3], at));
    if (texture) texture->derivatives(toDouble(point.dndu), toDouble(point.dndv), point.dndu, point.dndv);
}

} // namespace vitrine
